// SPDX-License-Identifier: Apache-2.0
// Data channels of a tile beyond depth, normal, object and material. Plain pictures never come here.
#include "engines/raster/shade/channels_tile.h"
#include "cpu_shading/kernel_channels.h"
#include "engines/raster/material_jobs.h"
#include "engines/raster/visibility/coverage.h"
#include "math/linear.h"

namespace rakelight::raster {
namespace {

constexpr std::size_t stride = tile_pixels + batch_padding;  ///< of the planes of channel_values

void run_kernel(const TileJob& job, const ShadeJob& batch, TileScratch& s) {
    s.channel_values.resize(std::size_t(cpu_shading::channel_planes) * stride);
    ChannelJob kernel_job{};
    static_cast<cpu_shading::ChannelValues&>(kernel_job) =
        cpu_shading::channel_values(job.front.settings.channels, s.channel_values.data(), stride);
    kernel_job.shade = &batch;
    job.kernels.channels(&kernel_job);
}

/// What the kernel made, into the tile.
void take_values(const TileJob& job, std::size_t count, TileScratch& s) {
    cpu_shading::take_channels(
        job.front.settings.channels, s.channel_values.data(), stride, count, job.front.view.camera_to_world[3].xyz(),
        [&s](std::size_t i) { return std::size_t(s.pixel[i]); }, s);
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
