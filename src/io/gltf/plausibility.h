// SPDX-License-Identifier: Apache-2.0
// Remarks on data that could be read but is not as the specification has it. What a mesh's numbers are like (not finite,
// zero, too large) is not looked at here: prepare says that when it repairs them, for every format.
#pragma once
#include "io/gltf/accessors.h"

namespace rakelight::io::gltf {

/// Says when integer positions, normals or tangents are used without KHR_mesh_quantization.
void remark_on_quantization(const Document& document, const Accessors& accessors, const Value& primitive);

}  // namespace rakelight::io::gltf
