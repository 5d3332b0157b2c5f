// SPDX-License-Identifier: Apache-2.0
// Planes of the clip volume and the fixed-point screen: numbers that kernels know too. C headers only, no functions.
#pragma once
#include <stdint.h>

namespace rakelight::raster {

/// The planes that a vertex may violate, as bits of its outcode.
enum ClipPlane : unsigned {
    clip_near = 1,
    clip_far = 2,
    clip_left = 4,
    clip_right = 8,
    clip_bottom = 16,
    clip_top = 32,
    clip_guard_left = 64,
    clip_guard_right = 128,
    clip_guard_bottom = 256,
    clip_guard_top = 512,
};
/// Planes that a triangle is cut by. The sides of the picture only reject: between them and the guard band, a million
/// pixels out, rasterization drops what is outside for less than cutting costs, and edges keep their exact place.
inline constexpr unsigned cutting_planes =
    clip_near | clip_far | clip_guard_left | clip_guard_right | clip_guard_bottom | clip_guard_top;
inline constexpr unsigned outside_all =
    1023;  ///< outcode of a vertex with a non-finite coordinate: in front of near and behind far

/// Screen coordinates are rounded as positive numbers, about snap_origin [1/256 px].
inline constexpr int32_t snap_origin = 1 << 29;
inline constexpr double snap_lowest = double(snap_origin - (1 << 28)), snap_highest = double(snap_origin + (1 << 28));

}  // namespace rakelight::raster
