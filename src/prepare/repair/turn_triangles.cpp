// SPDX-License-Identifier: Apache-2.0
#include "prepare/repair/turn_triangles.h"

#include <utility>

#include "math/linear.h"

namespace rakelight {

template <class T>
void TriangleTurner::turn(Block<T>& block, Known<T>& known, Context& context) {
    if (block.empty()) return;
    if (const auto it = known.find(block.identity()); it != known.end()) {
        block = it->second.second;
        return;
    }
    MemoryCharge charge(context.memory(), block.size() * sizeof(T), "triangles that turn clockwise");
    std::vector<T> corners(block.begin(), block.end());
    for (std::size_t t = 0; t + 2 < corners.size(); t += 3) std::swap(corners[t + 1], corners[t + 2]);
    const Block<T> before = std::exchange(block, Block<T>(std::move(corners), std::move(charge)));
    known.emplace(before.identity(), std::pair(before, block));
    known.emplace(block.identity(), std::pair(block, before));
}

Scene TriangleTurner::turned(Scene scene, Context& context) {
    for (Mesh& mesh : scene.meshes) {
        if (mesh.topology != Topology::triangles) continue;
        turn(mesh.indices, indices_, context);
        turn(mesh.smoothing_hint, hints_, context);
    }
    return scene;
}

Mesh back_side(Mesh mesh) {
    std::vector<std::uint32_t> indices(mesh.indices.begin(), mesh.indices.end());
    for (std::size_t i = 0; i < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
    std::vector<vec3> normals(mesh.normals.begin(), mesh.normals.end());
    for (vec3& n : normals) n = -n;
    mesh.indices = std::move(indices), mesh.normals = std::move(normals);
    mesh.tangents = {};
    return mesh;
}

}  // namespace rakelight
