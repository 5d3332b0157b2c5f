// SPDX-License-Identifier: Apache-2.0
// What the steps of the attribute door share.
#pragma once
#include "geometry/grouping.h"
#include "geometry/vertex_groups.h"

namespace rakelight {

struct AttributePlan::Impl {
    AttributeOptions options;                        ///< without tangents where another stage makes them
    bool tangents_after = false;                     ///< by options.tangent_mode, from the finished normals
    std::vector<std::uint32_t> vertices, triangles;  ///< [meshes] counts that accumulate() insists on
    std::vector<std::uint8_t> textured;              ///< [meshes] had texture coordinates
    geometry::GroupingBase base;                     ///< kept by group() and regroup() for the next regroup()
    geometry::Topology topology;
    geometry::VertexGroups groups;
};

}  // namespace rakelight
