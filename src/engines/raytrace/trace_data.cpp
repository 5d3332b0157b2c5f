// SPDX-License-Identifier: Apache-2.0
// Data channels of a tile.
#include <algorithm>
#include <utility>

#include "cpu_shading/kernel_channels.h"
#include "engines/raytrace/trace_tile.h"

namespace rakelight::raytrace {
namespace {

/// The numbers of a hit, into its pixel.
void take_numbers(const TracePicture& picture, std::size_t pixel, const Meeting& m, TileScratch& s) {
    const bool is_mark = picture.is_mark(m.draw);
    const shading::Draw& draw = is_mark ? picture.mark_draw(m) : picture.list.draws[m.draw];
    const std::uint32_t channels = picture.settings.channels;
    if (channels & channel_object) s.object[pixel] = draw.node;
    if (channels & channel_mesh) s.mesh[pixel] = draw.mesh;
    if ((channels & channel_triangle) && !is_mark) s.triangle[pixel] = m.triangle;
    if (channels & channel_material) s.material[pixel] = picture.list.material(draw).scene_material;
}

/// What kernels give of the hits of one draw, into their pixels.
void take_values(const TracePicture& picture, const Context& context, std::size_t begin, std::size_t end,
                 TileScratch& s) {
    constexpr std::size_t stride = tile_pixels + batch_padding;
    const std::uint32_t channels = picture.settings.channels;
    HitJob hits = picture.hit_job(s.meetings[std::size_t(s.order[begin])].draw);
    set_hits(begin, end, s, hits);
    const TileTracer tracer = tracer_of(picture, context, s);
    hits.tracer = &tracer;
    s.channel_values.resize(std::size_t(cpu_shading::channel_planes) * stride);
    ChannelJob job{};
    static_cast<cpu_shading::ChannelValues&>(job) =
        cpu_shading::channel_values(channels, s.channel_values.data(), stride);
    job.hits = &hits;
    // Channels that need only the hit's position are cheap; those that need the material's kernels are not.
    constexpr std::uint32_t own_channels = channel_depth | channel_normal | channel_object | channel_material |
                                           channel_mesh | channel_triangle | channel_face_normal | channel_overdraw;
    job.needs_values = (channels & ~own_channels) != 0;
    s.own_values.resize(7 * stride);
    for (std::size_t c = 0; c < 3; ++c) {
        if (channels & channel_normal) job.normal[c] = s.own_values.data() + c * stride;
        if (channels & channel_face_normal) job.face_normal[c] = s.own_values.data() + (3 + c) * stride;
    }
    job.depth = s.own_values.data() + 6 * stride;
    picture.kernels.channels(&job);
    const auto pixel_of = [&s](std::size_t i) { return std::size_t(s.hit_ray[i]); };
    cpu_shading::take_channels(channels, s.channel_values.data(), stride, end - begin,
                               picture.view.camera_to_world[3].xyz(), pixel_of, s);
    for (std::size_t i = 0; i < end - begin; ++i) {
        const std::size_t pixel = pixel_of(i);
        if (channels & channel_depth) s.depth[pixel] = job.depth[i];
        if (channels & channel_normal) s.normal[pixel] = {job.normal[0][i], job.normal[1][i], job.normal[2][i]};
        if (channels & channel_face_normal)
            s.face_normal[pixel] = {job.face_normal[0][i], job.face_normal[1][i], job.face_normal[2][i]};
    }
}

/// A mark has no triangle, normal or texture coordinates, and is not lit.
void take_mark(const TracePicture& picture, std::size_t pixel, const Meeting& m, TileScratch& s) {
    const std::uint32_t channels = picture.settings.channels;
    const vec3 color = picture.mark_color(m).xyz();
    const dvec3 place =
        cast<double>(s.wave.vector(ray_o, pixel)) + cast<double>(s.wave.vector(ray_d, pixel)) * double(m.t);
    if (channels & channel_depth) s.depth[pixel] = m.t;
    if (channels & channel_base_color) s.base_color[pixel] = color;
    if (channels & channel_emission) s.emission[pixel] = color;
    if (channels & channel_position) s.position[pixel] = cast<float>(place + picture.view.camera_to_world[3].xyz());
}

/// Opaque surfaces on a ray; none is a line or point.
std::uint32_t count_surfaces(const TracePicture& picture, std::size_t ray, Meeting first, TileScratch& s) {
    if (picture.is_mark(first.draw)) first = find_surface(picture, s, ray, false);
    std::uint32_t count = 0;
    for (; first.draw != no_index; ++count) {
        s.from[ray] = first.t * step_behind;
        first = find_surface(picture, s, ray, false);
    }
    return count;
}

}  // namespace

void find_data(const TracePicture& picture, const Window& area, const Context& context, TileScratch& s) {
    const std::size_t count = std::size_t(area.width) * std::size_t(area.height);
    make_primary(picture, area, {0, 0}, s);
    begin_rays(picture, float(picture.view.z_near), s);
    s.meetings.resize(count);
    for_each_channel(
        [&](std::uint32_t bit, auto& array) {
            if (picture.settings.channels & bit) array.assign(count, empty_value(bit, array));
        },
        static_cast<ChannelArrays&>(s));
    s.order.clear();
    for (std::size_t i = 0; i < count && !context.cancelled(); ++i) {
        s.meetings[i] = find_first(picture, s, i, false);
        if (s.meetings[i].draw == no_index) continue;
        take_numbers(picture, i, s.meetings[i], s);
        if (picture.is_mark(s.meetings[i].draw))
            take_mark(picture, i, s.meetings[i], s);
        else
            s.order.push_back(std::int32_t(i));
    }
    if (picture.settings.channels & channel_overdraw)
        for (std::size_t i = 0; i < count && !context.cancelled(); ++i)
            s.overdraw[i] = count_surfaces(picture, i, s.meetings[i], s);
    for_each_run(s, [&](std::size_t begin, std::size_t end) { take_values(picture, context, begin, end, s); });
    std::swap(s.wave, s.primary);
}

}  // namespace rakelight::raytrace
