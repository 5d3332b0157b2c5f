// SPDX-License-Identifier: Apache-2.0
// Tangents that are made after the normals: MikkTSpace's and the published ones.
#pragma once
#include "geometry/attribute_plan.h"

namespace rakelight::geometry {

/// Adds tangents (and bitangents) to finished normals by plan.options.tangent_mode, for meshes with texture
/// coordinates.
void add_tangents(std::vector<MeshAttributes>& meshes, const AttributePlan::Impl& plan, const AttributeInput& input,
                  Context& context);

/// Of these, the published modes: unit tangents and bitangents of the faces at a place (scope face: of a vertex),
/// each face once, averaged apart. No vertex is split. @param meshes with normals, as finish_vertices() made them
void add_published(std::vector<MeshAttributes>& meshes, const AttributePlan::Impl& plan, const AttributeInput& input,
                   Context& context);

}  // namespace rakelight::geometry
