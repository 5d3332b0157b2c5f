// SPDX-License-Identifier: Apache-2.0
#include "geometry/faults/t_junctions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "geometry/faults/edge_census.h"
#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

struct Found {
    geometry::TJunctions junctions;
    std::vector<dvec3> at;
};

Found junctions_of(const std::vector<Shape>& shapes, std::size_t most = 1000, std::uint64_t visits = 256) {
    Context context;
    const std::vector<AttributeMesh> meshes = views(shapes);
    const geometry::PlacedMeshes placed = geometry::place_vertices(meshes, -1, context);
    const std::uint32_t objects = std::uint32_t(shapes.size());
    const geometry::EdgeCensus census = count_edges(placed, objects, context);
    Found found{find_t_junctions(placed, census.open_corners, objects, most, context, visits), {}};
    for (const geometry::TJunction& t : found.junctions.places) found.at.push_back(placed.position(t.place));
    return found;
}

/// A flat grid of cells of size `step` over x in [left, left + 8], y in [0, 8].
Shape flat_grid(float left, float step, std::uint32_t object) {
    const std::uint32_t cells = std::uint32_t(8 / step);
    Shape s = make_grid(cells, cells, [&](double u, double v) { return vec3{left + float(8 * u), float(8 * v), 0}; });
    s.object = object;
    return s;
}

TEST(TJunctions, GridsOfStep1And2MeetInOneAtEachOddNumber) {
    const Found f = junctions_of({flat_grid(0, 1, 0), flat_grid(8, 2, 1)});
    EXPECT_EQ(f.junctions.count, 4u);
    ASSERT_EQ(f.at.size(), 4u);
    std::vector<double> y;
    for (const dvec3 p : f.at) {
        EXPECT_EQ(p.x, 8);
        y.push_back(p.y);
    }
    std::sort(y.begin(), y.end());
    EXPECT_EQ(y, (std::vector<double>{1, 3, 5, 7}));
    EXPECT_EQ(f.junctions.of_objects, (std::vector<std::uint64_t>{0, 4}));  // the long edges are those of the second
}

TEST(TJunctions, GridsOfOneStepHaveNone) {
    EXPECT_EQ(junctions_of({flat_grid(0, 1, 0), flat_grid(8, 1, 1)}).junctions.count, 0u);
    EXPECT_EQ(junctions_of({make_cube()}).junctions.count, 0u);
    EXPECT_EQ(junctions_of({}).junctions.count, 0u);
    EXPECT_EQ(junctions_of({Shape{}}).junctions.count, 0u);
}

TEST(TJunctions, AVertexOffTheEdgeOrAtItsEndIsNone) {
    for (const float off : {0.0f, 1e-6f, 1e-3f}) {
        Shape s;
        s.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5f, off, 0}, {0, -1, 0}, {1, -1, 0}};
        s.indices = {0, 1, 2, 3, 4, 5};
        EXPECT_EQ(junctions_of({s}).junctions.count, off < 1e-5f ? 1u : 0u) << off;
        s.positions[3] = {1, off / 1000, 0};
        EXPECT_EQ(junctions_of({s}).junctions.count, 0u) << off;
    }
}

TEST(TJunctions, AnEdgeInsideASurfaceIsNone) {
    Shape s = flat_grid(0, 8, 0);  // its diagonal is an edge of two faces
    s.texcoords.clear();
    s.positions.insert(s.positions.end(), {{4, 4, 0}, {4, 4, 1}, {4, 5, 1}});
    s.indices.insert(s.indices.end(), {4, 5, 6});
    EXPECT_EQ(junctions_of({s}).junctions.count, 0u);
}

TEST(TJunctions, TheTurnOfTheModelInTheWorldDoesNotMatter) {
    std::mt19937 random(3);
    const dmat4 to_world = random_affine(random, false);
    std::vector<Shape> shapes{flat_grid(0, 0.5f, 0), flat_grid(8, 2, 1)};
    for (Shape& s : shapes) s.to_world = to_world;
    EXPECT_EQ(junctions_of(shapes).junctions.count, 12u);
}

TEST(TJunctions, AThinFaceThatClosesTheGapIsNone) {
    Shape s;
    s.positions = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, 0, 0}, {1, -1, 0}};
    s.indices = {0, 1, 2, 3, 0, 4, 1, 3, 4};
    EXPECT_EQ(junctions_of({s}).junctions.count, 1u);
    s.indices.insert(s.indices.end(), {0, 3, 1});  // of no area
    EXPECT_EQ(junctions_of({s}).junctions.count, 0u);
}

TEST(TJunctions, RandomSoupsAgreeWithEveryEdgeAgainstEveryVertex) {
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        std::mt19937 random(seed);
        Shape s;  // on integer positions, where a vertex is on an edge or clearly off it
        const std::uint32_t corners = 3 * (2 + random() % 30);
        for (std::uint32_t i = 0; i < corners; ++i) {
            s.positions.push_back({float(random() % 7), float(random() % 7), float(random() % 3)});
            s.indices.push_back(i);
        }
        Context context;
        const std::vector<Shape> shapes{s};
        const std::vector<AttributeMesh> meshes = views(shapes);
        const geometry::PlacedMeshes placed = geometry::place_vertices(meshes, -1, context);
        const std::vector<std::uint32_t> open = count_edges(placed, 1, context).open_corners;
        std::set<std::uint32_t> ends, expected;
        const auto next = [](std::uint32_t corner, std::uint32_t k) { return corner - corner % 3 + (corner + k) % 3; };
        for (const std::uint32_t corner : open) ends.insert({placed.place[corner], placed.place[next(corner, 1)]});
        for (const std::uint32_t corner : open)
            for (const std::uint32_t end : ends) {
                const dvec3 a = placed.position(corner), b = placed.position(next(corner, 1)), p = placed.position(end);
                const bool inside = cross(p - a, b - a) == dvec3{} && dot(p - a, b - a) > 0 && dot(p - b, a - b) > 0;
                if (inside && placed.place[next(corner, 2)] != end) expected.insert(end);
            }
        const geometry::TJunctions found = find_t_junctions(placed, open, 1, 1000, context);
        std::set<std::uint32_t> places;
        for (const geometry::TJunction& t : found.places) places.insert(t.place);
        EXPECT_EQ(places, expected) << seed;
        EXPECT_EQ(found.count, expected.size()) << seed;
    }
}

TEST(TJunctions, TheListIsBoundedAndTheCountIsNot) {
    const Found f = junctions_of({flat_grid(0, 0.125f, 0), flat_grid(8, 8, 1)}, 10);
    EXPECT_EQ(f.junctions.count, 63u);
    EXPECT_EQ(f.at.size(), 10u);
}

TEST(TJunctions, ManyEdgesOverManyPointsOnOneLineCostNoQuadraticTime) {
    Shape s;
    constexpr std::uint32_t count = 10'000;
    for (std::uint32_t i = 0; i < count; ++i) {
        s.positions.insert(s.positions.end(), {{-1 - float(i), 0, 0}, {1 + float(i), 0, 0}, {0, 1 + float(i), 0}});
        s.indices.insert(s.indices.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    }
    const Found f = junctions_of({s});
    EXPECT_EQ(f.junctions.count, 2u * (count - 1));  // all but the ends of the longest
    EXPECT_EQ(f.junctions.edges_not_searched, 0u);
}

TEST(TJunctions, WhatWouldTakeTooLongIsLeftOutAndCounted) {
    Shape s;  // long needles in one ball: each comes near a great many boxes
    std::mt19937 random(11);
    std::uniform_real_distribution<float> value(-1, 1);
    for (std::uint32_t i = 0; i < 60'000; ++i) s.positions.push_back({value(random), value(random), value(random)});
    for (std::uint32_t i = 0; i < 60'000; ++i) s.indices.push_back(i);
    EXPECT_EQ(junctions_of({s}).junctions.edges_not_searched, 0u);
    const Found f = junctions_of({s}, 1000, 10);
    EXPECT_GT(f.junctions.edges_not_searched, 0u);
    EXPECT_LT(f.junctions.edges_not_searched, 60'000u);
}

}  // namespace
}  // namespace rakelight::test
