// SPDX-License-Identifier: Apache-2.0
// Points with normals as pieces of surface, and the size of the others.
#include <rakelight/scene/validate.h>

#include <gtest/gtest.h>

#include <cmath>

#include "math/linear.h"
#include "prepare/splat_points.h"
#include "scene/placement.h"
#include "scene/splat_mesh.h"

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

TEST(SplatPoints, OfAGridCoverItWithAnApexOnEachSideOfThePlaneOfTheirNormals) {
    Context context({.threads = 2});
    const Scene scene = splat_points(grid(64, 0.25f), context);
    validate(scene);
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.topology, Topology::triangles);
    ASSERT_EQ(mesh.positions.size(), splat_vertices * 64 * 64);
    EXPECT_EQ(mesh.triangle_count(), splat_triangles * 64 * 64);
    EXPECT_TRUE(is_of_splats(mesh));
    EXPECT_TRUE(scene.materials.at(mesh.material).double_sided);
    for (std::size_t i = 0; i < 64 * 64; ++i) {
        const vec3* const at = mesh.positions.data() + splat_vertices * i;
        const vec3 middle{0.25f * float(i % 64), 0.25f * float(i / 64), 0};
        const float radius = length(at[2] - middle);
        EXPECT_GE(radius, 0.25f * std::sqrt(2.0f) / std::sqrt(3.0f)) << "neighbors leave no gap";
        EXPECT_LE(radius, 0.25f * 2);
        for (std::size_t k = 2; k < splat_vertices; ++k) {
            EXPECT_EQ(at[k].z, 0);
            EXPECT_NEAR(length(at[k] - middle), radius, 1e-5f);
        }
        EXPECT_NEAR(length(at[0] - middle - vec3{0, 0, splat_slope * radius}), 0, 1e-5f);
        EXPECT_NEAR(length(at[1] - middle + vec3{0, 0, splat_slope * radius}), 0, 1e-5f);
        EXPECT_EQ(mesh.colors[splat_vertices * i + 3].x, float(i));
        for (std::size_t t = 0; t < splat_triangles; ++t) {
            const std::uint32_t* const c = mesh.indices.data() + 3 * (splat_triangles * i + t);
            const vec3 a = mesh.positions[c[0]];
            EXPECT_GT(cross(mesh.positions[c[1]] - a, mesh.positions[c[2]] - a).z, 0) << "it turns as its normal says";
        }
    }
}

TEST(SplatPoints, AreKnownAgainByTheOrderOfTheirCornersAlone) {
    Context context({.threads = 1});
    Mesh mesh = splat_points(grid(5, 1), context).meshes.at(0);
    ASSERT_TRUE(is_of_splats(mesh));
    std::vector<std::uint32_t> indices(mesh.indices.begin(), mesh.indices.end());
    std::swap(indices[indices.size() - 1], indices[indices.size() - 2]);
    mesh.indices = indices;
    EXPECT_FALSE(is_of_splats(mesh));
    indices.resize(indices.size() - 3);
    mesh.indices = indices;
    EXPECT_FALSE(is_of_splats(mesh));
    EXPECT_FALSE(is_of_splats(Mesh{}));
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
    EXPECT_EQ(out.meshes[0].triangle_count(), splat_triangles * (1600 - 1));
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
    for (std::size_t i = 0; i < mesh.positions.size(); i += splat_vertices) {
        const vec3 middle = (mesh.positions[i] + mesh.positions[i + 1]) * 0.5f;
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
