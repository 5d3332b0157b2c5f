// SPDX-License-Identifier: Apache-2.0
// Tangents computed after the normals: MikkTSpace and the published modes.
#pragma once
#include "geometry/attribute_plan.h"

namespace rakelight::geometry {

/// Adds tangents (and bitangents) to finished normals by plan.options.tangent_mode, for meshes with texture
/// coordinates.
void add_tangents(std::vector<MeshAttributes>& meshes, const AttributePlan::Impl& plan, const AttributeInput& input,
                  Context& context);

/// The published modes: averages the unit tangents, and separately the unit bitangents, of the faces at a place (scope
/// face: of a vertex), each face once. No vertex is split.
/// @param meshes with normals of finish_vertices()
void add_published(std::vector<MeshAttributes>& meshes, const AttributePlan::Impl& plan, const AttributeInput& input,
                   Context& context);

}  // namespace rakelight::geometry
