// SPDX-License-Identifier: Apache-2.0
// Any scene as a file of glTF 2.0: nodes, meshes, materials, textures as they are encoded, skins, morph targets, animations,
// cameras and lights.
#pragma once
#include <string>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight::io {

/// Vertex data is written as float, indices as 16 or 32 bits, textures byte by byte (PNG, JPEG, WebP; others are
/// dropped and reported, since nothing is decoded here). Classical materials become metallic-roughness and classical lights
/// photometric, reported; so are height and opacity maps and ambient lights, which are left out. A path that
/// ends in .gltf: JSON, with the data in NAME.bin beside it.
/// @throws Error failed: over 4 GiB, cannot write; bad_file: nothing to write
void write_glb(const Scene& scene, const std::string& path, Context& context);

}  // namespace rakelight::io
