// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/trace_tile.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "cpu_shading/kernel_channels.h"
#include "shading/sample_positions.h"

namespace rakelight::raytrace {
namespace {

constexpr float step_behind = 1 + 4e-6f;  ///< where a ray goes on behind what it met

float* plane(TileScratch& s, std::int32_t number) { return s.planes.data() + std::size_t(number) * plane_stride; }
vec3 vector_of(const TileScratch& s, std::int32_t number, std::size_t ray) {
    const float* const p = s.planes.data() + std::size_t(number) * plane_stride + ray;
    return {p[0], p[plane_stride], p[2 * plane_stride]};
}
/// The same vector for all rays.
void fill(TileScratch& s, std::int32_t number, std::size_t count, dvec3 v) {
    for (std::size_t c = 0; c < 3; ++c) std::fill_n(plane(s, number + std::int32_t(c)), count, float(v[c]));
}

/// A ray through a place of every pixel.
void make_primary(const TracePicture& picture, const Window& area, shading::SamplePosition at, TileScratch& s) {
    const shading::View& view = picture.view;
    const shading::PixelRays rays = shading::pixel_rays(view, area.x, area.y);
    const std::size_t count = std::size_t(area.width) * std::size_t(area.height);
    const dvec3 none{}, ahead = -view.camera_to_world[2].xyz();
    fill(s, view.orthographic ? ray_d : ray_o, count, view.orthographic ? ahead : none);
    fill(s, ray_o_dx, count, view.orthographic ? rays.along_x : none);
    fill(s, ray_o_dy, count, view.orthographic ? rays.along_y : none);
    fill(s, ray_d_dx, count, view.orthographic ? none : rays.along_x);
    fill(s, ray_d_dy, count, view.orthographic ? none : rays.along_y);
    for (std::size_t c = 0; c < 3; ++c) {
        float* to = plane(s, (view.orthographic ? ray_o : ray_d) + std::int32_t(c));
        for (int y = 0; y < area.height; ++y) {
            const double row = rays.along_y[c] * (y + at.y / 16.0) + rays.first[c] + rays.along_x[c] * (at.x / 16.0);
            for (int x = 0; x < area.width; ++x) *to++ = float(row + rays.along_x[c] * x);
        }
    }
}

/// What a camera sees: sides that are not culled, where masks leave something.
class SeenFilter final : public RayFilter {
public:
    SeenFilter(const TracePicture& picture, const TileScratch& s, std::size_t ray, bool with_blended)
        : picture_(picture),
          planes_{s.planes.data(), plane_stride},
          ray_(std::int32_t(ray)),
          with_blended_(with_blended) {}
    bool counts(const Meeting& meeting, bool is_against) const override {
        if (picture_.is_culled(meeting.draw, is_against)) return false;
        if (!with_blended_ && picture_.is_blended(meeting.draw)) return false;
        return !picture_.is_masked(meeting.draw) || !picture_.is_cut_out(meeting, planes_, ray_);
    }

private:
    const TracePicture& picture_;
    RayView planes_;
    std::int32_t ray_;
    bool with_blended_;
};

Meeting find_first(const TracePicture& picture, const TileScratch& s, std::size_t ray, bool with_blended) {
    const SeenFilter filter(picture, s, ray, with_blended);
    const bool needs_filter = picture.has_filtered || (!with_blended && picture.has_holes);
    return picture.rays.first(picture.in_rays(vector_of(s, ray_o, ray)), vector_of(s, ray_d, ray), s.from[ray],
                              float(picture.view.z_far), needs_filter ? &filter : nullptr);
}

void pad(std::vector<std::int32_t>& v, std::size_t count) {
    v.resize(count + batch_padding);
    std::fill(v.begin() + std::ptrdiff_t(count), v.end(), v[count - 1]);
}

/// The hits of one draw: rays `begin` to `end` of the order, into hit_ray and hit_triangle.
HitJob hits_of_run(const TracePicture& picture, std::size_t begin, std::size_t end, TileScratch& s) {
    const std::size_t count = end - begin;
    s.hit_ray.assign(s.order.begin() + std::ptrdiff_t(begin), s.order.begin() + std::ptrdiff_t(end));
    s.hit_triangle.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        s.hit_triangle[i] = std::int32_t(s.meetings[std::size_t(s.hit_ray[i])].triangle);
    pad(s.hit_ray, count), pad(s.hit_triangle, count);
    HitJob job = picture.hit_job(s.meetings[std::size_t(s.order[begin])].draw);
    job.count = std::int32_t(count);
    job.ray = s.hit_ray.data(), job.triangle = s.hit_triangle.data();
    job.rays = {s.planes.data(), std::int32_t(plane_stride)};
    return job;
}

/// Calls run(begin, end) for the hits of each draw.
template <class Run>
void for_each_run(TileScratch& s, const Run& run) {
    const auto draw_of = [&](std::int32_t ray) { return s.meetings[std::size_t(ray)].draw; };
    if (!std::ranges::is_sorted(s.order, {}, draw_of)) std::ranges::stable_sort(s.order, {}, draw_of);
    for (std::size_t begin = 0; begin < s.order.size();) {
        std::size_t end = begin + 1;
        while (end < s.order.size() && draw_of(s.order[end]) == draw_of(s.order[begin])) ++end;
        run(begin, end);
        begin = end;
    }
}

/// Lights the hits of one draw.
void shade_run(const TracePicture& picture, std::size_t begin, std::size_t end, TileScratch& s) {
    const std::uint32_t draw = s.meetings[std::size_t(s.order[begin])].draw;
    const std::size_t count = end - begin;
    HitJob job = hits_of_run(picture, begin, end, s);
    job.red = s.red.data(), job.green = s.green.data(), job.blue = s.blue.data(), job.alpha = s.alpha.data();
    s.counts.not_finite += std::uint64_t(picture.kernels.shade(&job));
    s.counts.shaded += count;
    const bool is_blended = picture.is_blended(draw);
    for (std::size_t i = 0; i < count; ++i) {
        const auto ray = std::size_t(s.hit_ray[i]);
        const bool is_finite = s.alpha[i] - s.alpha[i] == 0;
        const float alpha = !is_blended ? 1.0f : is_finite ? std::clamp(s.alpha[i], 0.0f, 1.0f) : 0.0f;
        s.sum[ray] = s.sum[ray] + vec3{s.red[i], s.green[i], s.blue[i]} * (s.rest[ray] * alpha);
        s.rest[ray] *= 1 - alpha;
        if (!is_blended || s.rest[ray] <= 0) continue;
        s.from[ray] = s.meetings[ray].t * step_behind;
        s.live.push_back(std::int32_t(ray));
    }
}

/// Follows the rays that live until they meet something opaque, or nothing.
void follow(const TracePicture& picture, const Context& context, TileScratch& s) {
    while (!s.live.empty() && !context.cancelled()) {
        s.order.clear();
        s.live.swap(s.going);
        s.live.clear();
        for (const std::int32_t ray : s.going) {
            s.meetings[std::size_t(ray)] = find_first(picture, s, std::size_t(ray), true);
            if (s.meetings[std::size_t(ray)].draw != no_index) s.order.push_back(ray);
        }
        for_each_run(s, [&](std::size_t begin, std::size_t end) { shade_run(picture, begin, end, s); });
    }
}

/// What is behind everything.
void lay_background(const TracePicture& picture, std::size_t count, std::vector<vec4>& to, TileScratch& s) {
    const vec4 behind = picture.settings.background;
    const bool has_sky = picture.list.views.environment && picture.list.scene.environment->is_background;
    if (has_sky) {
        SkyJob job{std::int32_t(count),
                   {s.planes.data(), std::int32_t(plane_stride)},
                   &picture.list.views.environment_view,
                   picture.view.orthographic,
                   s.red.data(),
                   s.green.data(),
                   s.blue.data()};
        picture.kernels.sky(&job);
    }
    for (std::size_t i = 0; i < count; ++i) {
        const vec4 own = has_sky ? vec4{s.red[i], s.green[i], s.blue[i], 1} : behind;
        const float share = s.rest[i] * own.w, alpha = 1 - s.rest[i] + share;
        const vec3 sum = s.sum[i] + own.xyz() * share;
        const vec3 color = alpha > 0 ? sum * (1 / alpha) : own.xyz();
        to[i] = {color.x, color.y, color.z, alpha};
    }
}

void trace_sample(const TracePicture& picture, const Window& area, shading::SamplePosition at, const Context& context,
                  std::vector<vec4>& to, TileScratch& s) {
    const std::size_t count = std::size_t(area.width) * std::size_t(area.height);
    make_primary(picture, area, at, s);
    s.live.resize(count);
    for (std::size_t i = 0; i < count; ++i) s.live[i] = std::int32_t(i);
    s.from.assign(count, float(picture.view.z_near));
    s.sum.assign(count, vec3{}), s.rest.assign(count, 1.0f);
    s.meetings.assign(count, Meeting{});
    follow(picture, context, s);
    lay_background(picture, count, to, s);
}

/// The numbers of a hit, into its pixel.
void take_numbers(const TracePicture& picture, std::size_t pixel, const Meeting& m, TileScratch& s) {
    const shading::Draw& draw = picture.list.draws[m.draw];
    s.object[pixel] = draw.node, s.mesh[pixel] = draw.mesh, s.triangle[pixel] = m.triangle;
    s.material[pixel] = picture.list.material(draw).scene_material;
}

/// What kernels give of the hits of one draw, into their pixels.
void take_values(const TracePicture& picture, std::size_t begin, std::size_t end, TileScratch& s) {
    constexpr std::size_t stride = tile_pixels + batch_padding;
    const std::uint32_t channels = picture.settings.channels;
    const HitJob hits = hits_of_run(picture, begin, end, s);
    s.channel_values.resize(std::size_t(cpu_shading::channel_planes) * stride);
    ChannelJob job{};
    static_cast<cpu_shading::ChannelValues&>(job) =
        cpu_shading::channel_values(channels, s.channel_values.data(), stride);
    job.hits = &hits;
    std::vector<float> own(7 * stride);
    for (std::size_t c = 0; c < 3; ++c)
        job.normal[c] = own.data() + c * stride, job.face_normal[c] = own.data() + (3 + c) * stride;
    job.depth = own.data() + 6 * stride;
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

/// Opaque surfaces behind the first one, which is known.
std::uint32_t count_behind(const TracePicture& picture, std::size_t ray, const Meeting& first, TileScratch& s) {
    std::uint32_t count = 0;
    for (Meeting m = first; m.draw != no_index; ++count) {
        s.from[ray] = m.t * step_behind;
        m = find_first(picture, s, ray, false);
    }
    return count - 1;
}

/// Data of the nearest opaque surface at the pixels' centers.
void find_data(const TracePicture& picture, const Window& area, TileScratch& s) {
    const std::size_t count = std::size_t(area.width) * std::size_t(area.height);
    make_primary(picture, area, {0, 0}, s);
    s.from.assign(count, float(picture.view.z_near));
    for_each_channel([&](std::uint32_t bit, auto& array) { array.assign(count, empty_value(bit, array)); },
                     static_cast<ChannelArrays&>(s));
    s.order.clear();
    for (std::size_t i = 0; i < count; ++i) {
        s.meetings[i] = find_first(picture, s, i, false);
        if (s.meetings[i].draw == no_index) continue;
        s.order.push_back(std::int32_t(i));
        take_numbers(picture, i, s.meetings[i], s);
        if (picture.settings.channels & channel_overdraw)
            s.overdraw[i] = 1 + count_behind(picture, i, s.meetings[i], s);
    }
    for_each_run(s, [&](std::size_t begin, std::size_t end) { take_values(picture, begin, end, s); });
}

}  // namespace

void trace_tile(const TracePicture& picture, const Window& area, const Context& context, TileScratch& s) {
    const std::size_t count = std::size_t(area.width) * std::size_t(area.height);
    s.planes.resize(std::size_t(ray_planes) * plane_stride);
    for (auto* const numbers : {&s.red, &s.green, &s.blue, &s.alpha}) numbers->resize(tile_pixels + batch_padding);
    s.color.resize(count);
    const auto positions = shading::sample_positions(picture.settings.samples);
    if (positions.size() == 1) {
        trace_sample(picture, area, positions[0], context, s.color, s);
    } else {
        s.sample_colors.assign(count * positions.size(), vec4{});
        for (std::size_t k = 0; k < positions.size(); ++k) {
            trace_sample(picture, area, positions[k], context, s.color, s);
            for (std::size_t i = 0; i < count; ++i) s.sample_colors[i * positions.size() + k] = s.color[i];
        }
        for (std::size_t i = 0; i < count; ++i)
            s.color[i] = shading::mean_of_samples(s.sample_colors.data() + i * positions.size(), positions.size());
    }
    if (picture.settings.channels != 0) find_data(picture, area, s);
}

}  // namespace rakelight::raytrace
