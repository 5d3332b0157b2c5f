// SPDX-License-Identifier: Apache-2.0
// Colors of a tile: the visible pixels draw by draw in full vectors.
#include <algorithm>
#include <cstring>

#include "engines/empty_pixel.h"
#include "engines/raster/material_jobs.h"
#include "engines/raster/occlusion/occlusion.h"
#include "engines/raster/shade/channels_tile.h"
#include "engines/raster/shade/sky.h"
#include "image/srgb_encoder.h"
#include "image/tone.h"
#include "math/linear.h"

namespace rakelight::raster {
void find_wanted(const TileJob& job, std::size_t tile, std::size_t count, TileScratch& s) {
    const ScreenTriangle* const* const items = job.binned.items.data() + job.binned.offsets[tile];
    std::fill_n(s.list_position.begin() + std::ptrdiff_t(count), batch_padding, s.list_position[count - 1]);
    const std::int32_t wanted = job.front.kernels.number(s.list_position.data(), std::int32_t(count), s.record.data(),
                                                         s.batch_triangle.data(), s.numbers.data());
    s.wanted.resize(std::size_t(wanted));
    for (std::size_t i = 0; i < s.wanted.size(); ++i) {
        s.wanted[i] = items[s.numbers[i]];
        __builtin_prefetch(s.wanted[i]);
    }
}

DisplayPixels display_pixels(const TileScratch& s) {
    return {s.display.first, std::int64_t(s.display.stride), SrgbEncoder::instance().table()};
}

std::uint32_t display_value(vec4 color) {
    std::uint8_t code[4];
    to_srgb8({&color, 1}, 4, code);
    std::uint32_t packed;
    std::memcpy(&packed, code, sizeof packed);
    return packed;
}

void encode_tile(TileScratch& s) {
    for (std::size_t y = 0; y < tile_size; ++y)
        to_srgb8(std::span(s.color).subspan(y * tile_size, tile_size), 4,
                 {reinterpret_cast<std::uint8_t*>(s.display.first + y * s.display.stride), 4 * tile_size});
}

namespace {

/// Shades `count` pixels of the batch arrays, all of one draw, into the tile.
void shade_batch(const TileJob& job, std::uint32_t draw, std::size_t tile, std::size_t count, bool to_srgb8,
                 TileScratch& s) {
    ShadeJob batch = make_job(job, draw, job.grid.origin_x(tile), job.grid.origin_y(tile), count, s);
    const bool with_normal = (job.front.settings.channels & channel_normal) != 0;
    if (with_normal)
        batch.normal_x = s.normal_x.data(), batch.normal_y = s.normal_y.data(), batch.normal_z = s.normal_z.data();
    if (to_srgb8) batch.display = display_pixels(s);
    if (job.occlusion) job.occlusion->give(batch, s);
    s.not_finite += std::uint64_t(shade_with_lists(job.kernels, job.reach, batch, s));
    s.shaded += count;
    if (!batch.unlit && !batch.lit) s.lit_pixels += count;
    for (std::size_t i = 0; i < count && !to_srgb8; ++i)
        s.color[std::size_t(s.pixel[i])] = {s.red[i], s.green[i], s.blue[i], 1.0f};
    for (std::size_t i = 0; i < count && with_normal; ++i)
        s.normal[std::size_t(s.pixel[i])] = {s.normal_x[i], s.normal_y[i], s.normal_z[i]};
    if (job.front.settings.channels & further_channels) fill_channels(job, batch, draw, s);
}

void shade_draw(const TileJob& job, std::size_t tile, std::uint32_t draw, std::size_t count, bool to_srgb8,
                TileScratch& s) {
    if (count == 0) return;
    s.covered += count;
    s.samples_covered += count;
    find_wanted(job, tile, count, s);
    make_records(job, draw, s.wanted, job.grid.origin_x(tile), job.grid.origin_y(tile), s);
    shade_batch(job, draw, tile, count, to_srgb8, s);
    const std::uint32_t channels = job.front.settings.channels;
    const Draw& d = job.front.list.draws[draw];
    const std::uint32_t material = job.front.list.materials[d.material].scene_material;
    for (std::size_t i = 0; i < count && (channels & channel_object); ++i) s.object[std::size_t(s.pixel[i])] = d.node;
    for (std::size_t i = 0; i < count && (channels & channel_material); ++i)
        s.material[std::size_t(s.pixel[i])] = material;
}

constexpr std::size_t most_passes =
    24;  ///< over the tile, one per draw; where there are more draws its pixels are sorted

/// As a pass for each draw, in one.
void shade_sorted(const TileJob& job, std::size_t tile, const std::vector<DrawRun>& runs, bool to_srgb8,
                  TileScratch& s) {
    s.sorted.resize(tile_pixels + batch_padding);
    const auto count = std::size_t(
        job.front.kernels.collect(s.visible.data(), 0, runs.back().end, s.sorted.data(), s.list_position.data()));
    const auto run_of = [&](std::int32_t pixel) {
        return std::partition_point(runs.begin(), runs.end(),
                                    [&](const DrawRun& r) { return r.end <= s.visible[std::size_t(pixel)]; });
    };
    const auto begin = s.sorted.begin(), end = begin + std::ptrdiff_t(count);
    std::stable_sort(begin, end, [&](std::int32_t a, std::int32_t b) { return run_of(a) < run_of(b); });
    for (auto at = begin; at != end;) {
        const auto run = run_of(*at);
        const auto next =
            std::partition_point(at, end, [&](std::int32_t pixel) { return s.visible[std::size_t(pixel)] < run->end; });
        std::copy(at, next, s.pixel.begin());
        std::transform(at, next, s.list_position.begin(),
                       [&](std::int32_t pixel) { return s.visible[std::size_t(pixel)]; });
        shade_draw(job, tile, run->draw, std::size_t(next - at), to_srgb8, s);
        at = next;
    }
}

void set_background(const TileJob& job, std::size_t tile, bool to_srgb8, TileScratch& s) {
    const RenderSettings& settings = job.front.settings;
    if (has_sky(job.front.list)) {
        if (to_srgb8)
            put_sky(job, tile, s.visible.data(), s);
        else
            fill_sky(job, tile, s.color, s);
    } else if (to_srgb8) {
        job.front.kernels.fill_empty(s.visible.data(), display_value(empty_pixel(settings)), s.display.first,
                                     std::int64_t(s.display.stride));
    } else {
        std::fill(s.color.begin(), s.color.end(), empty_pixel(settings));
    }
    if (settings.channels & channel_normal) std::fill(s.normal.begin(), s.normal.end(), vec3{});
    if (settings.channels & channel_object) std::fill(s.object.begin(), s.object.end(), no_index);
    if (settings.channels & channel_material) std::fill(s.material.begin(), s.material.end(), no_index);
    if (settings.channels & further_channels) clear_channels(settings.channels, s);
}

}  // namespace

void set_ray(const PictureCamera& view, int tile_x, int tile_y, float (&ray)[3][3]) {
    const shading::PixelRays rays = shading::pixel_rays(view, tile_x, tile_y);
    for (std::size_t c = 0; c < 3; ++c) {
        ray[c][0] = float(rays.along_x[c]);
        ray[c][1] = float(rays.along_y[c]);
        ray[c][2] = float(rays.first[c]);
    }
}

void find_runs(const TileJob& job, std::size_t tile, std::vector<DrawRun>& runs) {
    runs.clear();
    const std::uint32_t first = job.binned.offsets[tile];
    for (std::uint32_t r = job.binned.run_offsets[tile]; r < job.binned.run_offsets[tile + 1]; ++r) {
        const TileRun& run = job.binned.runs[r];
        runs.push_back({std::int32_t(run.first - first), std::int32_t(run.first - first + run.count), run.draw});
    }
}

bool has_blended(const TileJob& job, const std::vector<DrawRun>& runs) {
    return job.has_blended && std::any_of(runs.begin(), runs.end(),
                                          [&](const DrawRun& r) { return job.front.list.view(r.draw).blend != 0; });
}

ShadeJob make_job(const TileJob& job, std::uint32_t draw, int tile_x, int tile_y, std::size_t count, TileScratch& s) {
    ShadeJob out = draw_job(job.front, job.lights, draw);
    set_ray(job.front.view, tile_x, tile_y, out.ray);
    out.count = std::int32_t(count);
    for (std::size_t i = 0; i < batch_padding; ++i) {  // dead lanes repeat the last pixel
        s.pixel[count + i] = s.pixel[count - 1];
        s.batch_triangle[count + i] = s.batch_triangle[count - 1];
    }
    out.pixel = s.pixel.data();
    out.triangle = s.batch_triangle.data();
    out.triangles = s.triangles.data();
    if (is_lit_at_corners(job.front, draw)) out.lit = s.lit.data();
    if (wants_corner_frames(job.front, draw)) out.frames = s.frames.data();
    out.red = s.red.data();
    out.green = s.green.data();
    out.blue = s.blue.data();
    out.alpha = s.alpha.data();
    return out;
}

bool shade_opaque(const TileJob& job, std::size_t tile, TileScratch& s) {
    if (job.occlusion) job.occlusion->find(job, tile, s);
    std::vector<DrawRun> runs;
    find_runs(job, tile, runs);
    const bool blends = has_blended(job, runs) || has_marks(job, tile), direct = job.to_srgb8 && !blends;
    set_background(job, tile, direct, s);
    s.record.assign(job.binned.offsets[tile + 1] - job.binned.offsets[tile], -1);
    if (runs.size() > most_passes)
        shade_sorted(job, tile, runs, direct, s);
    else
        for (const DrawRun& run : runs)
            shade_draw(job, tile, run.draw,
                       std::size_t(job.front.kernels.collect(s.visible.data(), run.begin, run.end, s.pixel.data(),
                                                             s.list_position.data())),
                       direct, s);
    return blends;
}

}  // namespace rakelight::raster
