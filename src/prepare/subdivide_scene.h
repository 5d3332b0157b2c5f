// SPDX-License-Identifier: Apache-2.0
// Meshes as control nets of subdivision surfaces, over the borders of objects.
#pragma once
#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Some mesh is to be subdivided, by its own word or for want of one.
/// @param otherwise  for meshes that say nothing
bool wants_subdivision(const Scene& scene, const Subdivision& otherwise);

/// The scene with those meshes refined: points on the limit surface, its normals, texture coordinates and colors; no
/// tangents, smoothing groups, influences or morph targets (the last two with a remark). Meshes that meet at a vertex,
/// of whatever objects, and are to be subdivided alike are one surface. A surface under one matrix is made about its
/// objects' own origin, so that placements of the same meshes go on sharing them; crease angles are then measured there
/// too, unless the matrix changes angles.
/// @throws Error bad_file: over the memory budget; usage: numbers out of range
Scene subdivide_scene(Scene scene, const Subdivision& otherwise, Context& context);

}  // namespace rakelight
