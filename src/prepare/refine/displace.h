// SPDX-License-Identifier: Apache-2.0
// Displacement mapping: tessellates triangles and moves vertices along the normal.
#pragma once
#include <rakelight/prepare/prepare.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// Whether any mesh has a displaced material and a height map with texture coordinates.
bool wants_displacement(const Scene& scene, const Displacement& options);

/// The scene with these meshes tessellated and displaced, without normals and tangents, which must be recomputed. Every
/// mesh must have normals. All vertices at one place move together: along the mean of their normals, by the mean of
/// their heights. Places shared with a mesh without displacement do not move, and that mesh is split along the border.
/// Each instance gets its own mesh. How deep: collect_parts; how fine: set_blur (displace_parts.h), with a warning
/// where little of the relief is left. A height map that cannot be decoded is a warning, and its meshes stay as they
/// are.
/// @throws Error bad_file: over the memory budget
Scene displace_scene(Scene scene, const Displacement& options, Context& context);

}  // namespace rakelight
