// SPDX-License-Identifier: Apache-2.0
// Preparing within a limit of memory.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include <rakelight/base/error.h>

#include "prepare/prepare_scene.h"
#include "prepare/project_texcoords.h"
#include "unit/prepare/meshes.h"
#include "unit/prepare/prepared.h"

namespace rakelight {
namespace {

using test::by;
using test::scene_of;

TEST(PrepareBudget, EachStageIsRefusedBeforeItMakesWhatTheBudgetHasNoRoomFor) {
    Scene scene = scene_of({test::ball_mesh(32, 32)});
    scene.nodes.resize(8, scene.nodes[0]);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) scene.nodes[i].local.translation = {1.5 * double(i), 0, 0};
    PrepareOptions all;
    all.uv = UvProjection::box;
    all.subdivision.level = 1;
    all.all_tangents = all.clockwise_fronts = true;
    std::set<std::string> stages;
    for (std::uint64_t limit = 1 << 20; !stages.contains("all") && limit < 1u << 30; limit += limit / 8) {
        Context context({.max_memory = limit});
        try {
            const Scene out = prepare_scene(scene, all, context);
            EXPECT_GT(context.memory().charged(), 8 * 4000u * (12 + 12 + 16 + 8)) << "arrays of the result";
            stages.insert("all");
        } catch (const Error& error) {
            stages.insert(error.reason().substr(0, error.reason().find(" needs ")));
        }
        EXPECT_EQ(context.memory().charged(), 0u) << limit;
    }
    EXPECT_TRUE(stages.contains("all"));
    EXPECT_GE(stages.size(), 4u);
    EXPECT_FALSE(stages.contains("the prepared scene")) << "refused when it was made already";
}

/// [bytes] The limit, to a sixty-fourth, under which the scene can be prepared.
std::uint64_t least_memory(const Scene& scene, const PrepareOptions& options) {
    for (std::uint64_t limit = 1 << 20;; limit += limit / 64) {
        Context context({.max_memory = limit});
        try {
            prepare_scene(scene, options, context);
            return limit;
        } catch (const Error&) {
        }
    }
}

TEST(PrepareBudget, AStageCountsWhatTheStagesBeforeHaveMade) {
    Scene scene = scene_of({test::ball_mesh(32, 32)});
    scene.nodes.resize(16, scene.nodes[0]);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) scene.nodes[i].local.translation = {1.5 * double(i), 0, 0};
    Context made;
    const Scene projected = project_texcoords(scene, UvProjection::box, made);  // paid there, not where it is prepared
    const std::uint64_t arrays = made.memory().charged();
    PrepareOptions smooth = by(NormalSource::model);
    smooth.weight = CornerWeight::angle;  // fits take more than the arrays
    PrepareOptions both = smooth;
    both.uv = UvProjection::box;
    const std::uint64_t alone = least_memory(projected, smooth);
    EXPECT_GT(arrays, alone / 8) << "it makes a difference";
    EXPECT_GT(least_memory(scene, both), alone + arrays - alone / 16);
}

TEST(PrepareBudget, FlatNormalsOfAllMeshesTogetherStayWithinTheMemoryBudget) {
    Scene scene = scene_of({test::ball_mesh(32, 32), test::ball_mesh(32, 32), test::ball_mesh(32, 32)});
    const std::size_t vertices = scene.meshes[0].positions.size(), corners = scene.meshes[0].indices.size();
    for (Mesh& mesh : scene.meshes) mesh.texcoords.assign(100, std::vector<vec2>(vertices));
    // A flat face has vertices of its own: a position, a normal and 100 texture coordinates.
    const std::uint64_t bytes = corners * (24 + 800);
    Context enough({.max_memory = 4 * bytes}), for_two({.max_memory = 2 * bytes + bytes / 2});
    EXPECT_EQ(prepare_scene(scene, by(NormalSource::flat), enough).meshes[2].positions.size(), corners);
    EXPECT_THROW(prepare_scene(scene, by(NormalSource::flat), for_two), Error);
    EXPECT_NO_THROW(prepare_scene(scene, by(NormalSource::model), for_two));  // no vertex splits
}

}  // namespace
}  // namespace rakelight
