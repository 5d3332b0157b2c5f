// SPDX-License-Identifier: Apache-2.0
// Remarks on data that is well-formed but cannot look as meant. Nothing is changed here: prepare repairs what it can.
#pragma once
#include <rakelight/scene.h>

#include "io/gltf/accessors.h"

namespace rakelight::io::gltf {

/// Counts non-finite positions, normals, tangents and texture coordinates, zero normals, tangents without handedness,
/// and says where a whole mesh has no extent, no area or (under a texture) one texture coordinate, or is too large or
/// small for float products. `material` may be null.
void remark_on_mesh(const Document& document, const Mesh& mesh, const Material* material, const std::string& place);

/// Says when integer positions, normals or tangents are used without KHR_mesh_quantization.
void remark_on_quantization(const Document& document, const Accessors& accessors, const Value& primitive);

}  // namespace rakelight::io::gltf
