// SPDX-License-Identifier: Apache-2.0
// The placement of one node.
#pragma once
#include <rakelight/scene/scene.h>

#include "io/gltf/document.h"

namespace rakelight::io::gltf {

/// matrix, or translation, rotation and scale. Reports rotations of zero length or that are not unit quaternions,
/// scales and matrices that flatten, and matrices that are not affine (their last row is replaced by 0 0 0 1).
/// @throws Error: wrong kinds or numbers of values, numbers beyond 1e38.
Transform read_transform(const Document& document, const Value& node);

}  // namespace rakelight::io::gltf
