// SPDX-License-Identifier: Apache-2.0
// Authored normals of a scene joined at borders: what turns along, what stays shared, poses, mirrors and instances.
#include <gtest/gtest.h>

#include <cmath>

#include <rakelight/prepare/prepare.h>

#include "math/linear.h"
#include "prepare/normals/repair_seams.h"

namespace rakelight {
namespace {

/// A square in the plane y = 0 from x = `from` to `from` + 1, normals leaning by `lean` along x at both ends.
Mesh square(float from, float lean) {
    Mesh mesh;
    mesh.positions = std::vector<vec3>{{from, 0, 0}, {from, 0, 1}, {from + 1, 0, 1}, {from + 1, 0, 0}};
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
    const vec3 n = cast<float>(normalize_or(dvec3{lean, 1, 0}, dvec3{}));
    mesh.normals = std::vector<vec3>{n, n, n, n};
    const vec3 t = cast<float>(normalize_or(dvec3{1, -lean, 0}, dvec3{}));
    const vec4 tangent{t.x, t.y, t.z, -1};
    mesh.tangents = std::vector<vec4>{tangent, tangent, tangent, tangent};
    return mesh;
}

Node at(std::uint32_t mesh, dmat4 place = {}) {
    Node node;
    node.meshes = {mesh};
    node.local.matrix = place;
    return node;
}

/// Two squares that meet at x = 1 and lean apart.
Scene two_squares() {
    Scene scene;
    scene.meshes = {square(0, -0.1f), square(1, 0.3f)};
    scene.nodes = {at(0), at(1)};
    return scene;
}

Scene repaired(const Scene& scene, SeamReport* seams = nullptr) {
    Context context({.threads = 2});
    return repair_seams(scene, {}, context, seams);
}

TEST(RepairSeams, BorderTurnsTangentsTurnAlongAllElseKeepsItsBits) {
    const Scene before = two_squares();
    SeamReport seams;
    const Scene after = repaired(before, &seams);
    EXPECT_EQ(seams.turned, 4u);
    EXPECT_EQ(seams.normals, 8u);
    for (std::size_t m = 0; m < 2; ++m) {
        const Mesh &a = before.meshes[m], &b = after.meshes[m];
        EXPECT_EQ(a.positions, b.positions) << "shared";
        EXPECT_EQ(a.indices, b.indices);
        for (std::size_t v = 0; v < 4; ++v) {
            const bool at_border = a.positions[v].x == 1;
            EXPECT_EQ(a.normals[v] == b.normals[v], !at_border);
            EXPECT_EQ(a.tangents[v] == b.tangents[v], !at_border);
            EXPECT_NEAR(dot(b.normals[v], b.tangents[v].xyz()), 0, 1e-6);
            EXPECT_EQ(b.tangents[v].w, -1);
            EXPECT_NEAR(b.tangents[v].z, 0, 1e-6) << "turned about z";
        }
    }
    EXPECT_EQ(after.meshes[0].normals[2], after.meshes[1].normals[1]);
    EXPECT_EQ(after.meshes[0].normals[3], after.meshes[1].normals[0]);
}

TEST(RepairSeams, WithoutAnythingToDoTheArraysAreTheSame) {
    Scene scene = two_squares();
    scene.nodes[1].local.matrix = translation(dvec3{0, 1, 0});
    const Scene after = repaired(scene);
    for (std::size_t m = 0; m < 2; ++m) EXPECT_TRUE(after.meshes[m] == scene.meshes[m]);
}

TEST(RepairSeams, OneObjectSplitByMaterialHasABorderToo) {
    Scene scene = two_squares();
    scene.nodes = {at(0)};
    scene.nodes[0].meshes = {0, 1};
    SeamReport seams;
    repaired(scene, &seams);
    EXPECT_EQ(seams.turned, 4u);
}

TEST(RepairSeams, MeshesThatShareOneArrayOfVerticesGoOnSharingIt) {
    // The left square uses vertices 0 to 3, the right one 4 to 7, of the same arrays.
    Scene scene = two_squares();
    const Mesh &a = scene.meshes[0], &b = scene.meshes[1];
    const auto both = [](const auto& x, const auto& y) {
        std::vector values(x.begin(), x.end());
        values.insert(values.end(), y.begin(), y.end());
        return values;
    };
    Mesh left;
    left.positions = both(a.positions, b.positions);
    left.normals = both(a.normals, b.normals);
    left.tangents = both(a.tangents, b.tangents);
    left.indices = a.indices;
    Mesh right = left;
    right.indices = std::vector<std::uint32_t>{4, 5, 6, 4, 6, 7};
    const Scene apart = repaired(scene);
    scene.meshes = {left, right};
    const Scene after = repaired(scene);
    EXPECT_EQ(after.meshes[0].normals.identity(), after.meshes[1].normals.identity());
    EXPECT_EQ(after.meshes[0].tangents.identity(), after.meshes[1].tangents.identity());
    for (std::size_t v = 0; v < 4; ++v) {
        EXPECT_EQ(after.meshes[0].normals[v], apart.meshes[0].normals[v]);
        EXPECT_EQ(after.meshes[0].normals[4 + v], apart.meshes[1].normals[v]);
    }
    // A second placement of the left one that touches nothing wants the old normals.
    scene.nodes.push_back(at(0, translation(dvec3{0, 9, 0})));
    const Scene other = repaired(scene);
    EXPECT_EQ(other.meshes.size(), 3u);
    EXPECT_EQ(other.meshes[other.nodes[2].meshes[0]].normals[2], left.normals[2]);
    EXPECT_EQ(other.meshes[other.nodes[0].meshes[0]].normals[2], apart.meshes[0].normals[2]);
}

TEST(RepairSeams, MorphTargetsTurnAlong) {
    Scene scene = two_squares();
    MorphTarget target;
    target.normals = std::vector<vec3>(4, vec3{0, 0, 0.5f});
    target.positions = std::vector<vec3>(4, vec3{0, 0.1f, 0});
    scene.meshes[0].targets = {target};
    const Scene after = repaired(scene);
    const MorphTarget& turned = after.meshes[0].targets[0];
    EXPECT_EQ(turned.positions, target.positions);
    EXPECT_EQ(turned.normals[0], target.normals[0]) << "away from the border";
    EXPECT_NEAR(turned.normals[2].z, 0.5, 1e-6) << "along the axis of the turn";
}

/// Both instances of one mesh meet: the first on its right side, the second, mirrored, on its left one.
TEST(RepairSeams, InstancesThatTouchDifferentThingsGetAMeshOfTheirOwnAndMirrorsAreSeenInTheWorld) {
    Scene scene;
    scene.meshes = {square(0, 0.2f)};
    scene.nodes = {at(0), at(0, translation(dvec3{2, 0, 0}) * scaling(dvec3{-1, 1, 1}))};
    SeamReport seams;
    const Scene after = repaired(scene, &seams);
    EXPECT_EQ(seams.turned, 4u);
    EXPECT_EQ(after.meshes.size(), 1u) << "a mirror image: one mesh is right for both";
    EXPECT_NEAR(after.meshes[0].normals[2].x, 0, 1e-6);
    EXPECT_EQ(after.meshes[0].normals[0], scene.meshes[0].normals[0]);
    scene.nodes[1] = at(0, translation(dvec3{1, 0, 0}));
    scene.meshes[0].normals = std::vector<vec3>{{0, 1, 0}, {0, 1, 0}, {0.6f, 0.8f, 0}, {0.6f, 0.8f, 0}};
    const Scene apart = repaired(scene, &seams);
    EXPECT_EQ(apart.meshes.size(), 2u);
    Context context;
    EXPECT_EQ(repair_seams(scene, {}, context, nullptr, true).meshes.size(), 1u) << "kept shared";
}

Scene skinned(Scene scene) {
    for (Mesh& mesh : scene.meshes) {
        JointInfluence influence;
        influence.weights[0] = 1;
        mesh.influences = std::vector<JointInfluence>(mesh.positions.size(), influence);
    }
    Node joint;
    joint.local.translation = {0, 5, 0};
    scene.nodes.push_back(joint);
    scene.skins = {{"", {2}, {translation(dvec3{0, -5, 0})}}};
    scene.nodes[0].skin = scene.nodes[1].skin = 0;
    scene.nodes[1].local.matrix = translation(dvec3{9, 9, 9});  // does not count
    return scene;
}

TEST(RepairSeams, SkinnedMeshesMeetInTheirBindPose) {
    SeamReport seams;
    repaired(skinned(two_squares()), &seams);
    EXPECT_EQ(seams.turned, 4u);
}

/// Two squares that bend by 45 degrees where they meet, with normals that lean as on a round edge.
Scene bent_squares() {
    Scene scene = two_squares();
    const float half = std::sqrt(0.5f);
    scene.meshes[0] = square(0, 0.3f);
    Mesh& bent = scene.meshes[1];
    bent.positions = std::vector<vec3>{{1, 0, 0}, {1, 0, 1}, {1 + half, -half, 1}, {1 + half, -half, 0}};
    bent.normals = std::vector<vec3>(4, cast<float>(normalize_or(dvec3{0.3, 0.8, 0}, dvec3{})));
    bent.tangents = {};
    return scene;
}

TEST(RepairSeams, TheRuleOfCreasesDecidesInTheBindPoseToo) {
    for (const Scene& bent : {bent_squares(), skinned(bent_squares())}) {
        SeamReport seams;
        repaired(bent, &seams);
        EXPECT_EQ(seams.turned, 4u) << "45 degrees";
        Context context;
        repair_seams(bent, {.creases = Creasing::automatic}, context, &seams);
        EXPECT_EQ(seams.turned, 0u) << "two planes";
    }
    SeamReport seams;
    Context context;
    repair_seams(skinned(two_squares()), {.creases = Creasing::automatic}, context, &seams);
    EXPECT_EQ(seams.turned, 4u) << "one plane";
}

TEST(PrepareSeams, FollowTheRuleOfCreases) {
    const Scene bent = bent_squares();
    Context context;
    const auto turned = [&](Creasing creases) {
        const Scene after = prepare_scene(bent, {.normals = NormalSource::seams, .creases = creases}, context);
        return !(after.meshes[0].normals == bent.meshes[0].normals);
    };
    EXPECT_TRUE(turned(Creasing::angle));
    EXPECT_FALSE(turned(Creasing::automatic));
}

TEST(PrepareSeams, AreJoinedForPicturesThatAskAndForPartsThatDo) {
    Context context;
    const Scene scene = two_squares();
    const auto turned = [&](const Scene& given, NormalSource source) {
        const Scene after = prepare_scene(given, {.normals = source}, context);
        return !(after.meshes[0].normals == given.meshes[0].normals);
    };
    EXPECT_FALSE(turned(scene, NormalSource::automatic));
    EXPECT_FALSE(turned(scene, NormalSource::file));
    EXPECT_TRUE(turned(scene, NormalSource::seams));
    Scene asking = scene;
    asking.meshes[0].normal_choice = NormalChoice{.source = NormalSource::seams};
    EXPECT_FALSE(turned(asking, NormalSource::automatic)) << "one alone has nobody to join";
    asking.meshes[1].normal_choice = NormalChoice{.source = NormalSource::seams};
    EXPECT_TRUE(turned(asking, NormalSource::automatic));
    asking.meshes[1].normal_choice->crease_angle_rad = 0;
    EXPECT_TRUE(turned(asking, NormalSource::automatic)) << "faces of one plane";
}

TEST(PrepareSeams, WhatHasNoNormalsGetsTheAuthorsAtTheBorder) {
    Scene scene = two_squares();
    scene.meshes[1].normals = {};
    scene.meshes[1].tangents = {};
    Context context;
    const Scene after = prepare_scene(scene, {.normals = NormalSource::seams}, context);
    EXPECT_EQ(after.meshes[0].normals[2], after.meshes[1].normals[1]);
    EXPECT_EQ(after.meshes[0].normals[2], scene.meshes[0].normals[2]);
}

}  // namespace
}  // namespace rakelight
