// SPDX-License-Identifier: Apache-2.0
// Instances, scopes and what a smoothed scene shares with the one it came from.
#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include "math/linear.h"
#include "prepare/normals/smooth_scene.h"
#include "prepare/prepare_scene.h"
#include "scene/placement.h"
#include "unit/prepare/meshes.h"

namespace rakelight {
namespace {

using test::cube_mesh;
using test::quad_mesh;
using test::scene_of;

Scene smoothed(const Scene& scene, Scope scope, double crease_deg = 180) {
    Context context;
    SmoothSceneOptions options;
    options.attributes.scope = scope;
    options.attributes.crease_angle_rad = radians(crease_deg);
    Scene out = smooth_scene(scene, options, context);
    validate(out);
    return out;
}

Scene instances(const Mesh& mesh, std::vector<Transform> places) {
    Scene scene = scene_of({mesh});
    const Node node = scene.nodes[0];
    scene.nodes.assign(places.size(), node);
    for (std::size_t i = 0; i < places.size(); ++i) scene.nodes[i].local = places[i];
    return scene;
}

Transform at(dvec3 translation, dvec3 scale = {1, 1, 1}, dquat rotation = {}) {
    Transform t;
    t.translation = translation;
    t.scale = scale;
    t.rotation = rotation;
    return t;
}

TEST(SmoothScene, OfNothingIsNothing) {
    Context context;
    EXPECT_TRUE(smooth_scene(Scene{}, {}, context).meshes.empty());
}

TEST(SmoothScene, SharesAllBlocksThatItDoesNotMake) {
    Mesh mesh = cube_mesh();
    mesh.colors = std::vector<vec4>(8, {1, 1, 1, 1});
    const Mesh after = smoothed(scene_of({mesh}), Scope::model).meshes[0];
    EXPECT_TRUE(after.positions == mesh.positions && after.indices == mesh.indices && after.colors == mesh.colors);
    for (std::size_t v = 0; v < 8; ++v)
        EXPECT_NEAR(dot(after.normals[v], mesh.positions[v]), std::sqrt(3.0), 1e-5)
            << "a cube's corner smoothed by angle";
}

TEST(SmoothScene, LeavesInstancesSharedThatComeOutTheSame) {
    const dquat turned{0, 0.6, 0, 0.8};
    for (const Scope scope : {Scope::face, Scope::object, Scope::model}) {
        const Scene out = smoothed(
            instances(cube_mesh(),
                      {at({0, 0, 0}), at({10, 0, 0}), at({20, 0, 0}, {2, 2, 2}, turned), at({30, 0, 0}, {-1, 1, 1})}),
            scope);
        EXPECT_EQ(out.meshes.size(), 1u);
        for (const Node& node : out.nodes) EXPECT_EQ(node.meshes, std::vector<std::uint32_t>{0});
    }
}

TEST(SmoothScene, GivesInstancesTheirOwnMeshWhereTheyTouchOthers) {
    // Two squares side by side, the right one folded down: their common edge differs from the free edges.
    const double half = radians(15);
    const dquat tilt{0, std::sin(half), 0, std::cos(half)};
    const Scene scene = instances(quad_mesh(), {at({0, 0, 0}), at({1, 0, 0}, {1, 1, 1}, tilt)});
    const Scene model = smoothed(scene, Scope::model);
    ASSERT_EQ(model.meshes.size(), 2u);
    EXPECT_TRUE(model.meshes[1].positions == scene.meshes[0].positions) << "positions stay shared";
    EXPECT_TRUE(model.meshes[1].indices == scene.meshes[0].indices);
    const auto world = world_matrices(model);
    const dvec3 a = transform_direction(world[0], cast<double>(model.meshes[0].normals[1]));
    const dvec3 b = transform_direction(world[1], cast<double>(model.meshes[1].normals[0]));
    EXPECT_NEAR(length(a - b), 0, 1e-6) << "no seam in the world";
    EXPECT_EQ(smoothed(scene, Scope::object).meshes.size(), 1u);
}

TEST(SmoothScene, SaysWhenInstancesWereTakenApart) {
    Context context;
    const Scene scene =
        instances(quad_mesh(), {at({0, 0, 0}), at({1, 0, 0}, {1, 1, 1}, {0, std::sin(0.2), 0, std::cos(0.2)})});
    smooth_scene(scene, {}, context);
    EXPECT_EQ(test::remarks(context, Remark::note, "1 instances got a mesh of their own"), 1u)
        << test::all_remarks(context);
}

TEST(SmoothScene, ComputesUnevenlyScaledInstancesApart) {
    // Under an uneven scale a corner's angles differ, so the angle-weighted normal does.
    const Scene out = smoothed(instances(cube_mesh(), {at({0, 0, 0}), at({50, 0, 0}, {1, 8, 1})}), Scope::object);
    EXPECT_EQ(smoothed(instances(cube_mesh(), {at({0, 0, 0}), at({50, 0, 0}, {3, 3, 3})}), Scope::object).meshes.size(),
              1u);
    for (const Mesh& mesh : out.meshes) test::expect_unit(mesh.normals, 8);
}

TEST(SmoothScene, OnlyMissingKeepsNormalsThatAreThere) {
    Mesh with = quad_mesh();
    with.normals = std::vector<vec3>(4, {1, 0, 0});
    Context context;
    SmoothSceneOptions options;
    options.only_missing = true;
    const Scene out = smooth_scene(scene_of({with, cube_mesh()}), options, context);
    EXPECT_TRUE(out.meshes[0].normals == with.normals);
    EXPECT_FALSE(out.meshes[1].normals.empty());
}

TEST(SmoothScene, MakesTangentsWhereverThereAreCoordinatesAndOnlyIfAsked) {
    Mesh mesh = quad_mesh();
    mesh.texcoords = {{}, std::vector<vec2>{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
    const Mesh after = smoothed(scene_of({mesh}), Scope::model).meshes[0];
    ASSERT_EQ(after.tangents.size(), 4u);
    EXPECT_EQ(after.tangents[0].w, 1);
    Context context;
    SmoothSceneOptions options;
    options.attributes.tangents = false;
    EXPECT_TRUE(smooth_scene(scene_of({mesh}), options, context).meshes[0].tangents.empty());
}

TEST(SmoothScene, WithoutNormalsAskedForMakesOnlyTangentsAnew) {
    Mesh mesh = quad_mesh();
    mesh.normals = std::vector<vec3>(4, {0, 0, 1});
    mesh.tangents = std::vector<vec4>(4, {0, 1, 0, -1});
    mesh.texcoords = {std::vector<vec2>{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
    Context context;
    SmoothSceneOptions options;
    options.attributes.normals = false;
    const Mesh after = smooth_scene(scene_of({mesh}), options, context).meshes[0];
    EXPECT_TRUE(after.normals == mesh.normals);
    ASSERT_EQ(after.tangents.size(), 4u);
    EXPECT_NEAR(after.tangents[0].x, 1, 1e-6);
}

TEST(SmoothScene, KeptInstancesShareTheFirstOnesNormalsAloud) {
    const double half = radians(15);
    const Scene scene =
        instances(quad_mesh(), {at({0, 0, 0}), at({1, 0, 0}, {1, 1, 1}, {0, std::sin(half), 0, std::cos(half)})});
    const Scene apart = smoothed(scene, Scope::model);
    ASSERT_EQ(apart.meshes.size(), 2u);
    PrepareOptions options;
    options.normals = NormalSource::model;
    options.keep_instances = true;
    Context context;
    const Scene kept = prepare_scene(scene, options, context);
    ASSERT_EQ(kept.meshes.size(), 1u);
    for (std::size_t v = 0; v < 4; ++v)
        EXPECT_NEAR(length(kept.meshes[0].normals[v] - apart.meshes[0].normals[v]), 0, 0.1f);
    for (const Node& node : kept.nodes) EXPECT_EQ(node.meshes, std::vector<std::uint32_t>{0});
    EXPECT_EQ(test::remarks(context, Remark::warning, "1 instances that touch other things keep"), 1u)
        << test::all_remarks(context);
    Context alike;
    prepare_scene(instances(quad_mesh(), {at({0, 0, 0}), at({9, 0, 0})}), options, alike);
    EXPECT_EQ(test::remarks(alike, Remark::warning, "keep the normals"), 0u) << "nothing was given up";
}

TEST(SmoothScene, LooksAtModelsFarFromTheOriginAsAtNearOnes) {
    Scene scene = scene_of({quad_mesh(), quad_mesh()});
    for (Mesh& mesh : scene.meshes) mesh.origin = {1e6, 2e6, 3e6};
    scene.nodes[1].local = at({1e6 + 1, 0, -1e6}, {1, 1, 1}, {0, 0, 0, 1});
    const Mesh after = smoothed(scene, Scope::model).meshes[0];
    for (const vec3& n : after.normals) EXPECT_EQ(n, (vec3{0, 0, 1}));
}

TEST(SmoothScene, RefusesMoreInstancesThanMemoryAllows) {
    Context context({.max_memory = 100000});
    Scene scene = scene_of({test::ball_mesh(32, 16)});
    scene.nodes.resize(1000, scene.nodes[0]);
    EXPECT_THROW(smooth_scene(scene, {}, context), Error);
}

}  // namespace
}  // namespace rakelight
