// SPDX-License-Identifier: Apache-2.0
// Which pixels of a tile show one draw, and which of its triangles. Per instruction set.
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

static int32_t number(const int32_t* visible, const int32_t* pixel, int32_t count, int32_t* record, int32_t* triangle,
                      int32_t* wanted) {
    int32_t numbered = 0;
    for (int32_t i = 0; i < count; i += lanes) {
        const integer position = gather_i(visible, load_i(pixel + i));
        integer known = gather_i(record, position);
        for (uint32_t unknown = lane_bits(known < integer(0)); unknown != 0; unknown = lane_bits(known < integer(0))) {
            const int32_t next = visible[pixel[i + __builtin_ctz(unknown)]];
            known = select(position == integer(next), integer(numbered), known);
            record[next] = numbered;
            wanted[numbered++] = next;
        }
        store(triangle + i, known);
    }
    return numbered;
}

}  // namespace rakelight::raster::RL_ISA
