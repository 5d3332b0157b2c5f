// SPDX-License-Identifier: Apache-2.0
// Which pixels of a tile show one draw, and which of its triangles. Per instruction set.
#pragma once
#include "engines/raster/kernels/kernel_types.h"
#include "math/wide_rows.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;
using rakelight::wide::RL_ISA::load_i_rows4;

/// Positions in a tile's list are in the order of the scene: those of one draw follow one another. Pixels come block by
/// block: neighbors in both directions share triangles, levels and texels. Blocks that are wholly the draw's come
/// first: a vector then is one of them, which the shading kernel stores row by row.
static int32_t collect(const int32_t* visible, int32_t begin, int32_t end, int32_t* pixel, int32_t* list_position) {
    constexpr int32_t columns = lanes < block_side ? lanes : block_side, rows = lanes / columns;
    int32_t rest_pixel[tile_size * tile_size + lanes], rest_position[tile_size * tile_size + lanes], rest = 0;
    const integer lane = lane_indices();
    const integer place = ((lane >> 2) << tile_bits) + (lane & integer(block_side - 1));
    int32_t count = 0;
    for (int32_t y0 = 0; y0 < tile_size; y0 += block_side)
        for (int32_t x0 = 0; x0 < tile_size; x0 += block_side)
            for (int32_t y = y0; y < y0 + block_side; y += rows)
                for (int32_t x = x0; x < x0 + block_side; x += columns) {
                    const int32_t first = y * tile_size + x;
                    const integer position = load_i_rows4(visible + first, tile_size);
                    const mask is_wanted = position >= integer(begin) && position < integer(end);
                    if (no_lane(is_wanted)) continue;
                    if (all_lanes(is_wanted)) {
                        store(list_position + count, position);
                        store(pixel + count, place + integer(first));
                        count += lanes;
                        continue;
                    }
                    store_compressed(rest_position + rest, position, is_wanted);
                    rest += store_compressed(rest_pixel + rest, place + integer(first), is_wanted);
                }
    __builtin_memcpy(pixel + count, rest_pixel, uint32_t(rest) * sizeof(int32_t));
    __builtin_memcpy(list_position + count, rest_position, uint32_t(rest) * sizeof(int32_t));
    return count + rest;
}

static int32_t number(const int32_t* list_position, int32_t count, int32_t* record, int32_t* triangle,
                      int32_t* wanted) {
    int32_t numbered = 0;
    for (int32_t i = 0; i < count; i += lanes) {
        const integer position = load_i(list_position + i);
        integer known = gather_i(record, position);
        for (uint32_t unknown = lane_bits(known < integer(0)); unknown != 0; unknown = lane_bits(known < integer(0))) {
            const int32_t next = list_position[i + __builtin_ctz(unknown)];
            known = select(position == integer(next), integer(numbered), known);
            record[next] = numbered;
            wanted[numbered++] = next;
        }
        store(triangle + i, known);
    }
    return numbered;
}

}  // namespace rakelight::raster::RL_ISA
