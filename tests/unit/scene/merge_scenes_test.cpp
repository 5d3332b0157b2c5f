// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rakelight/base/error.h>
#include <rakelight/scene/validate.h>

#include "math/linear.h"
#include "scene/charge_arrays.h"
#include "scene/materials/texture_uses.h"
#include "scene/merge_scenes.h"
#include "scene/placement.h"

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
    mesh.targets = {{"up", mesh.positions, {}, {}}};
    mesh.material = 0;
    s.meshes = {mesh};
    Node base, child;
    base.name = name + " base", child.name = name + " child";
    child.parent = 0, child.meshes = {0}, child.skin = 0, child.morph_weights = {0.5f};
    s.nodes = {base, child};
    s.skins = {{"skin", {1}, {dmat4{}}}};
    AnimationChannel channel;
    channel.element = 1;
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
    Node root;
    root.name = "root";
    Context context;
    const std::vector<ScenePart> parts{{a, {}}, {b, root}};
    const MergedScene merged = merge_scenes(parts, context);
    Scene all = merged.scene;
    const MergeOffsets by = merged.offsets.at(1);
    EXPECT_EQ(by.nodes, 3u);
    ASSERT_EQ(all.nodes.size(), 5u);
    EXPECT_EQ(all.nodes[2].name, "root");
    EXPECT_EQ(all.nodes[3].parent, 2u);
    EXPECT_EQ(all.nodes[4].parent, 3u);
    EXPECT_EQ(all.meshes.at(all.nodes[4].meshes.at(0)).name, "b");
    EXPECT_EQ(all.nodes[4].skin, 1u);
    EXPECT_EQ(all.skins[1].joints, std::vector<std::uint32_t>{4});
    EXPECT_EQ(all.animations.at(1).channels[0].element, 4u);
    EXPECT_EQ(all.materials.at(all.meshes[1].material).name, "b");
    EXPECT_EQ(all.meshes[1].targets[0].name, "up");
    int uses = 0;
    for_each_texture_use(all.materials[1], [&](TextureUse& use) {
        EXPECT_EQ(all.textures.at(use.texture).name, "b");
        ++uses;
    });
    EXPECT_EQ(uses, 20);
    EXPECT_EQ(all.lights.at(2).node, 4u);
    EXPECT_EQ(all.cameras.at(2).node, 4u);
    EXPECT_EQ(all.meshes[1].positions, b.meshes[0].positions);  // shared, not copied
    validate(all);
}

TEST(MergeScenes, AllBelowTheNewNodeMovesWithItLightsAndCamerasToo) {
    Node root;
    root.local.translation = {10, 0, 0};
    root.local.scale = {2, 2, 2};
    const Scene a = one_of_everything("a");
    Context context;
    const std::vector<ScenePart> parts{{a, root}};
    const Scene all = merge_scenes(parts, context).scene;
    EXPECT_EQ(world_matrices(all).at(2)[3].xyz(), (dvec3{10, 0, 0}));
    EXPECT_EQ(all.lights[1].position, (dvec3{12, 4, 6}));
    EXPECT_EQ(all.lights[1].direction, (dvec3{0, 0, -1}));
    EXPECT_EQ(all.cameras[1].to_world[3].xyz(), (dvec3{10, 0, 10}));
    EXPECT_EQ(all.cameras[1].to_world[2].xyz(), (dvec3{0, 0, 1}));
}

TEST(MergeScenes, LightsAndCamerasOfAPartMayStayBehind) {
    const Scene a = one_of_everything("a");
    Context context;
    const std::vector<ScenePart> parts{{a, Node{}, false, true}, {a, Node{}, true, false}};
    const Scene all = merge_scenes(parts, context).scene;
    ASSERT_EQ(all.lights.size(), 2u);
    EXPECT_EQ(all.lights[0].node, 5u);
    ASSERT_EQ(all.cameras.size(), 2u);
    EXPECT_EQ(all.cameras[0].node, 2u);
}

TEST(MergeScenes, EachPartIsChargedBeforeItIsCopiedAndGivenBackWithTheScene) {
    Scene part = one_of_everything("a name that is too long to stand in the string itself");
    part.nodes.resize(100, part.nodes[1]);
    const std::vector<ScenePart> parts(50, {part, Node{}});
    const std::uint64_t tables = 50 * table_bytes(part);
    Context enough, too_small({.max_memory = tables});
    {
        const Scene all = merge_scenes(parts, enough).scene;
        EXPECT_GT(enough.memory().charged(), tables);
        EXPECT_GE(enough.memory().charged(), table_bytes(all)) << "a copy of it takes as much";
    }
    EXPECT_EQ(enough.memory().charged(), 0u);
    EXPECT_THROW(merge_scenes(parts, too_small), Error);
    EXPECT_EQ(too_small.memory().charged(), 0u);
}

TEST(MergeScenes, EndsWhereItIsCancelled) {
    const Scene part = one_of_everything("a");
    const std::vector<ScenePart> parts{{part, Node{}}};
    Context context;
    context.cancel();
    EXPECT_THROW(merge_scenes(parts, context), Error);
}
