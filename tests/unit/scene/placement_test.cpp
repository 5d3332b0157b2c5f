// SPDX-License-Identifier: Apache-2.0
#include <rakelight/scene/scene_queries.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/linear.h"
#include "scene/drawn_vertices.h"
#include "scene/placement.h"
#include "unit/scene/scenes.h"

namespace rakelight {
namespace {

Node child_of(std::uint32_t parent, dvec3 translation) {
    Node node;
    node.parent = parent;
    node.local.translation = translation;
    return node;
}

TEST(WorldMatrices, MultiplyAlongTheChain) {
    Scene scene;
    scene.nodes = {child_of(no_index, {1, 2, 3}), child_of(0, {10, 0, 0}), child_of(1, {0, 100, 0}),
                   child_of(0, {0, 0, 5})};
    scene.nodes[0].local.scale = {2, 2, 2};
    const auto world = world_matrices(scene);
    ASSERT_EQ(world.size(), 4u);
    EXPECT_EQ(world[1][3], (dvec4{21, 2, 3, 1}));
    EXPECT_EQ(world[2][3], (dvec4{21, 202, 3, 1}));
    EXPECT_EQ(world[3][3], (dvec4{1, 2, 13, 1}));
}

TEST(WorldMatrices, AMatrixCountsAlone) {
    Scene scene;
    scene.nodes = {child_of(no_index, {1, 2, 3})};
    scene.nodes[0].local.matrix = scaling(dvec3{4, 5, 6});
    EXPECT_EQ(world_matrices(scene)[0], scaling(dvec3{4, 5, 6}));
}

TEST(WorldMatrices, AreExactAMillionMetersFromTheOrigin) {
    Scene scene;
    scene.nodes = {child_of(no_index, {1e6, 0, 0}), child_of(0, {0.001, 0, 0})};
    EXPECT_EQ(world_matrices(scene)[1][3].x, 1e6 + 0.001);
}

TEST(WorldBounds, OfNothingIsEmpty) {
    EXPECT_TRUE(world_bounds(Scene{}).empty());
    EXPECT_EQ(world_bounds(Scene{}).diagonal(), 0);
    EXPECT_EQ(world_bounds(Scene{}).center(), (dvec3{0, 0, 0}));
    Scene unplaced = test::quad_scene();
    unplaced.nodes[0].meshes.clear();
    EXPECT_TRUE(world_bounds(unplaced).empty()) << "a mesh that no node places is not drawn";
}

TEST(WorldBounds, TakeInEveryInstanceWithItsMatrixAndTheOriginInDouble) {
    Scene scene = test::quad_scene();
    scene.meshes[0].origin = {1e9, 0, 0};
    scene.nodes.push_back(child_of(no_index, {0, 0, -7}));
    scene.nodes[1].meshes = {0};
    const Bounds b = world_bounds(scene);
    EXPECT_EQ(b.low, (dvec3{1e9, 0, -7}));
    EXPECT_EQ(b.high, (dvec3{1e9 + 1, 1, 0}));
    EXPECT_NEAR(b.diagonal(), std::sqrt(51.0), 1e-12);
}

TEST(WorldBounds, LeaveOutStrayVerticesAndNonFiniteOnesAndTakeLinesIn) {
    Scene scene = test::quad_scene();
    const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    scene.meshes[0].positions = std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {inf, 1, 0}, {0, 1, nan}, {50, 50, 50}};
    Mesh lines = test::quad_mesh();
    lines.topology = Topology::lines;
    lines.positions = std::vector<vec3>(4, {9, 9, 9});
    scene.meshes.push_back(lines);
    scene.nodes[0].meshes = {0, 1};
    const Bounds b = world_bounds(scene);
    EXPECT_EQ(b.low, (dvec3{0, 0, 0}));
    EXPECT_EQ(b.high, (dvec3{9, 9, 9}));
}

TEST(Bounds, OfTheLargestSizeHaveAFiniteDiagonalAndCenter) {
    Bounds b;
    b.low = {-1.7e308, -1.7e308, -1.7e308};
    b.high = {1.7e308, 1.7e308, 1.7e308};
    EXPECT_TRUE(std::isfinite(b.diagonal()));
    EXPECT_EQ(b.center(), (dvec3{0, 0, 0}));
}

TEST(TriangleCount, CountsInstancesEachTimeAndNoLines) {
    Scene scene = test::quad_scene();
    scene.nodes.push_back(scene.nodes[0]);
    EXPECT_EQ(triangle_count(scene), 4u);
    scene.meshes[0].topology = Topology::lines;
    EXPECT_EQ(triangle_count(scene), 0u);
}

void expect_rotation(const dmat4& m) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(dot(m[i].xyz(), m[k].xyz()), i == k ? 1 : 0, 1e-12) << i << " " << k;
    EXPECT_NEAR(determinant(upper_left(m)), 1, 1e-12);
    EXPECT_EQ(m[3].w, 1);
}

TEST(CameraToWorld, TakesScaleShearAndMirrorsOutAndKeepsTheViewDirection) {
    Camera camera;
    camera.to_world = {{{-3, 0, 0, 0}, {1e-9, 2e-9, 0.5e-9, 0}, {0, 0, 1e20, 0}, {4, 5, 6, 1}}};
    const dmat4 m = camera_to_world(Scene{}, camera, {});
    expect_rotation(m);
    EXPECT_NEAR(m[2].z, 1, 1e-15);
    EXPECT_GT(m[1].y, 0.8);
    EXPECT_EQ(m[3], (dvec4{4, 5, 6, 1}));
}

TEST(CameraToWorld, IsARotationEvenForSingularAndBrokenMatrices) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const dmat4& broken :
         {scaling(dvec3{0, 0, 0}), scaling(dvec3{1, 0, 1}), scaling(dvec3{1, 1, 0}), scaling(dvec3{0, 0, 1}),
          scaling(dvec3{nan, nan, nan}), dmat4{{{0, 0, 1, 0}, {0, 0, 1, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}},
          dmat4{{{0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}}}}) {
        Camera camera;
        camera.to_world = broken;
        expect_rotation(camera_to_world(Scene{}, camera, {}));
    }
}

TEST(CameraToWorld, OfACameraAtANodeIsThatNodesPlace) {
    Scene scene;
    scene.nodes = {child_of(no_index, {1, 2, 3})};
    scene.nodes[0].local.scale = {5, 5, 5};
    Camera camera;
    camera.node = 0;
    camera.to_world = scaling(dvec3{9, 9, 9});
    EXPECT_EQ(camera_to_world(scene, camera, world_matrices(scene)), translation(dvec3{1, 2, 3}));
}

}  // namespace
}  // namespace rakelight
