// SPDX-License-Identifier: Apache-2.0
// A small scene: two unit squares side by side in the plane z = 0, as two objects that share an edge.
#pragma once
#include <rakelight/scene/scene.h>

namespace rakelight::test {

inline Mesh square(float left) {
    Mesh mesh;
    mesh.positions = std::vector<vec3>{{left, 0, 0}, {left + 1, 0, 0}, {left + 1, 1, 0}, {left, 1, 0}};
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
    mesh.normals = std::vector<vec3>(4, vec3{0, 0, 1});
    return mesh;
}

inline Scene two_squares() {
    Scene scene;
    scene.source = "two.obj";
    scene.meshes = {square(-1), square(0)};
    scene.nodes.resize(2);
    scene.nodes[0].name = "left";
    scene.nodes[0].meshes = {0};
    scene.nodes[1].name = "right";
    scene.nodes[1].meshes = {1};
    return scene;
}

}  // namespace rakelight::test
