// SPDX-License-Identifier: Apache-2.0
// Minimal scenes, built in code.
#pragma once
#include <rakelight/scene/scene.h>

#include <string>

namespace rakelight::test {

/// A unit square in the plane z = 0 of two triangles, from (0,0,0) to (1,1,0), facing +Z.
inline Mesh quad_mesh() {
    Mesh mesh;
    mesh.name = "quad";
    mesh.positions = std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
    return mesh;
}

inline ImageHandle any_image() { return std::make_shared<const EncodedImage>(); }

/// One node with the quad, one material, one texture, one light, one camera.
inline Scene quad_scene() {
    Scene scene;
    scene.source = "quad.test";
    scene.meshes.push_back(quad_mesh());
    scene.meshes[0].material = 0;
    scene.materials.emplace_back();
    scene.textures.push_back({"texture", any_image(), {}});
    Node node;
    node.name = "object";
    node.meshes = {0};
    scene.nodes.push_back(node);
    scene.lights.emplace_back();
    scene.cameras.emplace_back();
    return scene;
}

}  // namespace rakelight::test
