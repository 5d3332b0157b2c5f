// SPDX-License-Identifier: Apache-2.0
// Welding within a tolerance: places that differ only by rounding.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/weld/position_weld.h"

namespace rakelight::geometry {

/// Joins places of weld_positions() within a distance: connected components of close pairs, independent of the order of
/// vertices. Components wider than twice the distance, and places in overcrowded cells, are not joined, with a remark.
/// Expected O(n).
/// @param distance [m] world space; 0: none; < 0: rounding errors of the two meshes, see
///         AttributeOptions::weld_distance and AttributeMesh::position_step. Only between meshes with different
///         matrices (equal ones keep equal numbers equal), or, if either mesh is quantized, between different meshes
void weld_near(std::vector<std::uint32_t>& representative, const AttributeInput& input, WeldKey key, double distance,
               Context& context);

}  // namespace rakelight::geometry
