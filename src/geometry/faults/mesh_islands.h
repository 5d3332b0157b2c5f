// SPDX-License-Identifier: Apache-2.0
// Connected components of a plan's meshes.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/geometry/attributes.h>

namespace rakelight::geometry {

/// [meshes] The smallest index of each mesh's connected component, where meshes with common places are connected.
/// Movement in one island does not affect another. O(vertices).
std::vector<std::uint32_t> mesh_islands(const AttributePlan& plan);

}  // namespace rakelight::geometry
