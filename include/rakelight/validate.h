// SPDX-License-Identifier: Apache-2.0
// Whether a scene that was made in memory is whole.
#pragma once
#include <rakelight/error.h>
#include <rakelight/export.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Checks what everything else relies on: node parents come before their children, indices are in range, vertex arrays
/// have V entries, matrices, colors and parameters are finite, enumerators exist, textures have images (which are not
/// decoded here). Positions, normals and texture coordinates may be anything. Every function of the library that takes
/// a scene begins with this check, as load() ends with it; whoever builds a scene may ask for it sooner. One pass over
/// the indices: about 2 ms for a million triangles.
/// @throws Error bad_file with the place ("mesh 3 'body'") of the first fault
RL_API void validate(const Scene& scene);

}  // namespace rakelight
