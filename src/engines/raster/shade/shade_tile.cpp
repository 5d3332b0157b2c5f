// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/shade/shade_tile.h"

#include <algorithm>

#include "engines/empty_pixel.h"
#include "engines/raster/material_jobs.h"
#include "engines/raster/occlusion/occlusion.h"
#include "engines/raster/shade/channels_tile.h"
#include "engines/raster/shade/sky.h"

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
