// SPDX-License-Identifier: Apache-2.0
// Borders without shared vertices in motion: what agrees at rest agrees in every frame of a clip.
#include <gtest/gtest.h>

#include <algorithm>

#include <rakelight/prepare/prepare.h>
#include <rakelight/scene/motion.h>

#include "near_borders.h"
#include "prepare/prepare_scene.h"

namespace rakelight {
namespace {

using namespace near_borders;

constexpr int rings = 4;
constexpr PrepareOptions joined{.normals = NormalSource::model, .border_distance = 0.02};

/// The two halves of a tube, bent by a clip: one joint at each end, weights along z.
Scene bending_tube() {
    Scene scene = two_halves(rings, 0);
    for (std::uint32_t m = 0; m < 2; ++m) {
        Mesh& mesh = scene.meshes[m];
        std::vector<JointInfluence> influences;
        for (const vec3 p : mesh.positions)
            influences.push_back({.joints = {0, 1, 0, 0}, .weights = {1 - p.z / 4, p.z / 4, 0, 0}});
        mesh.influences = std::move(influences);
        scene.nodes[m].skin = 0;
    }
    std::vector<vec3> positions(scene.meshes[1].positions.begin(), scene.meshes[1].positions.end());
    for (vec3& p : positions) p.x += 0.01f;
    scene.meshes[1].positions = std::move(positions);
    Node first, last;
    last.local.translation = {0, 0, 4};
    scene.nodes.push_back(first), scene.nodes.push_back(last);
    scene.skins = {{"", {2, 3}, {dmat4{}, translation(dvec3{0, 0, -4})}}};
    Animation bend;
    AnimationChannel turn;
    turn.element = 3, turn.path = AnimationPath::rotation;
    turn.times = std::vector<float>{0, 1};
    turn.values = std::vector<float>{0, 0, 0, 1, 0.5f, 0, 0, 0.8660254f};
    bend.channels = {turn};
    scene.animations = {bend};
    return scene;
}

Scene at_time(const Scene& scene, double time_s) {
    const ClipTime clip{0, time_s};
    return scene_at(scene, std::span(&clip, 1));
}

/// [degrees] the largest along both borders of the second half: at its vertices, to the first one's interpolation.
double largest_seam(const Scene& posed) {
    const Block<vec3>&left = posed.meshes[0].normals, &right = posed.meshes[1].normals;
    double largest = 0;
    for (const auto& [mine, other] : {std::pair{0, 8}, std::pair{8, 0}})
        for (int ring = 0; ring <= 2 * rings; ++ring) {
            const vec3 a = left[std::size_t(9 * (ring / 2) + other)],
                       b = left[std::size_t(9 * ((ring + 1) / 2) + other)];
            const vec3 between = normalize_or(a + b, vec3{});
            largest =
                std::max(largest, degrees(double(length(between - right[std::size_t(9 * ring + mine)]))));  // small
        }
    return largest;
}

TEST(PoseBorders, MadeNormalsAgreeInEveryFrame) {
    const Scene tube = bending_tube();
    Context context;
    const BoundScene bound = bind_scene(tube, joined, context);
    EXPECT_EQ(bound.made.size(), 1u);
    EXPECT_EQ(bound.borders.size(), 1u);
    vec3 rest, bent;
    for (int frame = 0; frame <= 10; ++frame) {
        const Scene moment = at_time(tube, frame / 10.0);
        const Scene posed = finish_scene(bound, moment.pose, joined, context);
        EXPECT_LT(largest_seam(posed), 0.02) << "frame " << frame;
        (frame == 0 ? rest : bent) = posed.meshes[1].normals[9 * 6];
        const Scene alone = prepare_scene(moment, joined, context);
        for (std::size_t m = 0; m < 2; ++m)
            EXPECT_TRUE(std::ranges::equal(posed.meshes[m].normals.span(), alone.meshes[m].normals.span())) << frame;
        PrepareOptions without = joined;
        without.border_distance = 0;
        EXPECT_GT(largest_seam(prepare_scene(moment, without, context)), 15) << "else there is nothing to join";
    }
    EXPECT_GT(length(rest - bent), 0.3f) << "it moves";
}

TEST(PoseBorders, TheFilesNormalsAgreeInEveryFrameToo) {
    Context context;
    Scene tube = bending_tube();
    BoundScene apart = bind_scene(tube, {.normals = NormalSource::object}, context);
    tube = std::move(apart.scene);  // smooth inside each half
    const PrepareOptions file{.border_distance = 0.02};
    const BoundScene bound = bind_scene(tube, file, context);
    EXPECT_TRUE(bound.made.empty());
    for (int frame = 0; frame <= 10; ++frame) {
        const Scene posed = finish_scene(bound, at_time(tube, frame / 10.0).pose, file, context);
        EXPECT_LT(largest_seam(posed), 0.02) << "frame " << frame;
    }
}

/// Parts that hang from nodes, as those of machines: their normals are joined at rest, and go along.
TEST(PoseBorders, PartsThatDoNotBendKeepTheNormalsOfTheirRest) {
    Scene scene = two_halves(rings, 0.01);
    Animation clip;
    AnimationChannel move;
    move.element = 1, move.path = AnimationPath::translation;
    move.times = std::vector<float>{0, 1};
    move.values = std::vector<float>{0, 0, 0, 5, 0, 0};
    clip.channels = {move};
    scene.animations = {clip};
    scene.nodes[1].local = {};
    scene.nodes[1].local.translation = {0.01, 0, 0};
    Context context;
    const Scene rest = prepare_scene(scene, joined, context), moved = prepare_scene(at_time(scene, 1), joined, context);
    EXPECT_LT(largest_seam(rest), 0.02);
    for (std::size_t m = 0; m < 2; ++m)
        EXPECT_TRUE(std::ranges::equal(rest.meshes[m].normals.span(), moved.meshes[m].normals.span()));
}

/// A mesh that stands still and is shown twice; only one of its placements touches what moves.
TEST(PoseBorders, StillInstancesGetAMeshOfTheirOwnInEveryPose) {
    Scene scene = bending_tube();
    scene.meshes.push_back(half_tube(90, rings, 4));
    scene.nodes.push_back(at(2, translation(dvec3{0, 0, -4.01})));
    scene.nodes.push_back(at(2, translation(dvec3{0, 50, 0})));
    Context context;
    const BoundScene bound = bind_scene(scene, joined, context);
    const Scene posed = finish_scene(bound, at_time(scene, 0).pose, joined, context);
    const Mesh &near = posed.meshes[posed.nodes[4].meshes[0]], &far = posed.meshes[posed.nodes[5].meshes[0]];
    EXPECT_LT(length(near.normals[9 * rings + 4] - posed.meshes[0].normals[4]), 1e-3f);
    EXPECT_NE(posed.nodes[4].meshes[0], posed.nodes[5].meshes[0]);
    EXPECT_NE(near.normals[9 * rings], far.normals[9 * rings]);
}

}  // namespace
}  // namespace rakelight
