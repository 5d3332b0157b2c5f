// SPDX-License-Identifier: Apache-2.0
// Remarks on data that is readable but violates the specification. The numbers of a mesh (not finite, zero, too large)
// are not checked here: prepare reports them when it repairs them, for every format.
#pragma once
#include "io/gltf/accessors.h"

namespace rakelight::io::gltf {

/// Says when integer positions, normals or tangents are used without KHR_mesh_quantization.
void remark_on_quantization(const Document& document, const Accessors& accessors, const Value& primitive);

}  // namespace rakelight::io::gltf
