// SPDX-License-Identifier: Apache-2.0
// What moves, written as glTF and read back: skins, morph targets, clips.
#include <gtest/gtest.h>

#include <filesystem>

#include "io/gltf/write/glb_writer.h"
#include "io/reader.h"
#include "math/linear.h"
#include "support/scene_builder.h"
#include "support/temporary_folder.h"

namespace rakelight::test {
namespace {

/// Node 0 is the parent of a joint, node 2 shows a skinned mesh with a morph target beside a plain one.
Scene moving_scene() {
    Scene scene;
    Mesh skinned;
    skinned.positions = std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    skinned.normals = std::vector<vec3>(3, vec3{0, 0, 1});
    skinned.indices = std::vector<std::uint32_t>{0, 1, 2};
    JointInfluence influence;
    influence.joints = {1, 0, 0, 0};
    influence.weights = {0.75f, 0.25f, 0, 0};
    skinned.influences = std::vector<JointInfluence>(3, influence);
    Mesh plain = skinned;
    plain.influences = {};
    MorphTarget target;
    target.name = "smile";
    target.positions = std::vector<vec3>{{0, 0, 0}, {0, 0, 0.5f}, {0, 0, 0}};
    target.normals = std::vector<vec3>{{0, 0, 0}, {0.25f, 0, 0}, {0, 0, 0}};
    skinned.targets = {target};
    scene.meshes = {skinned, plain};
    scene.nodes.resize(3);
    scene.nodes[1].parent = 0;
    scene.nodes[1].local.translation = {0, 2, 0};
    scene.nodes[2].meshes = {0, 1};
    scene.nodes[2].skin = 0;
    scene.nodes[2].morph_weights = {0.5f};
    scene.skins = {{"rig", {0, 1}, {translation(dvec3{0, 0, 0}), translation(dvec3{0, -2, 0})}}};
    AnimationChannel turn;
    turn.element = 1, turn.path = AnimationPath::rotation;
    turn.times = std::vector<float>{0, 1};
    turn.values = std::vector<float>{0, 0, 0, 1, 0, 0, 1, 0};
    AnimationChannel smile;
    smile.element = 2, smile.path = AnimationPath::morph_weights, smile.interpolation = Interpolation::step;
    smile.times = std::vector<float>{0, 0.5f};
    smile.values = std::vector<float>{0, 1};
    scene.animations = {{"nod", {turn, smile}}};
    return scene;
}

void expect_motion(const Scene& wanted, const Scene& got) {
    ASSERT_EQ(got.skins.size(), 1u);
    EXPECT_EQ(got.skins[0].name, wanted.skins[0].name);
    EXPECT_EQ(got.skins[0].joints, wanted.skins[0].joints);
    EXPECT_EQ(test::values_of(got.skins[0].inverse_bind), test::values_of(wanted.skins[0].inverse_bind));
    ASSERT_EQ(got.animations.size(), 1u);
    EXPECT_EQ(got.animations[0].name, "nod");
    ASSERT_EQ(got.animations[0].channels.size(), 2u);
    for (std::size_t c = 0; c < 2; ++c) {
        const AnimationChannel &a = wanted.animations[0].channels[c], &b = got.animations[0].channels[c];
        EXPECT_EQ(a.element, b.element);
        EXPECT_EQ(a.path, b.path);
        EXPECT_EQ(a.interpolation, b.interpolation);
        EXPECT_TRUE(std::equal(a.times.begin(), a.times.end(), b.times.begin(), b.times.end()));
        EXPECT_TRUE(std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end()));
    }
    const Mesh& mesh = got.meshes[got.nodes[2].meshes[0]];
    const Mesh& old = wanted.meshes[0];
    EXPECT_TRUE(
        std::equal(old.influences.begin(), old.influences.end(), mesh.influences.begin(), mesh.influences.end()));
    ASSERT_EQ(mesh.targets.size(), 1u);
    EXPECT_EQ(mesh.targets[0].name, "smile");
    EXPECT_EQ(mesh.targets[0].positions[1], (vec3{0, 0, 0.5f}));
    EXPECT_EQ(mesh.targets[0].normals[1], (vec3{0.25f, 0, 0}));
    EXPECT_EQ(test::values_of(got.nodes[2].morph_weights), test::values_of(wanted.nodes[2].morph_weights));
    EXPECT_EQ(got.nodes[2].skin, 0u);
}

TEST(GlbMotion, SkinsTargetsAndClipsComeBack) {
    const Scene scene = moving_scene();
    const TemporaryFolder folder;
    for (const char* name : {"a.glb", "a.gltf"}) {
        Context context;
        io::write_glb(scene, folder.file(name), context);
        expect_motion(scene, io::read_scene(folder.file(name), {}, context));
    }
    EXPECT_TRUE(std::filesystem::exists(folder.file("a.bin")));
}

TEST(GlbMotion, ASkinnedMeshThatCountsFromElsewhereStandsWhereItDid) {
    Scene scene = moving_scene();
    for (Mesh& mesh : scene.meshes) mesh.origin = {100, 0, 0};
    const TemporaryFolder folder;
    Context context;
    io::write_glb(scene, folder.file("a.glb"), context);
    const Scene got = io::read_scene(folder.file("a.glb"), {}, context);
    EXPECT_EQ(got.skins[0].inverse_bind[1], translation(dvec3{100, -2, 0}));
}

TEST(GlbMotion, DataOfAnotherModelIsNotReplaced) {
    const TemporaryFolder folder;
    std::FILE* const file = std::fopen(folder.file("a.bin").c_str(), "w");
    std::fclose(file);
    Context context;
    EXPECT_THROW(io::write_glb(moving_scene(), folder.file("a.gltf"), context), Error);
    EXPECT_FALSE(std::filesystem::exists(folder.file("a.gltf")));
}

}  // namespace
}  // namespace rakelight::test
