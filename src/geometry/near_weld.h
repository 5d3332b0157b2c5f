// SPDX-License-Identifier: Apache-2.0
// Welding within a tolerance: places that differ only by rounding.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/position_weld.h"

namespace rakelight::geometry {

/// Joins the places of weld_positions() that lie within a distance of one another; connected components of such pairs,
/// whatever the order of the vertices. A component wider than twice the distance, and places in cells crowded beyond reason,
/// stay as they are, with a remark in the report. Expected O(n).
/// @param distance  [m] in the world; 0: nothing is joined; < 0: what rounding makes of one place, by the two meshes that meet:
///                  as AttributeOptions::weld_distance and AttributeMesh::position_step say. Only between different matrices
///                  (equal ones keep equal numbers equal), or, where either mesh is quantized, between different meshes
void weld_near(std::vector<std::uint32_t>& representative, const AttributeInput& input, WeldKey key, double distance,
               Context& context);

}  // namespace rakelight::geometry
