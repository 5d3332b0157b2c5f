// SPDX-License-Identifier: Apache-2.0
// Which meshes of a plan have to do with one another.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/attributes.h>

namespace rakelight::geometry {

/// [meshes] The least number of a mesh that each is connected with by places that two meshes have in common, however
/// many lie between. What moves in one island changes nothing in another. O(vertices).
std::vector<std::uint32_t> mesh_islands(const AttributePlan& plan);

}  // namespace rakelight::geometry
