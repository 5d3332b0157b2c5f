// SPDX-License-Identifier: Apache-2.0
// The placement of one node.
#pragma once
#include <rakelight/scene.h>

#include "io/gltf/document.h"

namespace rakelight::io::gltf {

/// matrix, or translation, rotation and scale. Says where a rotation has no length, is not a unit quaternion, where a
/// scale or matrix flattens, and where a matrix is not affine (its last row is then taken as 0 0 0 1).
/// @throws Error: wrong kinds or numbers of values, numbers beyond 1e38.
Transform read_transform(const Document& document, const Value& node);

}  // namespace rakelight::io::gltf
