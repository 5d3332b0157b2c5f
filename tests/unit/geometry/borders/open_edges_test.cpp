// SPDX-License-Identifier: Apache-2.0
// find_open_edges() holds to the census of all edges.
#include "geometry/borders/open_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "geometry/faults/edge_census.h"
#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

/// @return how many there are
std::size_t expect_agreement(const std::vector<Shape>& shapes, double weld_distance = -1) {
    Context context;
    const std::vector<AttributeMesh> meshes = views(shapes);
    const geometry::PlacedMeshes placed = geometry::place_vertices(meshes, weld_distance, context);
    std::vector<std::uint32_t> census = count_edges(placed, std::uint32_t(shapes.size()), context).open_corners;
    std::ranges::sort(census);
    for (const int threads : {1, 3}) {
        Context own({.threads = threads});
        EXPECT_EQ(find_open_edges(placed, own), census);
    }
    return census.size();
}

/// Triangles over few vertices: any number of faces at an edge, either way round, with corners twice or not finite.
Shape random_soup(std::mt19937& random, std::uint32_t vertices, std::uint32_t triangles) {
    Shape s;
    for (std::uint32_t v = 0; v < vertices; ++v)
        s.positions.push_back({float(random() % 5), float(random() % 5), float(random() % 5)});  // some at one place
    if (vertices > 20) s.positions[7].y = std::numeric_limits<float>::quiet_NaN();
    for (std::uint32_t i = 0; i < 3 * triangles; ++i) s.indices.push_back(random() % vertices);
    return s;
}

std::vector<Shape> numbered(std::vector<Shape> shapes) {
    for (std::size_t m = 0; m < shapes.size(); ++m) shapes[m].object = std::uint32_t(m);
    return shapes;
}

TEST(OpenEdges, AreThoseOfTheCensusInSoupsOfAnyFaces) {
    std::mt19937 random(5);
    std::size_t open = 0;
    for (int round = 0; round < 60; ++round) {
        std::vector<Shape> shapes;
        for (std::uint32_t m = 0; m < 1 + random() % 4; ++m)
            shapes.push_back(random_soup(random, 3 + random() % 40, random() % 60));
        open += expect_agreement(numbered(shapes));
    }
    EXPECT_GT(open, 1000u);
}

TEST(OpenEdges, AreThoseOfTheCensusWherePartsAreCutAndWelded) {
    for (const Shape& whole : {make_sphere(20, 12), make_torus(24, 9), make_cylinder(18, 7), make_cube()})
        for (const std::uint32_t parts : {1u, 2u, 7u}) {
            std::vector<Shape> cut = numbered(cut_at_random(whole, parts, parts));
            const std::size_t open = expect_agreement(cut);
            std::mt19937 random(11);
            for (Shape& s : cut)  // so little that a weld joins it, and no equality does
                for (vec3& p : s.positions) p.x += 1e-4f * float(random() % 3);
            EXPECT_EQ(expect_agreement(cut, 1e-3), open);
            if (parts > 1) {
                EXPECT_GT(expect_agreement(cut, 0), open);
            }
        }
}

TEST(OpenEdges, AreThoseOfTheCensusWherePlacementsMirror) {
    // Halves that mirror images of one another close: the faces of the mirrored one go round the other way.
    Shape half = make_grid(12, 6, [](double u, double v) {
        const double a = pi * u, b = pi * (0.1 + 0.8 * v);
        return vec3{u <= 0 || u >= 1 ? 0 : float(std::sin(b) * std::sin(a)), float(-std::cos(b)),
                    float(std::sin(b) * std::cos(a))};
    });
    std::vector<Shape> both = numbered({half, half});
    both[1].to_world[0][0] = -1;
    EXPECT_EQ(expect_agreement(both), 2 * 24u);  // the rings at the poles
    std::mt19937 random(3);
    for (const bool mirrored : {false, true}) {
        std::vector<Shape> moved = numbered({make_torus(16, 8), half, make_sphere(9, 5)});
        for (Shape& s : moved) s.to_world = random_affine(random, mirrored);
        EXPECT_EQ(expect_agreement(moved), 36u);
    }
}

TEST(OpenEdges, NoFacesHaveNone) {
    EXPECT_EQ(expect_agreement({}), 0u);
    EXPECT_EQ(expect_agreement({Shape{}}), 0u);
}

}  // namespace
}  // namespace rakelight::test
