// SPDX-License-Identifier: Apache-2.0
// The tiles of a rectangle of pixels.
#pragma once
#include <algorithm>
#include <atomic>

#include <rakelight/base/context.h>

#include "engines/raytrace/trace_tile.h"

namespace rakelight::raytrace {

struct TileGrid {
    Window of;
    int columns, rows;
    explicit TileGrid(const Window& window)
        : of(window),
          columns((window.width + tile_size - 1) / tile_size),
          rows((window.height + tile_size - 1) / tile_size) {}
    std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
    Window at(std::size_t number) const {
        const int x = int(number) % columns * tile_size, y = int(number) / columns * tile_size;
        return {of.x + x, of.y + y, std::min(tile_size, of.width - x), std::min(tile_size, of.height - y)};
    }
};

/// On all threads, until cancelled. @param work  with the tile, and the share of all that is done with it
template <class Work>
void for_tiles(const Window& window, Context& context, const Work& work) {
    const TileGrid grid(window);
    std::atomic<std::size_t> done{0};
    context.parallel_for(grid.count(), [&](std::size_t number) {
        if (!context.cancelled()) work(grid.at(number), double(++done) / double(grid.count()));
    });
}

/// One after the other, even if cancelled.
template <class Work>
void for_each_tile(const Window& window, const Work& work) {
    const TileGrid grid(window);
    for (std::size_t number = 0; number < grid.count(); ++number) work(grid.at(number));
}

/// What a tile's scratch holds, for the sink. @param channels  Channel bits
inline Tile tile_of(const Window& area, std::uint32_t channels, const TileScratch& s) {
    Tile tile{.area = area};
    tile.color = s.color;
    for_each_channel(
        [&](std::uint32_t bit, auto& to, const auto& array) {
            if (channels & bit) to = array;
        },
        tile, static_cast<const ChannelArrays&>(s));
    return tile;
}

}  // namespace rakelight::raytrace
