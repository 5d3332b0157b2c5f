// SPDX-License-Identifier: Apache-2.0
// The depths of a whole tile. Per instruction set.
#pragma once
#include "engines/raster/kernels/geometry_types.h"
#include "math/wide.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;

static void clear_tile(float* depth, int32_t* visible) {
    const real nothing(-1.0f);  // farther than any key: those are 0 or more
    const integer nobody(-1);
    for (int32_t i = 0; i < tile_size * tile_size; i += lanes) {
        store(depth + i, nothing);
        store(visible + i, nobody);
    }
}

static void fill_empty(const int32_t* visible, uint32_t value, uint32_t* out, int64_t stride) {
    for (int32_t y = 0; y < tile_size; ++y)
        for (int32_t x = 0; x < tile_size; x += lanes) {
            const mask is_empty = load_i(visible + y * tile_size + x) < integer(0);
            if (no_lane(is_empty)) continue;
            int32_t* const to = reinterpret_cast<int32_t*>(out + y * stride + x);
            store(to, all_lanes(is_empty) ? integer(int32_t(value))
                                          : select(is_empty, integer(int32_t(value)), load_i(to)));
        }
}

static float farthest(const float* depth, int32_t left, int32_t top, int32_t right, int32_t bottom) {
    const real most(2.0f), zero(0.0f);  // nearer than any key
    const integer first(left), last(right);
    real least = most;
    for (int32_t y = top; y <= bottom; ++y) {
        for (int32_t x0 = left / lanes * lanes; x0 <= right; x0 += lanes) {
            const integer x = lane_indices() + integer(x0);
            least = min(least, select(x >= first && x <= last, load(depth + y * tile_size + x0), most));
        }
        if (any_lane(least < zero)) return -1.0f;
    }
    float all[lanes];
    store(all, least);
    float answer = all[0];
    for (int i = 1; i < lanes; ++i) answer = all[i] < answer ? all[i] : answer;
    return answer;
}

}  // namespace rakelight::raster::RL_ISA
