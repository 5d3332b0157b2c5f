// SPDX-License-Identifier: Apache-2.0
// Which meshes a glTF file needs when placements of one mesh came out differently.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

namespace rakelight::io::gltf {

/// One version of a mesh of the file: the scene meshes that stand for its primitives.
struct MeshVersion {
    std::uint32_t source_mesh = 0;
    std::vector<std::uint32_t> meshes;  ///< into the scene after the change; some primitives of the file may be missing
    std::vector<std::uint32_t> nodes;   ///< nodes of the file that show it
    bool in_place = false;              ///< replaces the file's mesh; others are added
};

/// The versions, in the order of the nodes; the first of each mesh is in place. Nodes of the file that stand for many
/// placements (EXT_mesh_gpu_instancing) can show one version only: the first; reported.
std::vector<MeshVersion> mesh_versions(const Scene& before, const Scene& after, bool keep_instances, Context& context);

/// [meshes of `after`] the mesh of `before` that each came from.
std::vector<std::uint32_t> origins(const Scene& before, const Scene& after);

}  // namespace rakelight::io::gltf
