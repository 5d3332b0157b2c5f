// SPDX-License-Identifier: Apache-2.0
// Any scene as a GLB file (glTF 2.0): nodes, meshes, materials, textures as they are encoded, cameras and lights.
#pragma once
#include <string>

#include <rakelight/context.h>
#include <rakelight/scene.h>

namespace rakelight::io {

/// Vertex data is written as float, indices as 16 or 32 bits, textures byte by byte (PNG, JPEG, WebP; others are
/// dropped and said, since nothing is decoded here). Classical materials become metallic-roughness and classical lights
/// photometric, said in the report; so are height and opacity maps, ambient lights, skins, morph targets and
/// animations, which are left out.
/// @throws Error failed: over 4 GiB, cannot write; bad_file: nothing to write
void write_glb(const Scene& scene, const std::string& path, Context& context);

}  // namespace rakelight::io
