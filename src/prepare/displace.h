// SPDX-License-Identifier: Apache-2.0
// Height maps as real geometry: triangles cut fine, vertices moved along the normal.
#pragma once
#include <rakelight/prepare.h>
#include <rakelight/scene.h>

namespace rakelight {

/// Some mesh has a material that is to be displaced and a height map with texture coordinates for it.
bool wants_displacement(const Scene& scene, const Displacement& options);

/// The scene with those meshes tessellated and displaced, without normals and tangents: they are to be made again.
/// Every mesh must have normals. Vertices of all meshes at one place go the same way: along the mean of their normals,
/// by the mean of their heights; where a mesh that is not displaced has a vertex too, they stay, and that mesh is cut
/// along the border. Each placement gets a mesh of its own. How deep: collect_parts; how fine: set_blur
/// (displace_parts.h), with a warning where little of the relief is left. A height map that cannot be decoded is a
/// warning, and its meshes stay as they are.
/// @throws Error bad_file: over the memory budget
Scene displace_scene(Scene scene, const Displacement& options, Context& context);

}  // namespace rakelight
