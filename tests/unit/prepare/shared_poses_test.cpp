// SPDX-License-Identifier: Apache-2.0
// What poses of many nodes have in common is kept once: tables of targets, weights, joints, posed vertices.
#include <gtest/gtest.h>

#include <rakelight/scene/motion.h>

#include "prepare/moving_placements.h"
#include "prepare/pose_scene.h"
#include "support/scene_builder.h"
#include "support/thrown_error.h"

namespace rakelight {
namespace {

/// A square with a target that lifts it, shown by `nodes` nodes with the same weights.
Scene lifted(std::size_t nodes) {
    Scene scene;
    Mesh mesh = test::square_mesh();
    mesh.targets = {{"lift", std::vector<vec3>(4, vec3{0, 0, 1}), {}, {}}};
    scene.meshes = {mesh};
    Node node;
    node.meshes = {0};
    node.morph_weights = {0.5f};
    scene.nodes.assign(nodes, node);
    return scene;
}

const void* posed_identity(const Scene& scene, std::size_t node) {
    return scene.meshes[scene.nodes[node].meshes[0]].positions.identity();
}

TEST(SharedPoses, NodesOfOneMeshAndTheSameWeightsShareTheirVertices) {
    Scene scene = lifted(3);
    scene.nodes[2].morph_weights = {0.25f};
    Context context;
    const Scene posed = posed_scene(scene, context);
    EXPECT_EQ(posed_identity(posed, 0), posed_identity(posed, 1));
    EXPECT_NE(posed_identity(posed, 0), posed_identity(posed, 2));
    EXPECT_EQ(posed.meshes[posed.nodes[1].meshes[0]].positions[0].z, 0.5f);
    EXPECT_EQ(posed.meshes[posed.nodes[2].meshes[0]].positions[0].z, 0.25f);
}

TEST(SharedPoses, NormalsThatSmoothingMadeEqualArePosedOnce) {
    Scene scene = lifted(3);
    Context context;
    scene = with_own_meshes(std::move(scene), context);
    for (Mesh& mesh : scene.meshes) mesh.normals = std::vector<vec3>(4, {0, 0, 1});  // arrays of their own
    scene.meshes[scene.nodes[2].meshes[0]].normals = std::vector<vec3>(4, {1, 0, 0});
    const Scene posed = posed_scene(scene, context);
    const auto normals = [&](std::size_t node) { return posed.meshes[posed.nodes[node].meshes[0]].normals; };
    EXPECT_EQ(posed_identity(posed, 0), posed_identity(posed, 1));
    EXPECT_EQ(normals(0).identity(), normals(1).identity());
    EXPECT_EQ(normals(2)[0], (vec3{1, 0, 0}));
}

TEST(SharedPoses, MeshesOfTheirOwnShareTheTableOfTargets) {
    const Scene scene = lifted(3);
    Context context;
    const Scene own = with_own_meshes(scene, context);
    ASSERT_EQ(own.meshes.size(), 3u);
    for (const Mesh& mesh : own.meshes) EXPECT_EQ(mesh.targets.identity(), scene.meshes[0].targets.identity());
}

TEST(SharedPoses, ManyNodesOfManyTargetsFitIntoLittleMemory) {
    constexpr std::size_t nodes = 1000, targets = 2000;  // a table for each node would take 112 MB
    Scene scene = lifted(nodes);
    scene.meshes[0].targets = std::vector<MorphTarget>(targets, scene.meshes[0].targets[0]);
    const Block<float> weights = std::vector<float>(targets, 0.5f / targets);
    for (Node& node : scene.nodes) node.morph_weights = weights;
    Context little({.max_memory = 4 << 20});
    const Scene posed = posed_scene(scene, little);
    EXPECT_EQ(posed_identity(posed, 0), posed_identity(posed, nodes - 1));
    EXPECT_NEAR(posed.meshes[0].positions[0].z, 0.5f, 1e-5f);
}

TEST(SharedPoses, ChannelsOfTheSameKeysShareTheirWeights) {
    Scene scene = lifted(3);
    Animation clip;
    for (std::uint32_t n = 0; n < 2; ++n) {
        AnimationChannel channel;
        channel.element = n, channel.path = AnimationPath::morph_weights;
        channel.times = n == 0 ? Block<float>{0, 1} : clip.channels[0].times;
        channel.values = n == 0 ? Block<float>{0, 1} : clip.channels[0].values;
        clip.channels.push_back(std::move(channel));
    }
    scene.animations = {clip};
    const ClipTime half{.animation = 0, .time_s = 0.75};
    const Scene posed = scene_at(scene, {&half, 1});
    EXPECT_EQ(posed.pose->morph_weights[0], posed.pose->morph_weights[1]);
    EXPECT_EQ(posed.pose->morph_weights[0][0], 0.75f);
    EXPECT_EQ(posed.pose->morph_weights[2], scene.nodes[2].morph_weights);
}

/// Every node has keys of its own, so nothing can be shared.
TEST(SharedPoses, WeightsOfChannelsAreCharged) {
    constexpr std::size_t nodes = 20, targets = 1000;
    Scene scene = lifted(nodes);
    scene.meshes[0].targets = std::vector<MorphTarget>(targets, scene.meshes[0].targets[0]);
    Animation clip;
    for (std::uint32_t n = 0; n < nodes; ++n) {
        AnimationChannel channel;
        channel.element = n, channel.path = AnimationPath::morph_weights;
        channel.times = {0, 1};
        channel.values = std::vector<float>(2 * targets);
        clip.channels.push_back(std::move(channel));
    }
    scene.animations = {clip};
    const ClipTime half{.animation = 0, .time_s = 0.5};
    MemoryBudget enough(nodes * targets * sizeof(float)), little(nodes * targets * sizeof(float) - 1);
    {
        const Scene posed = scene_at(scene, {&half, 1}, enough);
        EXPECT_EQ(enough.charged(), nodes * targets * sizeof(float));
    }
    EXPECT_EQ(enough.charged(), 0u);
    const Error error = test::error_of([&] { scene_at(scene, {&half, 1}, little); });
    EXPECT_EQ(error.reason().find("morph weights"), 0u) << error.reason();
}

/// Squares that follow one joint each, by a skin of `joints` times that joint.
Scene skinned(std::size_t nodes, std::size_t joints, double bind_of_last = 0) {
    Scene scene;
    Mesh mesh = test::square_mesh();
    mesh.influences = std::vector<JointInfluence>(4, {{0, 0, 0, 0}, {1, 0, 0, 0}});
    scene.meshes = {mesh};
    for (std::uint32_t n = 0; n < nodes; ++n) {
        Node node;
        node.meshes = {0}, node.skin = n;
        scene.nodes.push_back(node);
        std::vector<dmat4> bind(joints);
        if (n + 1 == nodes) bind[0][3].x = bind_of_last;
        scene.skins.push_back({"", std::vector<std::uint32_t>(joints, 0), std::move(bind)});
    }
    return scene;
}

TEST(SharedPoses, LikeSkinsShareTheirJoints) {
    constexpr std::size_t joints = 1000;
    Context context;
    const UnposedScene alike = valid::unposed_scene(skinned(20, joints), context);
    ASSERT_EQ(alike.poses.size(), 20u);
    for (const auto& [mesh, pose] : alike.poses)
        EXPECT_EQ(pose.joints.identity(), alike.poses.begin()->second.joints.identity());
    const std::uint64_t of_one = joints * sizeof(geometry::JointColumns);
    EXPECT_GE(context.memory().charged(), of_one);
    EXPECT_LT(context.memory().charged(), 2 * of_one);
    const UnposedScene other = valid::unposed_scene(skinned(20, joints, 3), context);
    std::set<const void*> tables;
    for (const auto& [mesh, pose] : other.poses) tables.insert(pose.joints.identity());
    EXPECT_EQ(tables.size(), 2u) << "the last skin has another bind matrix";
}

TEST(SharedPoses, JointsAreChargedBeforeTheyAreMade) {
    constexpr std::size_t joints = 1000, nodes = 20;
    Scene scene = skinned(nodes, joints);
    for (std::size_t n = 0; n < nodes; ++n)  // all unlike
        scene.skins[n].inverse_bind =
            test::changed(scene.skins[n].inverse_bind, [n](auto& bind) { bind[0][3].x = double(n); });
    Context enough({.max_memory = 8 << 20}),
        little({.max_memory = joints * sizeof(geometry::JointColumns) * nodes / 2});
    EXPECT_NO_THROW(posed_scene(scene, enough));
    const Error error = test::error_of([&] { posed_scene(scene, little); });
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_EQ(error.reason().find("joints of skins"), 0u) << error.reason();
}

}  // namespace
}  // namespace rakelight
