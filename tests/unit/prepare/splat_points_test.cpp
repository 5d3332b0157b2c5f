// SPDX-License-Identifier: Apache-2.0
// Points with normals as pieces of surface, and the size of the others.
#include <gtest/gtest.h>

#include <cmath>

#include "math/linear.h"
#include "prepare/splat_points.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

/// A square grid of n x n points in the plane z = 0, `step` apart.
Scene grid(std::size_t n, float step) {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.topology = Topology::points;
    std::vector<vec3> positions, normals;
    std::vector<vec4> colors;
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < n * n; ++i) {
        positions.push_back({float(i % n) * step, float(i / n) * step, 0});
        normals.push_back({0, 0, 1});
        colors.push_back({float(i), 0, 0, 1});
        indices.push_back(std::uint32_t(i));
    }
    mesh.positions = positions, mesh.normals = normals, mesh.colors = colors, mesh.indices = indices;
    scene.nodes.push_back({.name = "cloud", .meshes = {0}});
    return scene;
}

TEST(SplatPoints, SquaresOfAGridCoverItAndLieInThePlaneOfTheNormals) {
    Context context({.threads = 2});
    const Scene scene = splat_points(grid(64, 0.25f), context);
    validate(scene);
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.topology, Topology::triangles);
    ASSERT_EQ(mesh.positions.size(), 4u * 64 * 64);
    EXPECT_EQ(mesh.triangle_count(), 2u * 64 * 64);
    EXPECT_TRUE(scene.materials.at(mesh.material).double_sided);
    for (std::size_t i = 0; i < mesh.positions.size() / 4; ++i) {
        const vec3 a = mesh.positions[4 * i], c = mesh.positions[4 * i + 2];
        EXPECT_EQ(a.z, 0);
        EXPECT_NEAR((a.x + c.x) / 2, 0.25f * float(i % 64), 1e-5f);
        EXPECT_GE(std::sqrt(dot(c - a, c - a)), 0.25f * std::sqrt(2.0f)) << "neighbors leave no gap";
        EXPECT_LE(std::sqrt(dot(c - a, c - a)), 0.25f * 3.5f);
        EXPECT_EQ(mesh.colors[4 * i + 3].x, float(i));
        const vec3 face = cross(mesh.positions[4 * i + 1] - a, c - a);
        EXPECT_GT(face.z, 0) << "it turns as its normal says";
    }
}

TEST(SplatPoints, PointsWithoutANormalStayPoints) {
    Context context({.threads = 1});
    Scene scene = grid(40, 1);
    std::vector<vec3> normals(scene.meshes[0].normals.begin(), scene.meshes[0].normals.end());
    normals[7] = {0, 0, 0};
    scene.meshes[0].normals = normals;
    const Scene out = splat_points(scene, context);
    validate(out);
    ASSERT_EQ(out.meshes.size(), 2u);
    EXPECT_EQ(out.meshes[0].triangle_count(), 2u * (1600 - 1));
    EXPECT_EQ(out.meshes[1].topology, Topology::points);
    ASSERT_EQ(out.meshes[1].indices.size(), 1u);
    EXPECT_EQ(out.meshes[1].indices[0], 7u);
    EXPECT_EQ(out.nodes[0].meshes.size(), 2u);
    scene.meshes[0].normals = {};
    EXPECT_EQ(splat_points(scene, context).meshes[0].topology, Topology::points);
}

/// Points over the unit sphere by the golden angle: evenly, without a lattice.
Scene sphere(std::size_t n) {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.topology = Topology::points;
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < n; ++i) {
        const double z = 1 - (2 * double(i) + 1) / double(n), r = std::sqrt(1 - z * z),
                     a = 2.399963229728653 * double(i);
        positions.push_back({float(r * std::cos(a)), float(r * std::sin(a)), float(z)});
        indices.push_back(std::uint32_t(i));
    }
    mesh.positions = positions, mesh.indices = indices;
    scene.nodes.push_back({.name = "cloud", .meshes = {0}});
    return scene;
}

TEST(SplatPoints, PointsOfASurfaceWithNothingButTheirPlacesGetNormalsOfTheirNeighborhoods) {
    Context one({.threads = 1}), two({.threads = 2});
    const Scene out = splat_points(sphere(20000), one), again = splat_points(sphere(20000), two);
    const Mesh& mesh = out.meshes.at(0);
    ASSERT_EQ(mesh.topology, Topology::triangles);
    double worst = 1;
    for (std::size_t i = 0; i < mesh.positions.size(); i += 4) {
        const vec3 middle = (mesh.positions[i] + mesh.positions[i + 2]) * 0.5f;
        worst = std::min(worst, std::fabs(double(dot(mesh.normals[i], middle))));
    }
    EXPECT_GT(worst, 0.99) << "within 8 degrees of the sphere's own";
    EXPECT_TRUE(std::equal(mesh.normals.begin(), mesh.normals.end(), again.meshes[0].normals.begin()));
    Scene colored = sphere(20000);
    colored.meshes[0].colors = std::vector<vec4>(20000, {1, 0, 0, 1});
    EXPECT_EQ(splat_points(colored, one).meshes[0].topology, Topology::points) << "its colors are what it shows";
    EXPECT_EQ(splat_points(sphere(500), one).meshes[0].topology, Topology::points);
}

TEST(SplatPoints, PointsThatFillABodyGetNoNormals) {
    Context context({.threads = 1});
    Scene scene = sphere(20000);
    std::vector<vec3> inside(scene.meshes[0].positions.begin(), scene.meshes[0].positions.end());
    std::uint32_t state = 1;
    for (vec3& p : inside)
        for (std::size_t k = 0; k < 3; ++k) p[k] = float((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0f;
    scene.meshes[0].positions = inside;
    EXPECT_EQ(splat_points(scene, context).meshes[0].topology, Topology::points);
}

TEST(SplatPoints, TheDiameterFollowsSpacingAndScaleAndIsTheSameForAnyThreads) {
    Context one({.threads = 1}), two({.threads = 2});
    Scene scene = grid(300, 0.5f);
    const std::optional<double> diameter = point_diameter(scene, one);
    ASSERT_TRUE(diameter);
    EXPECT_GT(*diameter, 0.5 * std::sqrt(2.0));
    EXPECT_LT(*diameter, 0.5 * 3.5);
    EXPECT_EQ(point_diameter(scene, two), diameter);
    scene.nodes[0].local.scale = {10, 10, 10};
    EXPECT_NEAR(*point_diameter(scene, one), 10 * *diameter, 1e-9 * *diameter);
    EXPECT_EQ(point_diameter(Scene{}, one), std::nullopt);
    const Scene few = grid(2, 1);
    EXPECT_LT(*point_diameter(few, one), 0.1) << "four points are dots, not a surface";
    Scene same = grid(30, 0);
    EXPECT_EQ(point_diameter(same, one), std::nullopt);
}

}  // namespace
}  // namespace rakelight
