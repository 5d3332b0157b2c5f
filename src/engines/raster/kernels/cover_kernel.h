// SPDX-License-Identifier: Apache-2.0
// Coverage and depth test of one triangle in one tile, a vector of pixels of a row at a time. Per instruction set.
#pragma once
#include "engines/raster/kernels/geometry_types.h"
#include "math/wide.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;

/// The same numbers as for_each_covered() (coverage.h).
static int32_t cover(const CoverJob* given) {
    const CoverJob job = *given;
    const int32_t begin = job.left / lanes * lanes;  // rows of a tile hold whole vectors
    const integer left(job.left), right(job.right), position(job.position);
    const real low(job.depth_low), high(job.depth_high), depth_x(job.depth_x);
    uint32_t written = 0;
    for (int32_t x0 = begin; x0 <= job.right; x0 += lanes) {
        const integer x = lane_indices() + integer(x0);
        const mask in_box = x >= left && x <= right;
        const integer from_left = x - left;
        integer e[3];
        for (int k = 0; k < 3; ++k) e[k] = integer(job.edge[k]) + integer(job.step_x[k]) * from_left;
        const real along = depth_x * to_real(x - integer(job.plane_x));
        for (int32_t y = job.top; y <= job.bottom; ++y) {
            const mask covered = (e[0] | e[1] | e[2]) >= integer(0) && in_box;
            for (int k = 0; k < 3; ++k) e[k] += integer(job.step_y[k]);
            if (no_lane(covered)) continue;
            const real plane = real(job.depth_0 + job.depth_y * float(y - job.plane_y)) + along;
            const real depth = min(max(plane, low), high);  // NaN of an overflowing plane: the farthest corner
            float* const at = job.depth + y * tile_size + x0;
            const mask nearer = covered && depth > load(at);  // the first of equals stays
            store_masked(at, depth, nearer);
            store_masked(job.visible + y * tile_size + x0, position, nearer);
            written += uint32_t(__builtin_popcount(lane_bits(nearer)));
        }
    }
    return int32_t(written);
}

}  // namespace rakelight::raster::RL_ISA
