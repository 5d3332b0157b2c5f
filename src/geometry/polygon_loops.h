// SPDX-License-Identifier: Apache-2.0
// Polygons put back together from the triangles that they were cut into.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/surface_pieces.h"

namespace rakelight::geometry {

struct PolygonLoops {
    Polygons faces;                             ///< corners are vertices of the mesh
    std::vector<std::uint32_t> first_triangle;  ///< [F + 1] the triangles of each face
};

/// @param indices  [3T]
/// @param numbers  [T] triangles with equal numbers, one after another, were one polygon; empty: all are triangles
/// Triangles whose rim is not one loop of different vertices stay triangles. Loops begin where the first triangle does.
PolygonLoops polygon_loops(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> numbers);

}  // namespace rakelight::geometry
