// SPDX-License-Identifier: Apache-2.0
// Vertices and faces -> the meshes of a scene.
#pragma once
#include <rakelight/scene/scene.h>

#include "io/ply/ply_faces.h"

namespace rakelight::io::ply {

/// Adds them to the first node: lines, and triangles, or where there are neither the vertices as points. Corners with values of their
/// own become vertices of their own.
/// @param mesh  with its vertices and all that lines, triangles and points share
void add_meshes(Scene& scene, Mesh mesh, Faces& faces, Context& context);

}  // namespace rakelight::io::ply
