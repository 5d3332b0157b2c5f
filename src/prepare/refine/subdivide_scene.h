// SPDX-License-Identifier: Apache-2.0
// Meshes as control nets of subdivision surfaces, over the borders of objects.
#pragma once
#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Whether any mesh is subdivided, by itself or by default.
/// @param otherwise for meshes without their own
bool wants_subdivision(const Scene& scene, const Subdivision& otherwise);

/// The scene with those meshes refined: points on the limit surface, its normals, texture coordinates and colors; no
/// tangents, smoothing groups, influences or morph targets (the last two with a remark). Meshes of any objects that
/// share a vertex and have equal subdivision form one surface. A surface under one matrix is computed in object space,
/// so that instances stay shared; crease angles are then measured there too, unless the matrix changes angles.
/// @throws Error bad_file: over the memory budget; usage: numbers out of range
Scene subdivide_scene(Scene scene, const Subdivision& otherwise, Context& context);

}  // namespace rakelight
