// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/error.h>

#include "math/linear.h"
#include "scene/scene_tools.h"

using namespace rakelight;

namespace {

/// A scene with one of everything: a textured triangle that a joint moves, a light and a camera at nodes and in the
/// world.
Scene one_of_everything(const std::string& name) {
    Scene s;
    Texture texture;
    texture.name = name;
    texture.image = std::make_shared<EncodedImage>();
    s.textures.push_back(texture);
    Material m;
    m.name = name;
    for_each_texture_use(m, [](TextureUse& use) { use.texture = 0; });
    s.materials = {m};
    Mesh mesh;
    mesh.name = name;
    mesh.positions = Block<vec3>({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    mesh.indices = Block<std::uint32_t>({0, 1, 2});
    mesh.influences = Block<JointInfluence>(std::vector<JointInfluence>(3, {{0, 0, 0, 0}, {1, 0, 0, 0}}));
    mesh.targets.push_back({"up", mesh.positions, {}, {}});
    mesh.material = 0;
    s.meshes = {mesh};
    Node base, child;
    base.name = name + " base", child.name = name + " child";
    child.parent = 0, child.meshes = {0}, child.skin = 0, child.morph_weights = {0.5f};
    s.nodes = {base, child};
    s.skins = {{"skin", {1}, {dmat4{}}}};
    AnimationChannel channel;
    channel.node = 1;
    channel.times = Block<float>({0.0f});
    channel.values = Block<float>({0.0f, 0.0f, 0.0f});
    s.animations = {{"walk", {channel}}};
    Light at_node, in_world;
    at_node.node = 1, in_world.position = {1, 2, 3}, in_world.direction = {0, 0, -1};
    s.lights = {at_node, in_world};
    Camera camera, placed;
    camera.node = 1;
    placed.to_world = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
    s.cameras = {camera, placed};
    return s;
}

}  // namespace

TEST(MergeScenes, EveryNumberGoesOnMeaningTheSameThing) {
    const Scene a = one_of_everything("a"), b = one_of_everything("b");
    Scene all;
    merge_scene(all, a);
    Node root;
    root.name = "root";
    const MergeOffsets by = merge_scene(all, b, &root);
    EXPECT_EQ(by.nodes, 3u);
    ASSERT_EQ(all.nodes.size(), 5u);
    EXPECT_EQ(all.nodes[2].name, "root");
    EXPECT_EQ(all.nodes[3].parent, 2u);
    EXPECT_EQ(all.nodes[4].parent, 3u);
    EXPECT_EQ(all.meshes.at(all.nodes[4].meshes.at(0)).name, "b");
    EXPECT_EQ(all.nodes[4].skin, 1u);
    EXPECT_EQ(all.skins[1].joints, std::vector<std::uint32_t>{4});
    EXPECT_EQ(all.animations.at(1).channels[0].node, 4u);
    EXPECT_EQ(all.materials.at(all.meshes[1].material).name, "b");
    EXPECT_EQ(all.meshes[1].targets.at(0).name, "up");
    int uses = 0;
    for_each_texture_use(all.materials[1], [&](TextureUse& use) {
        EXPECT_EQ(all.textures.at(use.texture).name, "b");
        ++uses;
    });
    EXPECT_EQ(uses, 16);
    EXPECT_EQ(all.lights.at(2).node, 4u);
    EXPECT_EQ(all.cameras.at(2).node, 4u);
    EXPECT_EQ(all.meshes[1].positions, b.meshes[0].positions);  // shared, not copied
    validate(all);
}

TEST(MergeScenes, AllBelowTheNewNodeMovesWithItLightsAndCamerasToo) {
    Scene all;
    Node root;
    root.local.translation = {10, 0, 0};
    root.local.scale = {2, 2, 2};
    merge_scene(all, one_of_everything("a"), &root);
    EXPECT_EQ(world_matrices(all).at(2)[3].xyz(), (dvec3{10, 0, 0}));
    EXPECT_EQ(all.lights[1].position, (dvec3{12, 4, 6}));
    EXPECT_EQ(all.lights[1].direction, (dvec3{0, 0, -1}));
    EXPECT_EQ(all.cameras[1].to_world[3].xyz(), (dvec3{10, 0, 10}));
    EXPECT_EQ(all.cameras[1].to_world[2].xyz(), (dvec3{0, 0, 1}));
}
