// SPDX-License-Identifier: Apache-2.0
// Plain data between the passes of ambient occlusion and their kernels. C headers only, as geometry_types.h.
#pragma once
#include <stdint.h>

namespace rakelight::raster {

/// Pixels whose ambient occlusion is wanted, and the depths around them. Places are pixels of the whole picture.
struct OcclusionJob {
    const float*
        keys;  ///< depth keys, of (left, top); < 0: nothing is there, as it is occlusion_margin beyond each side
    int64_t key_stride;                ///< from row to row; whole vectors are read past the last column
    int32_t left, top, right, bottom;  ///< inclusive
    int32_t x, y, width, height;       ///< what is wanted
    int32_t is_parallel, slices, steps;
    float ray_x, ray_y, first_x, first_y, near, depth_range, radius,
        most_pixels;       ///< OcclusionFactors of horizons.glsl
    const float* cosines;  ///< [slices][16] of slices' directions, by a pixel's place in a square of 4 x 4
    const float* sines;
    float* openness;          ///< out: of (x, y); rows are written to whole vectors
    int64_t openness_stride;  ///< from row to row
    const float* raw;         ///< smooth_occlusion: what occlusion found, of (x, y); it is there smoothing_reach pixels
                              ///< farther to each side, and a whole vector past the last column
    int64_t raw_stride;
};

inline constexpr int occlusion_margin = 2;  ///< [px] what a pixel's plane is found from, to each side
inline constexpr int occlusion_pattern =
    4;  ///< [px] a side of the square whose pixels look along directions of their own
inline constexpr int smoothing_reach = 2;  ///< [px] to each side: one such square on the whole

}  // namespace rakelight::raster
