// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <rakelight/base/error.h>
#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include "prepare/prepare_scene.h"
#include "prepare/project_texcoords.h"
#include "scene/placement.h"
#include "unit/prepare/meshes.h"

namespace rakelight {
namespace {

using test::ball_mesh;
using test::cube_mesh;
using test::scene_of;

Scene projected(const Scene& scene, UvProjection projection) {
    Context context;
    Scene out = project_texcoords(scene, projection, context);
    validate(out);
    EXPECT_EQ(test::remarks(context, Remark::note, "projection"), 1u);
    return out;
}

vec2 uv(const Mesh& mesh, std::size_t corner) { return mesh.texcoords[0][mesh.indices[corner]]; }

/// Twice the signed area in the texture, positive where it is not mirrored (counter-clockwise with v down is clockwise).
float area(const Mesh& mesh, std::size_t t) {
    const vec2 a = uv(mesh, 3 * t), b = uv(mesh, 3 * t + 1), c = uv(mesh, 3 * t + 2);
    return (c.x - a.x) * (b.y - a.y) - (b.x - a.x) * (c.y - a.y);
}

void expect_same_corners(const Mesh& before, const Mesh& after) {
    ASSERT_EQ(before.indices.size(), after.indices.size());
    for (std::size_t c = 0; c < before.indices.size(); ++c)
        ASSERT_EQ(before.positions[before.indices[c]], after.positions[after.indices[c]]);
}

TEST(ProjectTexcoords, LeavesMeshesAloneThatHaveCoordinates) {
    Context context;
    Mesh mesh = cube_mesh();
    mesh.texcoords = {{}, std::vector<vec2>(8)};
    const Mesh after = project_texcoords(scene_of({mesh}), UvProjection::box, context).meshes[0];
    EXPECT_TRUE(after.positions == mesh.positions && after.texcoords[1] == mesh.texcoords[1] &&
                after.texcoords[0].empty());
    EXPECT_EQ(test::all_remarks(context), "");
    EXPECT_TRUE(project_texcoords(scene_of({cube_mesh()}), UvProjection::none, context).meshes[0].texcoords.empty());
    EXPECT_TRUE(project_texcoords(Scene{}, UvProjection::sphere, context).meshes.empty());
}

TEST(ProjectTexcoords, BoxGivesEachSideOfACubeTheWholeTextureUnmirrored) {
    const Mesh before = cube_mesh(), after = projected(scene_of({before}), UvProjection::box).meshes[0];
    expect_same_corners(before, after);
    EXPECT_EQ(after.positions.size(), 20u) << "eight vertices of three sides, at four of which two sides agree";
    for (std::size_t t = 0; t < 12; ++t) EXPECT_NEAR(area(after, t), 1, 1e-6);
    for (std::size_t c = 0; c < 6; ++c) {  // the front, z = 1: upright
        const vec3 p = after.positions[after.indices[c]];
        EXPECT_EQ(uv(after, c), (vec2{(p.x + 1) / 2, (1 - p.y) / 2}));
    }
}

TEST(ProjectTexcoords, BoxDoesNotSplitWhereOneSideIsSeen) {
    const Mesh before = test::quad_mesh(), after = projected(scene_of({before}), UvProjection::box).meshes[0];
    EXPECT_TRUE(after.positions == before.positions && after.indices == before.indices);
}

TEST(ProjectTexcoords, SphereRunsOnceAroundWithoutATriangleThatJumps) {
    for (const int around : {4, 8, 12, 32}) {
        const Mesh before = ball_mesh(around, 8), after = projected(scene_of({before}), UvProjection::sphere).meshes[0];
        expect_same_corners(before, after);
        double total = 0;
        for (std::size_t t = 0; t < after.triangle_count(); ++t) {
            EXPECT_GT(area(after, t), 0) << "mirrored or empty triangle " << t;
            const float u[3] = {uv(after, 3 * t).x, uv(after, 3 * t + 1).x, uv(after, 3 * t + 2).x};
            EXPECT_LE(std::max({u[0], u[1], u[2]}) - std::min({u[0], u[1], u[2]}), 1.0f / float(around) + 1e-5f);
            total += area(after, t) / 2;
        }
        EXPECT_NEAR(total, 1 - 1.0 / 8, 1e-5) << "all of the texture but half of the two rows at the poles";
    }
}

TEST(ProjectTexcoords, SphereHasTheFrontInTheMiddleTheTopAboveAndTheRightToTheRight) {
    const Mesh after = projected(scene_of({ball_mesh(8, 4)}), UvProjection::sphere).meshes[0];
    for (std::size_t c = 0; c < after.indices.size(); ++c) {
        const vec3 p = after.positions[after.indices[c]];
        const vec2 at = uv(after, c);
        EXPECT_NEAR(at.y, std::acos(p.y) / pi, 1e-6);
        if (p.z > 0.9f) {
            EXPECT_NEAR(at.x, 0.5, 1e-6);
        }
        if (p.x > 0.9f) {
            EXPECT_NEAR(at.x, 0.75, 1e-6);
        }
        if (p.x < -0.9f) {
            EXPECT_NEAR(at.x, 0.25, 1e-6);
        }
    }
}

TEST(ProjectTexcoords, PolesGetTheMiddleOfTheirTriangles) {
    const Mesh after = projected(scene_of({ball_mesh(8, 4)}), UvProjection::sphere).meshes[0];
    int poles = 0;
    for (std::size_t t = 0; t < after.triangle_count(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            if (std::fabs(after.positions[after.indices[3 * t + k]].y) != 1) continue;
            ++poles;
            EXPECT_NEAR(uv(after, 3 * t + k).x,
                        (uv(after, 3 * t + (k + 1) % 3).x + uv(after, 3 * t + (k + 2) % 3).x) / 2, 1e-6);
        }
    EXPECT_EQ(poles, 16);
}

TEST(ProjectTexcoords, CylinderGivesTheSideTheWholeHeightAndTheCapsAnArea) {
    // A tube of 12 sides with caps about the axis.
    Mesh mesh;
    std::vector<vec3> p{{0, 2, 0}, {0, -2, 0}};
    std::vector<std::uint32_t> index;
    for (std::uint32_t c = 0; c < 12; ++c) {
        const double phi = 2 * pi * c / 12;
        for (const float y : {2.0f, -2.0f}) p.push_back({float(std::sin(phi)), y, float(std::cos(phi))});
        const std::uint32_t a = 2 + 2 * c, b = 2 + 2 * ((c + 1) % 12);
        index.insert(index.end(), {a, a + 1, b + 1, a, b + 1, b, 0, a, b, 1, b + 1, a + 1});
    }
    mesh.positions = p;
    mesh.indices = index;
    const Mesh after = projected(scene_of({mesh}), UvProjection::cylinder).meshes[0];
    expect_same_corners(mesh, after);
    double side = 0;
    for (std::size_t t = 0; t < after.triangle_count(); ++t) {
        EXPECT_GT(area(after, t), 0) << t;
        if (t % 4 < 2) side += area(after, t) / 2;
    }
    EXPECT_NEAR(side, 1, 1e-5);
}

TEST(ProjectTexcoords, MirroredInstancesAreNotMirroredInTheTexture) {
    Scene scene = scene_of({cube_mesh()});
    scene.nodes[0].local.scale = {-1, 1, 1};
    const Mesh after = projected(scene, UvProjection::box).meshes[0];
    // The mesh's own winding is turned by the node, so its triangles are clockwise in the texture.
    for (std::size_t t = 0; t < 12; ++t) EXPECT_NEAR(area(after, t), -1, 1e-6);
}

TEST(ProjectTexcoords, InstancesLieAtTheirOwnPlaceInTheTexture) {
    Scene scene = scene_of({test::quad_mesh()});
    scene.nodes.resize(2, scene.nodes[0]);
    scene.nodes[1].local.translation = {1, 0, 0};
    Context context;
    const Scene out = project_texcoords(scene, UvProjection::box, context);
    ASSERT_EQ(out.meshes.size(), 2u);
    EXPECT_EQ(out.meshes[0].texcoords[0][1], out.meshes[1].texcoords[0][0]);
    EXPECT_EQ(test::remarks(context, Remark::note, "1 instances got a mesh of their own"), 1u);
}

TEST(ProjectTexcoords, AllPlacementsTogetherStayWithinTheMemoryBudget) {
    Scene scene = scene_of({ball_mesh(64, 32)});
    scene.nodes.resize(100, scene.nodes[0]);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) scene.nodes[i].local.translation = {3.0 * double(i), 0, 0};
    const std::uint64_t kept = 100 * 8 * scene.meshes[0].positions.size();  // texture coordinates alone
    Context enough, too_small({.max_memory = kept / 2});
    {
        const Scene out = project_texcoords(scene, UvProjection::box, enough);
        EXPECT_EQ(out.meshes.size(), 100u);
        EXPECT_GT(enough.memory().charged(), kept);
    }
    EXPECT_EQ(enough.memory().charged(), 0u);
    EXPECT_THROW(project_texcoords(scene, UvProjection::box, too_small), Error);
    EXPECT_EQ(too_small.memory().charged(), 0u);
}

TEST(ProjectTexcoords, StaysFiniteForDegenerateAndBrokenModels) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::vector<Mesh> meshes(3, test::quad_mesh());
    meshes[0].positions = std::vector<vec3>(4, {1, 1, 1});
    meshes[1].positions = std::vector<vec3>{{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {nan, 0, 0}};
    meshes[2].positions = std::vector<vec3>{{0, 0, 0}, {1e30f, 0, 0}, {1e30f, 1e30f, 0}, {0, 1e30f, 0}};
    for (const Mesh& mesh : meshes)
        for (const UvProjection projection : {UvProjection::box, UvProjection::sphere, UvProjection::cylinder}) {
            const Scene out = projected(scene_of({mesh}), projection);
            for (const vec2& at : out.meshes[0].texcoords[0]) EXPECT_TRUE(std::isfinite(at.x) && std::isfinite(at.y));
        }
}

TEST(ProjectTexcoords, TakesLinearTimeForALargeFanAboutThePole) {
    const int around = 60000;  // a quadratic search would take minutes
    const Mesh after = projected(scene_of({ball_mesh(around, 3)}), UvProjection::sphere).meshes[0];
    EXPECT_GT(after.positions.size(), std::size_t(2 * around));
}

}  // namespace
}  // namespace rakelight
