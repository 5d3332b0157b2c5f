// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rakelight/scene.h>

namespace rakelight {

/// The same surface seen from behind: triangles and normals are turned. Without tangents.
Mesh back_side(Mesh mesh);

}  // namespace rakelight
