// SPDX-License-Identifier: Apache-2.0
// Validation of scenes created in memory.
#pragma once
#include <rakelight/base/error.h>
#include <rakelight/base/export.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Checks the invariants of a scene. Parents precede their children, indices are in range, and vertex arrays have one
/// entry per vertex. Matrices, colors and parameters are finite, and enumerators are valid. Textures have images; the
/// images are not decoded here. Positions, normals and texture coordinates may have any value. Every public function
/// that takes a scene starts with this check, and load() ends with it. The check is one pass over the indices: about 2
/// ms for a million triangles.
/// @throws Error bad_file with the place of the first fault ("mesh 3 'body'")
RL_API void validate(const Scene& scene);

}  // namespace rakelight
