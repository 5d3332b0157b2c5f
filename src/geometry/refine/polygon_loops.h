// SPDX-License-Identifier: Apache-2.0
// Reconstructs polygons from their triangles.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/refine/surface_pieces.h"

namespace rakelight::geometry {

struct PolygonLoops {
    Polygons faces;                             ///< corners are vertices of the mesh
    std::vector<std::uint32_t> first_triangle;  ///< [F + 1] the triangles of each face
};

/// Triangles without a simple boundary loop stay triangles. Loops start at the first corner of the first triangle.
/// @param indices  [3T]
/// @param numbers [T] consecutive triangles with equal numbers were one polygon; empty: all are triangles
PolygonLoops polygon_loops(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> numbers);

}  // namespace rakelight::geometry
