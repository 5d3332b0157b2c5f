// SPDX-License-Identifier: Apache-2.0
// Data channels of a tile beyond depth, normal, object and material. Plain pictures never come here.
#include <array>
#include <utility>

#include "engines/channel_arrays.h"
#include "engines/raster/material_jobs.h"
#include "engines/raster/shade/channels_tile.h"
#include "engines/raster/visibility/coverage.h"
#include "math/linear.h"

namespace rakelight::raster {
namespace {

struct KernelChannel {
    std::uint32_t bit;
    std::int32_t plane, components;
};

constexpr std::array kernel_channels{KernelChannel{channel_position, plane_position, 3},
                                     KernelChannel{channel_barycentric, plane_barycentric, 3},
                                     KernelChannel{channel_uv, plane_uv, 2},
                                     KernelChannel{channel_uv1, plane_uv1, 2},
                                     KernelChannel{channel_tangent, plane_tangent, 4},
                                     KernelChannel{channel_base_color, plane_base_color, 3},
                                     KernelChannel{channel_ambient, plane_ambient, 3},
                                     KernelChannel{channel_diffuse, plane_diffuse, 3},
                                     KernelChannel{channel_specular, plane_specular, 3},
                                     KernelChannel{channel_emission, plane_emission, 3}};

const float* plane_of(const TileScratch& s, std::int32_t plane) {
    return s.channel_values.data() + std::size_t(plane) * (tile_pixels + batch_padding);
}

/// From planes of the batch to pixels of the tile.
template <class Vector>
void scatter(const TileScratch& s, std::int32_t plane, std::size_t components, std::size_t count,
             std::vector<Vector>& to) {
    for (std::size_t c = 0; c < components; ++c) {
        const float* const from = plane_of(s, plane + std::int32_t(c));
        for (std::size_t i = 0; i < count; ++i) to[std::size_t(s.pixel[i])][c] = from[i];
    }
}

void run_kernel(const TileJob& job, const ShadeJob& batch, TileScratch& s) {
    const std::uint32_t channels = job.front.settings.channels;
    s.channel_values.resize(std::size_t(channel_planes) * (tile_pixels + batch_padding));
    ChannelJob kernel_job{};
    kernel_job.shade = &batch;
    kernel_job.needs_terms = (channels & channels_lighting) != 0;
    for (const KernelChannel& k : kernel_channels)
        for (std::int32_t c = 0; (channels & k.bit) && c < k.components; ++c)
            kernel_job.out[k.plane + c] = const_cast<float*>(plane_of(s, k.plane + c));
    job.kernels.channels(&kernel_job);
}

/// What the kernel made, into the tile. Positions leave the eye in double.
void take_values(const TileJob& job, std::size_t count, TileScratch& s) {
    for_each_channel(
        [&](std::uint32_t bit, auto& array) {
            using Value = std::remove_reference_t<decltype(array[0])>;
            if constexpr (!std::is_arithmetic_v<Value>)
                for (const KernelChannel& k : kernel_channels)
                    if (k.bit == bit && (job.front.settings.channels & bit))
                        scatter(s, k.plane, std::size_t(k.components), count, array);
        },
        static_cast<ChannelArrays&>(s));
    if (!(job.front.settings.channels & channel_position)) return;
    const dvec3 eye = job.front.view.camera_to_world[3].xyz();
    for (std::size_t i = 0; i < count; ++i) {
        vec3& p = s.position[std::size_t(s.pixel[i])];
        p = {float(eye.x + double(p.x)), float(eye.y + double(p.y)), float(eye.z + double(p.z))};
    }
}

void take_numbers(const TileJob& job, std::uint32_t draw, std::size_t count, TileScratch& s) {
    const std::uint32_t channels = job.front.settings.channels;
    const std::uint32_t mesh = job.front.list.draws[draw].mesh;
    for (std::size_t i = 0; i < count && (channels & channel_mesh); ++i) s.mesh[std::size_t(s.pixel[i])] = mesh;
    for (std::size_t i = 0; i < count && (channels & channel_triangle); ++i)
        static_cast<ChannelArrays&>(s).triangle[std::size_t(s.pixel[i])] =
            s.wanted[std::size_t(s.batch_triangle[i])]->triangle;
    if (!(channels & channel_face_normal)) return;
    const DrawFrame frame = frame_of(job.front, draw);
    std::vector<vec3> normals;
    for (const ScreenTriangle* t : s.wanted) normals.push_back(cast<float>(frame.face(t->triangle).normal));
    for (std::size_t i = 0; i < count; ++i)
        s.face_normal[std::size_t(s.pixel[i])] = normals[std::size_t(s.batch_triangle[i])];
}

/// The covered pixels of a masked triangle where its texture is opaque.
void count_masked(const TileJob& job, const ScreenTriangle& t, std::size_t count, int ox, int oy, TileScratch& s) {
    if (count == 0) return;
    const ScreenTriangle* const only = &t;
    make_records(job, t.draw, {&only, 1}, ox, oy, s);
    const ShadeJob batch = make_job(job, t.draw, ox, oy, count, s);
    job.kernels.alpha(&batch);
    const float cutoff = mask_cutoff(job.front, t.draw);
    for (std::size_t i = 0; i < count; ++i) s.overdraw[std::size_t(s.pixel[i])] += s.alpha[i] >= cutoff;
}

}  // namespace

void clear_channels(std::uint32_t channels, TileScratch& s) {
    for_each_channel(
        [&](std::uint32_t bit, auto& array) {
            if (bit & further_channels) array.assign(channels & bit ? tile_pixels : 0, empty_value(bit, array));
        },
        static_cast<ChannelArrays&>(s));
}

void fill_channels(const TileJob& job, const ShadeJob& batch, std::uint32_t draw, TileScratch& s) {
    const auto count = std::size_t(batch.count);
    run_kernel(job, batch, s);
    take_values(job, count, s);
    take_numbers(job, draw, count, s);
}

void count_overdraw(const TileJob& job, std::size_t tile, TileScratch& s) {
    const Window area = job.grid.pixels(tile);
    const int ox = job.grid.origin_x(tile), oy = job.grid.origin_y(tile);
    for (std::uint32_t i = job.binned.offsets[tile]; i < job.binned.offsets[tile + 1] && !job.is_cancelled(); ++i) {
        const ScreenTriangle& t = *job.binned.items[i];
        const MaterialView& material = job.front.list.view(t.draw);
        if (material.blend) continue;
        const bool is_masked = mask_cutoff(job.front, t.draw) >= 0;
        std::size_t count = 0;
        cover(t, area, ox, oy, [&](int x, int y, float) {
            const std::int32_t pixel = y * tile_size + x;
            if (!is_masked) {
                ++s.overdraw[std::size_t(pixel)];
                return;
            }
            s.pixel[count] = pixel;
            s.batch_triangle[count++] = 0;
        });
        if (is_masked) count_masked(job, t, count, ox, oy, s);
    }
}

}  // namespace rakelight::raster
