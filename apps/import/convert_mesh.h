// SPDX-License-Identifier: Apache-2.0
// Meshes of an aiScene -> the records of stream_format.h.
#pragma once
#include <assimp/scene.h>

#include <cstdint>
#include <vector>

#include "convert_nodes.h"
#include "fbx_smoothing.h"
#include "source_format.h"

namespace rakelight::import_helper {

/// A topology of an aiMesh: one Part. An aiMesh with triangles and lines makes two.
struct PartSource {
    std::uint32_t mesh = 0, topology = 0;
};

std::vector<PartSource> list_parts(const aiScene& scene);
Part convert_part(const aiMesh& mesh, const PartSource& source, const Format& format, const FbxSmoothing& smoothing,
                  JointTable& joints);
void note_dropped(const aiScene& scene, Document& out);  ///< what list_parts and convert_part leave out

}  // namespace rakelight::import_helper
