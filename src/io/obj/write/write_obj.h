// SPDX-License-Identifier: Apache-2.0
// A scene as an OBJ file with its MTL file: triangles in the world.
#pragma once
#include <string>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight::io {

/// One object for each node that has meshes, a `usemtl` for each mesh; positions [m, world], normals, the first set of texture
/// coordinates (v up), and smoothing groups where there are no normals. Materials go to NAME.mtl beside it: colors, and
/// textures by their paths as seen from there. Textures inside of the model become files NAME.N.png, ... beside it.
/// What OBJ cannot store (tangents, skins, clips, lights, cameras) is reported.
/// @param scene  placed in the world (placed_in_world()); nodes may turn it from there
/// @throws Error bad_file: nothing to write; failed: cannot write
void write_obj(const Scene& scene, const std::string& path, Context& context);

}  // namespace rakelight::io
