// SPDX-License-Identifier: Apache-2.0
// One tile from its triangles to the sink.
#pragma once
#include <chrono>
#include <utility>

#include "engines/raster/tile.h"

namespace rakelight::raster {

/// Seconds since the last lap, by the clock on the wall.
class StageClock {
public:
    double lap() {
        const auto now = std::chrono::steady_clock::now(), before = std::exchange(last_, now);
        return std::chrono::duration<double>(now - before).count();
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Visibility, shading, blending; hands the tile on, unless it was cut short.
void draw_tile(const TileJob& job, std::size_t tile, TileScratch& scratch, Sink& sink);

}  // namespace rakelight::raster
