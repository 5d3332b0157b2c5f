// SPDX-License-Identifier: Apache-2.0
// Polygons in space cut into triangles.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/math/vector.h>

namespace rakelight::io::obj {

enum class PolygonCut : std::uint8_t {
    good,        ///< a simple polygon (or nearly planar one), or a triangle
    degenerate,  ///< no area or a corner that is not finite: a fan
    crossed,     ///< no ear was left before the end (it crosses or touches itself): the rest is a fan
    complex,     ///< the work bound was reached: the rest is a fan
};

/// What a corner of a polygon takes while it is cut, with its position and its triangles: check it before triangulate().
inline constexpr std::uint64_t polygon_bytes = 120;

/// Triangulates a polygon into n - 2 triangles that keep its winding, in the plane of its best-fitting (Newell)
/// normal. Strictly convex polygons become a fan from the first corner. Others are triangulated by ear clipping
/// (Meisters 1975, "Polygons Have Ears") with a grid over the corners that are not convex. Exact for coordinates that
/// double holds exactly up to products; no holes.
///
/// @param corners    [n] positions, n >= 3
/// @param triangles  [3 (n - 2)] corner numbers 0..n-1 are appended
/// Work is bounded by about 4000 steps per corner; usual polygons take O(n log n) or less. Scratch memory: 50 bytes a
/// corner.
PolygonCut triangulate(std::span<const dvec3> corners, std::vector<std::uint32_t>& triangles);

}  // namespace rakelight::io::obj
