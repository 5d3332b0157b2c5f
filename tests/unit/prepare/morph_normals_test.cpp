// SPDX-License-Identifier: Apache-2.0
// Normals of morph targets: base plus offset is the normal of the morphed surface.
#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include "math/linear.h"
#include "prepare/normals/morph_normals.h"
#include "prepare/normals/smooth_scene.h"
#include "prepare/prepare_scene.h"
#include "scene/placement.h"
#include "support/scene_builder.h"
#include "unit/prepare/meshes.h"

namespace rakelight {
namespace {

using test::ball_mesh;
using test::cube_mesh;
using test::scene_of;

SmoothSceneOptions all_joined() {
    SmoothSceneOptions options;
    options.attributes.crease_angle_rad = pi;
    options.attributes.tangents = false;
    return options;
}

/// Offsets that make an ellipsoid of a ball, uneven and not through the center.
std::vector<vec3> stretching(const Mesh& mesh) {
    std::vector<vec3> offsets;
    for (const vec3& p : mesh.positions) offsets.push_back({0.5f * p.x + 0.2f * p.y, 0, -0.4f * p.z});
    return offsets;
}

Mesh moved(Mesh mesh, const Block<vec3>& offsets) {
    std::vector<vec3> positions;
    for (std::size_t v = 0; v < offsets.size(); ++v) positions.push_back(mesh.positions[v] + offsets[v]);
    mesh.positions = std::move(positions);
    mesh.targets = {};
    return mesh;
}

/// Upper and lower half of a ball as two meshes, each with its own vertices.
std::vector<Mesh> halves_of(const Mesh& ball) {
    std::vector<Mesh> halves(2, ball);
    for (int h = 0; h < 2; ++h) {
        std::vector<std::uint32_t> kept;
        for (std::size_t t = 0; t < ball.triangle_count(); ++t) {
            float y = 0;
            for (std::size_t k = 0; k < 3; ++k) y += ball.positions[ball.indices[3 * t + k]].y;
            if ((y > 0) == (h == 0))
                for (std::size_t k = 0; k < 3; ++k) kept.push_back(ball.indices[3 * t + k]);
        }
        halves[std::size_t(h)].indices = std::move(kept);
    }
    return halves;
}

TEST(MorphNormals, BasePlusOffsetIsTheNormalOfTheMorphedSurface) {
    Mesh ball = ball_mesh(24, 12);
    ball.targets = {{"stretch", stretching(ball), {}, {}}, {"none", std::vector<vec3>(ball.positions.size()), {}, {}}};
    Context context;
    const Mesh after = smooth_scene(scene_of({ball}), all_joined(), context).meshes[0];
    const Mesh expected =
        smooth_scene(scene_of({moved(ball, ball.targets[0].positions)}), all_joined(), context).meshes[0];
    ASSERT_EQ(after.targets[0].normals.size(), after.positions.size());
    float change = 0;
    for (std::size_t v = 0; v < after.positions.size(); ++v) {
        EXPECT_NEAR(length(after.normals[v] + after.targets[0].normals[v] - expected.normals[v]), 0, 1e-6) << v;
        EXPECT_EQ(after.targets[1].normals[v], (vec3{0, 0, 0})) << "what does not move does not turn";
        change = std::max(change, length(after.targets[0].normals[v]));
    }
    EXPECT_GT(change, 0.2f);
    EXPECT_EQ(test::remarks(context, Remark::dropped, "morph targets"), 0u);
}

TEST(MorphNormals, SplitVerticesCarryAndCreasesStayWhereTheyWere) {
    Mesh mesh = test::folded_mesh(radians(80));
    const Mesh flat = test::folded_mesh(radians(10));  // unfolds below the crease angle: still two groups
    std::vector<vec3> offsets;
    for (std::size_t v = 0; v < 6; ++v) offsets.push_back(flat.positions[v] - mesh.positions[v]);
    mesh.targets = {{"", offsets, {}, {}}};
    SmoothSceneOptions options = all_joined();
    options.attributes.crease_angle_rad = radians(60);
    Context context;
    const Scene out = smooth_scene(scene_of({mesh}), options, context);
    validate(out);
    const Mesh& after = out.meshes[0];
    ASSERT_EQ(after.positions.size(), 8u);
    ASSERT_EQ(after.targets[0].positions.size(), 8u);
    ASSERT_EQ(after.targets[0].normals.size(), 8u);
    const dvec3 left{0, 0, 1}, right{std::sin(radians(10)), 0, std::cos(radians(10))};
    for (std::size_t c = 0; c < after.indices.size(); ++c) {
        const std::uint32_t v = after.indices[c];
        const vec3 n = after.normals[v] + after.targets[0].normals[v];
        EXPECT_NEAR(length(cast<double>(n) - (c < 6 ? left : right)), 0, 1e-6) << c;
    }
}

TEST(MorphNormals, PartsWhoseTargetsHaveOneNameMoveTogether) {
    const Mesh ball = ball_mesh(24, 12);
    std::vector<Mesh> halves = halves_of(ball);
    for (Mesh& half : halves) {
        half.targets = {{"smile", stretching(half), {}, {}}};
    }
    Context context;
    const Scene scene = scene_of(halves);
    const Scene out = smooth_scene(scene, all_joined(), context);
    const Mesh whole =
        smooth_scene(scene_of({moved(ball, halves[0].targets[0].positions)}), all_joined(), context).meshes[0];
    std::vector<std::uint8_t> uses(ball.positions.size(), 0);
    for (std::size_t h = 0; h < 2; ++h)
        for (const std::uint32_t v : out.meshes[h].indices) {
            uses[v] |= std::uint8_t(1 << h);
            EXPECT_NEAR(length(out.meshes[h].normals[v] + out.meshes[h].targets[0].normals[v] - whole.normals[v]), 0,
                        1e-6);
        }
    std::size_t border = 0;
    for (std::size_t v = 0; v < uses.size(); ++v) {
        if (uses[v] != 3) continue;
        ++border;
        EXPECT_EQ(out.meshes[0].targets[0].normals[v], out.meshes[1].targets[0].normals[v]);
    }
    EXPECT_EQ(border, 24u);
    Scene other = scene;  // another name: the neighbor stands still meanwhile
    other.meshes[1].targets = test::changed(other.meshes[1].targets, [](auto& targets) { targets[0].name = "blink"; });
    const Scene apart = smooth_scene(other, all_joined(), context);
    bool differs = false;
    for (const std::uint32_t v : apart.meshes[0].indices)
        differs = differs || !(apart.meshes[0].targets[0].normals[v] == out.meshes[0].targets[0].normals[v]);
    EXPECT_TRUE(differs);
}

TEST(MorphNormals, MovementsOfModelsThatDoNotTouchStandInOnePose) {
    std::vector<Mesh> meshes(3, ball_mesh(8, 4));
    for (std::size_t m = 0; m < meshes.size(); ++m)
        for (const char* name : {"smile", "blink"}) {
            MorphTarget target;
            target.name = name + std::to_string(m);  // no two of one name
            target.positions = stretching(meshes[m]);
            meshes[m].targets = test::with(meshes[m].targets, std::move(target));
        }
    const Scene scene = scene_of(meshes);
    const std::vector<std::uint32_t> numbers{0, 1, 2}, apart{0, 1, 2}, touching{0, 0, 2};
    const std::vector<MorphPose> poses = morph_poses(scene, numbers, apart);
    ASSERT_EQ(poses.size(), 2u);
    for (std::size_t p = 0; p < 2; ++p) {
        ASSERT_EQ(poses[p].targets.size(), 3u);
        for (std::size_t m = 0; m < 3; ++m)
            EXPECT_EQ(poses[p].targets[m], std::pair(std::uint32_t(m), std::uint32_t(p)));
    }
    EXPECT_EQ(morph_poses(scene, numbers, touching).size(), 4u) << "one stands still while its neighbor moves";
}

TEST(MorphNormals, AModelFarOffChangesNothing) {
    Mesh ball = ball_mesh(24, 12);
    ball.targets = {{"stretch", stretching(ball), {}, {}}};
    Mesh far = ball;
    far.targets = test::changed(far.targets, [](auto& targets) { targets[0].name = "squeeze"; });
    Scene both = scene_of({ball, far});
    both.nodes[1].local.translation = {100, 0, 0};
    Context context;
    const Scene out = smooth_scene(both, all_joined(), context);
    const Mesh alone = smooth_scene(scene_of({ball}), all_joined(), context).meshes[0];
    for (const Mesh& mesh : out.meshes) {
        ASSERT_EQ(mesh.targets[0].normals.size(), alone.targets[0].normals.size());
        for (std::size_t v = 0; v < alone.positions.size(); ++v)
            EXPECT_EQ(mesh.targets[0].normals[v], alone.targets[0].normals[v]) << v;
    }
}

TEST(MorphNormals, TargetsThatKeptTheNormalsOfTheirMeshGoOnDoingSo) {
    Mesh ball = ball_mesh(12, 6);
    ball.normals = std::vector<vec3>(ball.positions.size(), {0, 0, 1});
    const Block<vec3> offsets = stretching(ball);
    ball.targets = {{"", offsets, {}, {}},
                    {"with normals", offsets, std::vector<vec3>(ball.positions.size(), {0.1f, 0, 0}), {}}};
    Context context;
    const Mesh after = smooth_scene(scene_of({ball}), all_joined(), context).meshes[0];
    EXPECT_TRUE(after.targets[0].normals.empty());
    EXPECT_EQ(after.targets[1].normals.size(), after.positions.size());
    EXPECT_NE(after.targets[1].normals[1], (vec3{0.1f, 0, 0}));
}

TEST(MorphNormals, TargetsWithoutPositionsAreRefusedAloud) {
    Mesh cube = cube_mesh();
    cube.targets = {{"", {}, std::vector<vec3>(8, {0, 0.5f, 0}), {}}};
    Context context;
    const Mesh after = smooth_scene(scene_of({cube}), all_joined(), context).meshes[0];
    EXPECT_TRUE(after.targets[0].normals.empty());
    EXPECT_EQ(test::remarks(context, Remark::dropped, "morph targets"), 1u);
}

TEST(MorphNormals, TangentsOfTargetsFollowToo) {
    Mesh mesh = test::folded_mesh(radians(20));
    std::vector<vec2> uv;
    for (const vec3& p : mesh.positions) uv.push_back({p.x, p.y});
    mesh.texcoords = {Block<vec2>(std::move(uv))};
    std::vector<vec3> offsets;
    for (const vec3& p : mesh.positions) offsets.push_back({0, 0, 0.5f * p.x});  // a ramp: the tangent rises with it
    mesh.targets = {{"", offsets, {}, std::vector<vec3>(6)}};
    SmoothSceneOptions options = all_joined();
    options.attributes.tangents = true;
    Context context;
    const Mesh after = smooth_scene(scene_of({mesh}), options, context).meshes[0];
    ASSERT_EQ(after.targets[0].tangents.size(), after.positions.size());
    const vec3 tangent = after.tangents[0].xyz() + after.targets[0].tangents[0];
    EXPECT_NEAR(length(tangent - vec3{float(2 / std::sqrt(5.0)), 0, float(1 / std::sqrt(5.0))}), 0, 1e-5);
}

TEST(MorphNormals, HostileTargetsGiveFiniteNormals) {
    Mesh cube = cube_mesh();
    std::vector<vec3> offsets(8);
    offsets[3] = {NAN, 0, 0};
    offsets[4] = {INFINITY, 1e30f, 0};
    std::vector<vec3> collapse;
    for (const vec3& p : cube.positions) collapse.push_back(vec3{0, 0, 0} - p);
    cube.targets = {{"", offsets, {}, {}}, {"", collapse, {}, {}}};
    Context context;
    const Mesh after = smooth_scene(scene_of({cube}), all_joined(), context).meshes[0];
    for (const MorphTarget& target : after.targets) {
        ASSERT_EQ(target.normals.size(), after.positions.size());
        for (const vec3& n : target.normals) EXPECT_TRUE(is_finite(n) && length(n) <= 2.0001f);
    }
}

}  // namespace
}  // namespace rakelight
