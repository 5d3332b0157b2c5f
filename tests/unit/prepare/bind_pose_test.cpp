// SPDX-License-Identifier: Apache-2.0
// Case "skinning": skinned models are smoothed where their parts meet, in the bind pose.
#include <gtest/gtest.h>
#include <rakelight/base/error.h>
#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include <string>

#include "math/linear.h"
#include "prepare/normals/bind_pose.h"
#include "prepare/normals/smooth_scene.h"
#include "prepare/prepare_scene.h"
#include "scene/placement.h"
#include "unit/prepare/meshes.h"

namespace rakelight {
namespace {

Transform at(dvec3 translation) {
    Transform t;
    t.translation = translation;
    return t;
}

dmat4 turned(double angle_rad, dvec3 shift) {
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);
    return translation(shift) * dmat4{{{c, 0, -s, 0}, {0, 1, 0, 0}, {s, 0, c, 0}, {0, 0, 0, 1}}};
}

void follow(Mesh& mesh, std::array<float, 4> weights = {1, 0, 0, 0}) {
    mesh.influences = std::vector<JointInfluence>(mesh.positions.size(), {{0, 1, 0, 0}, weights});
}

/// Two squares that share the edge x = 1, the second folded: two nodes with transforms that do not count, and a joint.
Scene two_parts(double fold_rad) {
    const Mesh folded = test::folded_mesh(fold_rad);
    Mesh left = folded, right = folded;
    left.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
    right.indices = std::vector<std::uint32_t>{1, 4, 5, 1, 5, 2};
    follow(left);
    follow(right);
    Scene scene = test::scene_of({left, right});
    scene.nodes[0].local = at({5, 0, 0});
    scene.nodes[1].local = at({0, -7, 2});
    Node joint;
    joint.name = "joint";
    scene.nodes.push_back(joint);
    scene.nodes.push_back(joint);
    scene.skins.resize(1);
    scene.skins[0].joints = {2, 3};
    scene.skins[0].inverse_bind = {dmat4{}, dmat4{}};
    scene.nodes[0].skin = scene.nodes[1].skin = 0;
    return scene;
}

Scene smoothed(const Scene& scene, Context& context) {
    SmoothSceneOptions options;
    options.attributes.crease_angle_rad = pi;
    Scene out = smooth_scene(scene, options, context);
    validate(out);
    return out;
}

/// The normals that both parts have at the common edge, in the left part's space.
void expect_no_seam(const Scene& out, const dmat4& right_to_left = {}) {
    for (const std::uint32_t v : {1u, 2u}) {
        const vec3 a = out.meshes[0].normals[v];
        const dvec3 b = transform_direction(right_to_left, cast<double>(out.meshes[1].normals[v]));
        EXPECT_GT(a.x, 0.1f) << "the neighbor has a say";
        EXPECT_NEAR(length(cast<double>(a) - b), 0, 1e-6);
    }
}

TEST(Skinning, PartsOfOneModelAreSmoothedInTheBindPoseWhateverTheirNodes) {
    const Scene scene = two_parts(radians(40));
    Context context;
    const Scene out = smoothed(scene, context);
    expect_no_seam(out);
    EXPECT_EQ(out.meshes[0].normals[1], out.meshes[1].normals[1]) << "one skin, one matrix: the same bits";
    Scene without = scene;
    for (Node& node : without.nodes) node.skin = no_index;
    EXPECT_EQ(smoothed(without, context).meshes[0].normals[1], (vec3{0, 0, 1})) << "apart they do not touch";
}

TEST(Skinning, SkinsWithAJointInCommonMeetByTheirInverseBindMatrices) {
    // The right part is stored in a space of its own, and the joint stands in a pose far from the bind pose.
    Scene scene = two_parts(radians(40));
    const dmat4 own_to_bind = turned(0.6, {3, 4, 5});
    dmat4 bind_to_own;
    ASSERT_TRUE(inverse_affine(own_to_bind, bind_to_own));
    std::vector<vec3> positions;
    for (const vec3& p : scene.meshes[1].positions)
        positions.push_back(cast<float>(transform_point(bind_to_own, cast<double>(p))));
    scene.meshes[1].positions = positions;
    const dmat4 inverse_bind = turned(-1.1, {0, 2, 0});
    scene.skins.resize(2);
    scene.skins[0].inverse_bind = {inverse_bind, inverse_bind};
    scene.skins[1].joints = {3, 2};
    scene.skins[1].inverse_bind = {dmat4{},
                                   inverse_bind * own_to_bind};  // the first joint is not followed by any vertex
    scene.meshes[1].influences = std::vector<JointInfluence>(6, {{1, 0, 0, 0}, {1, 0, 0, 0}});
    scene.nodes[1].skin = 1;
    scene.nodes[2].local.matrix = turned(2.5, {100, 0, -40});
    Context context;
    expect_no_seam(smoothed(scene, context), own_to_bind);
    EXPECT_EQ(test::remarks(context, Remark::warning, "part in motion"), 0u);
}

TEST(Skinning, AnUnskinnedPartMeetsTheModelWhereTheBonesStand) {
    Scene scene = two_parts(radians(40));
    scene.nodes[2].local = at({1, 2, 3});
    scene.skins[0].inverse_bind = {translation(dvec3{-1, -2, -3}), dmat4{}};  // the joints are in the bind pose
    scene.nodes[1].skin = no_index;
    scene.nodes[1].local = {};
    Context context;
    expect_no_seam(smoothed(scene, context));
}

TEST(Skinning, VerticesOfOnePlaceWithOtherWeightsAreWarnedOf) {
    Scene scene = two_parts(radians(40));
    Context alike;
    smoothed(scene, alike);
    EXPECT_EQ(test::remarks(alike, Remark::warning, "part in motion"), 0u);
    follow(scene.meshes[1], {0.999f, 0.001f, 0, 0});
    Context rounding;
    smoothed(scene, rounding);
    EXPECT_EQ(test::remarks(rounding, Remark::warning, "part in motion"), 0u) << "8-bit weights";
    follow(scene.meshes[1], {0.5f, 0.5f, 0, 0});
    Context context;
    expect_no_seam(smoothed(scene, context));
    EXPECT_EQ(test::remarks(context, Remark::warning, "2 places"), 1u) << test::all_remarks(context);
}

/// Placements of one ball, each with a skin of its own; and of another, whose vertices follow another joint.
Scene skinned_balls(std::uint32_t placements) {
    Scene scene = test::scene_of({test::ball_mesh(64, 32), test::ball_mesh(64, 32)});
    for (Mesh& mesh : scene.meshes) follow(mesh);
    follow(scene.meshes[1], {0.5f, 0.5f, 0, 0});
    scene.skins.resize(placements);
    scene.nodes.resize(placements, scene.nodes[0]);
    for (std::uint32_t i = 0; i < placements; ++i) {
        scene.nodes[i].meshes = {i % 2};
        scene.nodes[i].skin = i;
        scene.skins[i].joints = {placements, placements + 1};
        scene.skins[i].inverse_bind = {dmat4{}, dmat4{}};
    }
    scene.nodes.resize(placements + 2);
    return scene;
}

TEST(Skinning, TheSearchForPartingVerticesStaysWithinTheMemoryBudget) {
    const SmoothSceneOptions flat{{.scope = Scope::face}};  // instances share what is made of their mesh
    const Scene few = skinned_balls(4), many = skinned_balls(1000);
    Context enough({.max_memory = 8 << 20}), too_small({.max_memory = 8 << 20});
    smooth_scene(few, flat, enough);
    EXPECT_EQ(test::remarks(enough, Remark::warning, "part in motion"), 1u) << test::all_remarks(enough);
    smooth_scene(many, flat, too_small);
    EXPECT_EQ(test::remarks(too_small, Remark::warning, "part in motion"), 0u);
    EXPECT_EQ(test::remarks(too_small, Remark::note, "were not searched for places that part in motion"), 1u)
        << test::all_remarks(too_small);
}

TEST(Skinning, PlacementsOfOneMeshUnderOneSkinAreLookedAtOnce) {
    Scene scene = skinned_balls(1000);
    for (std::uint32_t i = 0; i < 1000; ++i) scene.nodes[i].skin = i % 2;
    Context context({.max_memory = 8 << 20});
    smooth_scene(scene, {{.scope = Scope::face}}, context);
    EXPECT_EQ(test::remarks(context, Remark::warning, std::to_string(64 * 31 + 2) + " places"), 1u)
        << test::all_remarks(context);
}

TEST(Skinning, TheSearchForPartingVerticesCanBeCancelled) {
    const Scene scene = skinned_balls(50);
    const std::vector<dmat4> place = bind_pose_matrices(scene);
    const std::vector<Instance> instances = drawn_instances(scene);
    Context context;
    context.cancel();
    try {
        warn_of_parting_vertices(scene, instances, place, context);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::failed);
    }
}

TEST(Skinning, TheSameJointsInAnotherOrderAreTheSame) {
    Scene scene = two_parts(radians(40));
    scene.meshes[0].influences = std::vector<JointInfluence>(6, {{0, 1, 0, 0}, {0.25f, 0.75f, 0, 0}});
    scene.meshes[1].influences = std::vector<JointInfluence>(6, {{1, 0, 0, 1}, {0.5f, 0.25f, 0, 0.25f}});
    Context context;
    smoothed(scene, context);
    EXPECT_EQ(test::remarks(context, Remark::warning, "part in motion"), 0u);
}

TEST(Skinning, BrokenSkinsLeaveTheNodesOwnPlace) {
    for (const dmat4& broken : {dmat4{{{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 1}}},
                                dmat4{{{1, 0, 0, 0.5}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}}}) {
        Scene scene = two_parts(radians(40));
        scene.skins[0].inverse_bind = {broken, broken};
        EXPECT_EQ(bind_pose_matrices(scene), world_matrices(scene));
        Context context;
        const Scene result = smoothed(scene, context);
        for (const vec3& n : result.meshes[0].normals) EXPECT_TRUE(is_finite(n));
    }
    Scene unused = two_parts(radians(40));
    for (Mesh& mesh : unused.meshes) follow(mesh, {0, 0, 0, 0});
    EXPECT_EQ(bind_pose_matrices(unused), world_matrices(unused));
    EXPECT_TRUE(bind_pose_matrices(Scene{}).empty());
}

}  // namespace
}  // namespace rakelight
