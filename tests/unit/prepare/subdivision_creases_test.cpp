// SPDX-License-Identifier: Apache-2.0
// Subdivision whose creases are the hard edges that the rule of creases finds, whatever the polygons' triangles are.
#include "prepare/refine/subdivide_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "unit/prepare/meshes.h"

namespace rakelight {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A mesh of polygons, each given by its triangles.
struct PolygonMesh {
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices, polygons;

    void add(const std::vector<Triangle>& polygon) {
        const std::uint32_t number = std::uint32_t(polygons.size());
        for (const Triangle& t : polygon) indices.insert(indices.end(), t.begin(), t.end()), polygons.push_back(number);
    }
    Scene scene() const {
        Scene out;
        out.nodes.emplace_back().meshes = {0};
        Mesh& mesh = out.meshes.emplace_back();
        mesh.positions = positions, mesh.indices = indices, mesh.polygons = polygons;
        return out;
    }
};

/// A column of equal sides and two lids. Every edge of the lids has a vertex in its middle.
/// @param first  which triangle of each lid comes first: the loops start at its first corner
PolygonMesh column(std::uint32_t sides, std::uint32_t first) {
    PolygonMesh out;
    const std::uint32_t n = 2 * sides;
    for (const float y : {-1.0f, 1.0f})
        for (std::uint32_t i = 0; i < n; ++i) {
            const double angle = 2 * pi * i / n, radius = i % 2 == 0 ? 1 : std::cos(pi / sides);
            out.positions.push_back({float(radius * std::cos(angle)), y, float(-radius * std::sin(angle))});
        }
    for (std::uint32_t a = 0; a < n; a += 2) {
        const std::uint32_t b = a + 1, c = (a + 2) % n;
        out.add({{a, b, b + n}, {a, b + n, a + n}, {b, c, c + n}, {b, c + n, b + n}});
    }
    for (const std::uint32_t base : {0u, n}) {
        std::vector<Triangle> lid;
        for (std::uint32_t a = 0; a < n; a += 2) lid.push_back({base + (a + n - 1) % n, base + a, base + a + 1});
        for (std::uint32_t m = 3; m + 2 < n; m += 2) lid.push_back({base + 1, base + m, base + m + 2});
        std::rotate(lid.begin(), lid.begin() + std::ptrdiff_t(first % lid.size()), lid.end());
        if (base == 0)
            for (Triangle& t : lid) std::swap(t[1], t[2]);
        out.add(lid);
    }
    return out;
}

using Point = std::array<float, 6>;
/// Places with their normals.
std::set<Point> points_of(const Scene& scene) {
    std::set<Point> out;
    for (std::size_t v = 0; v < scene.meshes[0].positions.size(); ++v) {
        const vec3 p = scene.meshes[0].positions[v], n = scene.meshes[0].normals[v];
        out.insert({p.x + 0.0f, p.y + 0.0f, p.z + 0.0f, n.x + 0.0f, n.y + 0.0f, n.z + 0.0f});
    }
    return out;
}

TEST(SubdivisionCreases, AHexagonalColumnStaysOneWhicheverCornerIsFirst) {
    Context context;
    for (const std::uint32_t first : {0u, 1u, 5u, 7u}) {
        const Scene scene = column(6, first).scene();
        const Scene by_rule = subdivide_scene(scene, {.level = 2, .finds_creases = true}, context);
        const Scene by_angle = subdivide_scene(scene, {.level = 2, .crease_angle_rad = radians(40)}, context);
        EXPECT_EQ(points_of(by_rule), points_of(by_angle)) << first;
        EXPECT_NE(points_of(by_rule), points_of(subdivide_scene(scene, {.level = 2}, context)));
    }
}

TEST(SubdivisionCreases, AColumnOfManySidesKeepsItsRimsAndBecomesRound) {
    Context context;
    const Scene out = subdivide_scene(column(12, 0).scene(), {.level = 3, .finds_creases = true}, context);
    double lowest = 2, highest = 0;
    bool has_lid = false;
    for (std::size_t v = 0; v < out.meshes[0].positions.size(); ++v) {
        const vec3 p = out.meshes[0].positions[v], n = out.meshes[0].normals[v];
        const double radius = std::hypot(double(p.x), double(p.z));
        if (std::fabs(n.y) < 0.5f)
            lowest = std::min(lowest, radius), highest = std::max(highest, radius);
        else
            has_lid = has_lid || (std::fabs(p.y) == 1 && radius > 0.9);
        EXPECT_TRUE(std::fabs(n.y) < 0.1f || std::fabs(n.y) > 0.9999f);
    }
    EXPECT_TRUE(has_lid);
    EXPECT_GT(lowest, 0.9);  // between the circles in and around the control polygon's
    EXPECT_LT(highest - lowest, 0.03);
}

TEST(SubdivisionCreases, AConcavePlaneHasNone) {
    PolygonMesh mesh;  // an L beside the square in its corner; its first triangle does not fan out
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {2, 2, 0}};
    mesh.add({{4, 5, 3}, {5, 0, 3}, {0, 1, 3}, {1, 2, 3}});
    mesh.add({{3, 2, 6}, {3, 6, 4}});
    Context context;
    EXPECT_EQ(points_of(subdivide_scene(mesh.scene(), {.level = 2, .finds_creases = true}, context)),
              points_of(subdivide_scene(mesh.scene(), {.level = 2}, context)));
}

TEST(SubdivisionCreases, SoftCreasesAreNone) {
    Context context;
    const Scene scene = column(6, 0).scene();
    EXPECT_EQ(points_of(subdivide_scene(scene, {.level = 2, .finds_creases = true, .sharpness = 0}, context)),
              points_of(subdivide_scene(scene, {.level = 2}, context)));
}

}  // namespace
}  // namespace rakelight
