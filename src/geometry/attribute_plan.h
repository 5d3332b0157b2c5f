// SPDX-License-Identifier: Apache-2.0
// The state shared by the steps of compute_attributes().
#pragma once
#include "geometry/corners/vertex_groups.h"
#include "geometry/groups/grouping.h"

namespace rakelight {

struct AttributePlan::Impl {
    AttributeOptions options;     ///< without tangents if another stage computes them
    bool tangents_after = false;  ///< tangents are computed by options.tangent_mode from the finished normals
    std::vector<std::uint32_t> vertices, triangles;  ///< [meshes] counts required by accumulate()
    std::vector<std::uint8_t> textured;              ///< [meshes] had texture coordinates
    geometry::GroupingBase base;                     ///< stored by group() and regroup() for the next regroup()
    geometry::Topology topology;
    geometry::VertexGroups groups;
};

}  // namespace rakelight
