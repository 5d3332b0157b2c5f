// SPDX-License-Identifier: Apache-2.0
#include "prepare/split_vertices.h"

#include "base/assert.h"
#include "scene/motion/change_targets.h"

namespace rakelight {
namespace {

template <class T>
void extend(Block<T>& block, std::span<const std::uint32_t> source_vertex) {
    if (block.empty()) return;
    std::vector<T> values;
    values.reserve(block.size() + source_vertex.size());
    values.assign(block.begin(), block.end());
    for (const std::uint32_t v : source_vertex) values.push_back(block[v]);
    block = Block<T>(std::move(values));
}

/// Bytes a vertex over all arrays.
}  // namespace

std::uint64_t vertex_bytes(const Mesh& mesh) {
    std::uint64_t bytes = sizeof(vec3);
    if (!mesh.normals.empty()) bytes += sizeof(vec3);
    if (!mesh.tangents.empty()) bytes += sizeof(vec4);
    if (!mesh.bitangents.empty()) bytes += sizeof(vec3);
    if (!mesh.colors.empty()) bytes += sizeof(vec4);
    if (!mesh.influences.empty()) bytes += sizeof(JointInfluence);
    if (!mesh.more_influences.empty()) bytes += sizeof(JointInfluence);
    for (const VertexArray& array : mesh.arrays) bytes += array.components * sizeof(float);
    return bytes + mesh.texcoords.size() * sizeof(vec2) + mesh.targets.size() * 3 * sizeof(vec3);
}

void split_vertices(Mesh& mesh, std::vector<std::uint32_t> indices, std::span<const std::uint32_t> source_vertex,
                    Context& context) {
    if (!indices.empty()) {
        RL_ASSERT(indices.size() == mesh.indices.size(), "splitting vertices keeps the triangles");
        mesh.indices = std::move(indices);
    }
    if (source_vertex.empty()) return;
    context.memory().check((mesh.positions.size() + std::uint64_t(source_vertex.size())) * vertex_bytes(mesh),
                           "splitting vertices");
    extend(mesh.positions, source_vertex);
    extend(mesh.normals, source_vertex);
    extend(mesh.tangents, source_vertex);
    extend(mesh.bitangents, source_vertex);
    for (Block<vec2>& set : mesh.texcoords) extend(set, source_vertex);
    extend(mesh.colors, source_vertex);
    for (VertexArray& array : mesh.arrays) {
        std::vector<float> values(array.values.begin(), array.values.end());
        values.reserve((mesh.positions.size()) * array.components);
        for (const std::uint32_t v : source_vertex)
            for (std::uint32_t k = 0; k < array.components; ++k)
                values.push_back(array.values[std::size_t(v) * array.components + k]);
        array.values = std::move(values);
    }
    extend(mesh.influences, source_vertex);
    extend(mesh.more_influences, source_vertex);
    change_targets(
        mesh,
        [&](MorphTarget& target, std::size_t) {
            extend(target.positions, source_vertex);
            extend(target.normals, source_vertex);
            extend(target.tangents, source_vertex);
        },
        context);
}

}  // namespace rakelight
