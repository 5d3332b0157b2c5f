// SPDX-License-Identifier: Apache-2.0
// glTF meshes to scene meshes: one per primitive, made when a node first asks.
#pragma once
#include <map>

#include "io/gltf/materials.h"
#include "io/gltf/vertex_data.h"

namespace rakelight::io::gltf {

/// What became of a glTF mesh.
struct LoadedMesh {
    std::vector<std::uint32_t>
        meshes;                     ///< into Scene::meshes; fewer than its primitives when some hold nothing to draw
    Block<float> default_weights;   ///< of its morph targets; empty without
    std::uint32_t joints_used = 0;  ///< one more than the largest joint that a vertex follows; 0: not skinned
};

class Meshes {
public:
    Meshes(Accessors& accessors, Materials& materials, Scene& scene)
        : accessors_(accessors), materials_(materials), scene_(scene) {}
    /// @throws Error: no such mesh, broken accessors, indices out of range, unequal counts.
    const LoadedMesh& load(std::uint32_t index, const Value& from);

private:
    void read_primitive(const Value& mesh, const Value& primitive, Mesh& result);
    void read_targets(VertexData& vertices, const Value& mesh, const Value& primitive, Mesh& result);
    void read_texcoords(VertexData& vertices, const Value& primitive, Mesh& result);
    const Document& document() const { return accessors_.document(); }

    Accessors& accessors_;
    Materials& materials_;
    Scene& scene_;
    BlockCache cache_;
    std::map<std::uint32_t, LoadedMesh> loaded_;
};

}  // namespace rakelight::io::gltf
