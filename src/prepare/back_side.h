// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rakelight/scene.h>

namespace rakelight {

/// The surface with reversed winding and normals, without tangents.
Mesh back_side(Mesh mesh);

}  // namespace rakelight
