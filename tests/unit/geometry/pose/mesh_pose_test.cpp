// SPDX-License-Identifier: Apache-2.0
// Meshes with what poses them: boxes without arrays, and arrays that nothing moves.
#include "geometry/pose/mesh_pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "math/linear.h"

namespace rakelight::geometry {
namespace {

/// Three joints, eight to every third vertex, two targets.
MeshPose random_pose(std::size_t vertices, bool is_skinned, bool is_morphed) {
    std::mt19937 random{11};
    std::uniform_real_distribution<float> number(-1, 1);
    const auto vectors = [&] {
        std::vector<vec3> out(vertices);
        for (vec3& v : out) v = {number(random), number(random), number(random)};
        return out;
    };
    MeshPose pose{.positions = vectors(), .normals = vectors()};
    if (is_morphed) {
        pose.targets = {{"a", vectors(), {}, {}}, {"b", vectors(), {}, {}}, {"c", vectors(), vectors(), {}}};
        pose.weights = {0.75f, 0, -2};
    }
    if (!is_skinned) return pose;
    std::vector<JointInfluence> first(vertices), more(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
        first[v] = {{0, 1, 2, 1}, {std::fabs(number(random)), 0.25f, number(random), 0}};
        if (v % 3 == 0) more[v] = {{2, 0, 0, 0}, {0.5f, 0, 0, 0}};
    }
    pose.influences = std::move(first), pose.more_influences = std::move(more);
    pose.joints = {columns_of(translation(dvec3{1, 2, 3})), columns_of(scaling(dvec3{2, -3, 0.5})),
                   columns_of(translation(dvec3{-4, 0, 0}) * scaling(dvec3{0.1, 5, 1}))};
    return pose;
}

TEST(MeshPose, ItsBoxIsThatOfThePosedPositionsToTheBit) {
    for (const std::size_t vertices : {1u, 15u, 1023u, 1025u, 5000u})
        for (const bool is_skinned : {false, true})
            for (const bool is_morphed : {false, true}) {
                const MeshPose pose = random_pose(vertices, is_skinned, is_morphed);
                Context one({.threads = 1}), two({.threads = 2});
                Box wanted = empty_box();
                extend_box(posed_arrays(pose, one).positions, wanted.low, wanted.high);
                const Box got = posed_box(pose, two);
                EXPECT_EQ(got.low, wanted.low) << vertices << is_skinned << is_morphed;
                EXPECT_EQ(got.high, wanted.high) << vertices << is_skinned << is_morphed;
            }
}

TEST(MeshPose, VerticesThatAreNotFiniteAreOutsideOfItsBox) {
    MeshPose pose = random_pose(3, false, false);
    pose.positions = std::vector<vec3>{{1, 2, 3}, {std::numeric_limits<float>::quiet_NaN(), 9, 9}, {-1, 0, 4}};
    Context context;
    EXPECT_EQ(posed_box(pose, context).low, (vec3{-1, 0, 3}));
    EXPECT_EQ(posed_box(pose, context).high, (vec3{1, 2, 4}));
}

TEST(MeshPose, ArraysThatNothingMovesAreShared) {
    Context context;
    MeshPose still = random_pose(40, false, true);
    still.weights = {};
    EXPECT_FALSE(still.moves());
    EXPECT_EQ(posed_arrays(still, context).positions.identity(), still.positions.identity());
    still.weights = {1};  // the first has no normals
    EXPECT_TRUE(still.moves());
    const PosedArrays arrays = posed_arrays(still, context);
    EXPECT_NE(arrays.positions.identity(), still.positions.identity());
    EXPECT_EQ(arrays.normals.identity(), still.normals.identity());
}

}  // namespace
}  // namespace rakelight::geometry
