// SPDX-License-Identifier: Apache-2.0
// Which pixels of a tile show one draw. Per instruction set.
#pragma once
#include "engines/raster/kernel_types.h"
#include "math/wide.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;

/// Positions in a tile's list are in the order of the scene: those of one draw follow one another.
static int32_t collect(const int32_t* visible, int32_t begin, int32_t end, int32_t* pixel) {
    int32_t count = 0;
    for (int32_t p = 0; p < tile_size * tile_size; p += lanes) {
        const integer position = load_i(visible + p);
        const mask is_wanted = position >= integer(begin) && position < integer(end);
        if (no_lane(is_wanted)) continue;
        count += store_compressed(pixel + count, lane_indices() + integer(p), is_wanted);
    }
    return count;
}

}  // namespace rakelight::raster::RL_ISA
