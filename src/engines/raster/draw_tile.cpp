// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/draw_tile.h"

#include "engines/channel_arrays.h"
#include "engines/raster/multisample.h"
#include "engines/raster/shade/blend_tile.h"
#include "engines/raster/shade/channels_tile.h"
#include "engines/raster/shade/shade_tile.h"
#include "engines/raster/shadows/shadow_texels.h"

namespace rakelight::raster {
namespace {

/// The rows of a whole tile that are in the window; a tile entirely inside is passed on unchanged.
template <class T>
std::span<const T> part(const std::vector<T>& whole, const Window& in_tile, std::vector<T>& copy) {
    if (in_tile.width == tile_size)
        return std::span(whole).subspan(std::size_t(in_tile.y * tile_size), std::size_t(in_tile.height * tile_size));
    for (int y = in_tile.y; y < in_tile.y + in_tile.height; ++y) {
        const auto row = whole.begin() + y * tile_size + in_tile.x;
        copy.insert(copy.end(), row, row + in_tile.width);
    }
    return copy;
}

void deliver(const TileJob& job, std::size_t tile, TileScratch& s, Sink& sink) {
    const Window area = job.grid.pixels(tile);
    const Window in_tile = {area.x - job.grid.origin_x(tile), area.y - job.grid.origin_y(tile), area.width,
                            area.height};
    const std::uint32_t channels = job.front.settings.channels;
    if (channels & channel_depth)
        for (float& key : s.depth) key = float(job.front.view.distance_of(double(key)));
    std::vector<vec4> color;
    Tile result{.area = area};
    if (!job.to_srgb8) result.color = part(s.color, in_tile, color);
    ChannelArrays copies;
    for_each_channel(
        [&](std::uint32_t bit, auto& to, const auto& whole, auto& copy) {
            if (channels & bit) to = part(whole, in_tile, copy);
        },
        result, static_cast<const ChannelArrays&>(s), copies);
    if (!job.to_srgb8) return sink.tile(result);
    std::vector<std::uint32_t> srgb8;
    const bool is_in_sink = s.display.first != s.srgb8.data();
    sink.display_tile(result, is_in_sink ? std::span<const std::uint32_t>() : part(s.srgb8, in_tile, srgb8));
}

/// Where the tile's display values are made: in the sink, if it has room for the whole tile.
DisplayRows display_of(const TileJob& job, const Window& area, TileScratch& s, Sink& sink) {
    DisplayRows rows;
    if (job.to_srgb8 && area.width == tile_size && area.height == tile_size) rows = sink.display_rows(area);
    return rows.first ? rows : DisplayRows{s.srgb8.data(), tile_size};
}

}  // namespace

void draw_tile(const TileJob& job, std::size_t tile, TileScratch& scratch, Sink& sink) {
    StageClock clock;
    scratch.display = display_of(job, job.grid.pixels(tile), scratch, sink);
    const bool is_sampled = job.front.settings.samples > 1;
    if (job.reach)
        job.reach->in_square(job.front.view, job.grid.origin_x(tile), job.grid.origin_y(tile), tile_size,
                             scratch.tile_lights);
    if (is_sampled)
        find_visible_samples(job, tile, scratch);
    else
        find_visible(job, tile, scratch);
    scratch.times.visibility += clock.lap();
    if (job.is_cancelled()) return;
    if (job.shadow_texels) job.shadow_texels->take(job, tile, scratch);
    bool blends = false;
    if (is_sampled) {
        shade_samples(job, tile, scratch);
    } else {
        blends = shade_opaque(job, tile, scratch);
        if (job.front.settings.channels & channel_overdraw) count_overdraw(job, tile, scratch);
    }
    scratch.times.shading += clock.lap();
    if (is_sampled) finish_samples(job, tile, scratch);
    if (blends) blend_transparent(job, tile, scratch);
    scratch.times.blending += clock.lap();
    if (job.is_cancelled()) return;  // cut short
    deliver(job, tile, scratch, sink);
    scratch.times.delivery += clock.lap();
}

}  // namespace rakelight::raster
