// SPDX-License-Identifier: Apache-2.0
#include "geometry/faults/edge_census.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <map>
#include <random>

#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

using geometry::EdgeCensus;

/// Views must outlive the census, so both are made here.
EdgeCensus census_of(const std::vector<Shape>& shapes, std::uint32_t objects = 1) {
    Context context;
    const std::vector<AttributeMesh> meshes = views(shapes);
    return count_edges(geometry::place_vertices(meshes, -1, context), objects, context);
}

std::uint32_t object_count(const std::vector<Shape>& shapes) { return std::uint32_t(shapes.size()); }

/// Every corner its own vertex.
Shape unshared(const Shape& s) {
    Shape out;
    for (const std::uint32_t i : s.indices) {
        out.indices.push_back(std::uint32_t(out.positions.size()));
        out.positions.push_back(s.positions[i]);
    }
    return out;
}

TEST(EdgeCensus, ACubeIsClosedWith18EdgesHoweverItsVerticesAreShared) {
    for (const Shape& cube : {make_cube(), unshared(make_cube())}) {
        const EdgeCensus c = census_of({cube});
        EXPECT_EQ(c.objects[0].edges, 18u);
        EXPECT_TRUE(c.objects[0].is_closed());
        EXPECT_EQ(c.objects[0].inconsistent, 0u);
        EXPECT_EQ(c.objects[0].non_manifold, 0u);
        EXPECT_TRUE(c.open_corners.empty());
        EXPECT_TRUE(c.border_edges.empty());
    }
}

TEST(EdgeCensus, ACubeWithoutASideHasFourOpenEdges) {
    Shape cube = make_cube();
    cube.indices.resize(30);
    const EdgeCensus c = census_of({cube});
    EXPECT_EQ(c.objects[0].open, 4u);
    EXPECT_FALSE(c.objects[0].is_closed());
    EXPECT_EQ(c.open_corners.size(), 4u);
    for (const std::uint32_t corner : c.open_corners) {  // all of them lie in the plane x = 1
        const std::uint32_t next = corner - corner % 3 + (corner + 1) % 3;
        EXPECT_EQ(cube.positions[cube.indices[corner]].x, 1);
        EXPECT_EQ(cube.positions[cube.indices[next]].x, 1);
    }
}

TEST(EdgeCensus, AFaceTurnedRoundIsInconsistentAtItsThreeEdges) {
    Shape cube = make_cube();
    std::swap(cube.indices[0], cube.indices[1]);
    const EdgeCensus c = census_of({cube});
    EXPECT_EQ(c.objects[0].inconsistent, 3u);
    EXPECT_TRUE(c.objects[0].is_closed());
}

TEST(EdgeCensus, TheBackOfABookOfThreePagesIsNotManifold) {
    Shape book;
    book.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    book.indices = {0, 1, 2, 0, 1, 3, 1, 0, 4};
    const EdgeCensus c = census_of({book});
    EXPECT_EQ(c.objects[0].non_manifold, 1u);
    EXPECT_EQ(c.objects[0].edges, 7u);
    EXPECT_EQ(c.objects[0].open, 6u);
    EXPECT_EQ(c.objects[0].inconsistent, 0u);
}

TEST(EdgeCensus, ObjectsAreCountedApartAndTheirBorderIsFound) {
    const std::vector<Shape> hinge = make_hinge(1);
    const EdgeCensus c = census_of(hinge, 2);
    for (const auto& object : c.objects) {
        EXPECT_EQ(object.edges, 5u);
        EXPECT_EQ(object.open, 4u);
    }
    ASSERT_EQ(c.border_edges.size(), 1u);
    EXPECT_EQ(c.border_edges[0], (geometry::PlaceEdge{0, 1}));
    EXPECT_EQ(c.open_corners.size(), 6u);  // the border is not open in the model
    EXPECT_TRUE(c.inconsistent_borders.empty());
}

TEST(EdgeCensus, AnObjectInsideOutIsFoundAtItsBorder) {
    std::vector<Shape> hinge = make_hinge(1);
    for (std::size_t i = 0; i < 6; i += 3) std::swap(hinge[1].indices[i], hinge[1].indices[i + 1]);
    const EdgeCensus c = census_of(hinge, 2);
    ASSERT_EQ(c.inconsistent_borders.size(), 1u);
    EXPECT_EQ(c.inconsistent_borders[0].object_a, 0u);
    EXPECT_EQ(c.inconsistent_borders[0].object_b, 1u);
    EXPECT_EQ(c.inconsistent_borders[0].edges, 1u);
    EXPECT_EQ(c.objects[1].inconsistent, 0u);
}

// One stored half of a box, open at x = 0, as itself and as its mirror image.
TEST(EdgeCensus, WindingIsJudgedWhereAMirroringMatrixPutsIt) {
    Shape half;
    for (const float x : {-1.0f, 0.0f})
        for (const float y : {0.0f, 1.0f})
            for (const float z : {0.0f, 1.0f}) half.positions.push_back({x, y, z});
    half.indices = {0, 1, 3, 0, 3, 2, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};
    Shape image = half;
    image.object = 1;
    image.to_world = scaling(dvec3{-1, 1, 1});
    const EdgeCensus c = census_of({half, image}, 2);
    EXPECT_EQ(c.border_edges.size(), 4u);
    EXPECT_TRUE(c.inconsistent_borders.empty());
    EXPECT_EQ(c.objects[0].inconsistent + c.objects[1].inconsistent, 0u);

    for (std::size_t i = 0; i < image.indices.size(); i += 3) std::swap(image.indices[i], image.indices[i + 1]);
    const EdgeCensus turned = census_of({half, image}, 2);
    ASSERT_EQ(turned.inconsistent_borders.size(), 1u);
    EXPECT_EQ(turned.inconsistent_borders[0].edges, 4u);
}

TEST(EdgeCensus, PartsOfACutTorusHaveTheirBordersAsOpenEdges) {
    const Shape torus = make_torus(24, 12);
    EXPECT_TRUE(census_of({torus}).objects[0].is_closed());
    EXPECT_EQ(census_of({torus}).objects[0].edges, 24u * 12 * 3);
    const std::vector<Shape> parts = cut_at_random(torus, 7, 5);
    const EdgeCensus c = census_of(parts, object_count(parts));
    std::uint64_t open = 0, edges = 0;
    for (const auto& object : c.objects) open += object.open, edges += object.edges;
    EXPECT_EQ(open, 2 * c.border_edges.size());
    EXPECT_EQ(edges, 24u * 12 * 3 + c.border_edges.size());
    EXPECT_TRUE(c.open_corners.empty());
}

TEST(EdgeCensus, FacesThatAreNoneCountForNothing) {
    Shape s;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    s.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}, {0, 0, 0}};
    s.indices = {0, 1, 3, 0, 1, 4, 2, 2, 2};
    const EdgeCensus c = census_of({s});
    EXPECT_EQ(c.objects[0].edges, 0u);
    EXPECT_FALSE(c.objects[0].is_closed());
    EXPECT_TRUE(census_of({}, 0).objects.empty());
    EXPECT_EQ(census_of({Shape{}}).objects[0].edges, 0u);
}

TEST(EdgeCensus, RandomSoupsAgreeWithAMapOfAllEdges) {
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        std::mt19937 random(seed);
        std::vector<Shape> shapes(3);  // on few integer positions, so that all kinds of edges come about
        for (std::uint32_t o = 0; o < 3; ++o) {
            shapes[o].object = o;
            for (std::uint32_t i = 0; i < 3 * (5 + random() % 40); ++i) {
                shapes[o].positions.push_back({float(random() % 3), float(random() % 3), float(random() % 2)});
                shapes[o].indices.push_back(i);
            }
            shapes[o].indices.resize(shapes[o].indices.size() / 3 * 3);
        }
        using Key = std::array<float, 6>;
        std::map<Key, std::map<std::uint32_t, std::vector<bool>>> edges;
        for (const Shape& s : shapes)
            for (std::size_t t = 0; t < s.indices.size(); t += 3) {
                const vec3 p[3] = {s.positions[t], s.positions[t + 1], s.positions[t + 2]};
                if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) continue;
                for (std::size_t k = 0; k < 3; ++k) {
                    const vec3 a = p[k], b = p[(k + 1) % 3];
                    const Key ab{a.x, a.y, a.z, b.x, b.y, b.z}, ba{b.x, b.y, b.z, a.x, a.y, a.z};
                    edges[std::min(ab, ba)][s.object].push_back(ab < ba);
                }
            }
        std::vector<geometry::ObjectEdges> expected(3);
        std::size_t open = 0, borders = 0;
        for (const auto& [key, uses] : edges) {
            borders += uses.size() > 1;
            open += uses.size() == 1 && uses.begin()->second.size() == 1;
            for (const auto& [object, ways] : uses) {
                ++expected[object].edges;
                expected[object].open += ways.size() == 1;
                expected[object].inconsistent += ways.size() == 2 && ways[0] == ways[1];
                expected[object].non_manifold += ways.size() > 2;
            }
        }
        const EdgeCensus c = census_of(shapes, 3);
        EXPECT_EQ(c.open_corners.size(), open) << seed;
        EXPECT_EQ(c.border_edges.size(), borders) << seed;
        for (std::size_t o = 0; o < 3; ++o) {
            EXPECT_EQ(c.objects[o].edges, expected[o].edges) << seed;
            EXPECT_EQ(c.objects[o].open, expected[o].open) << seed;
            EXPECT_EQ(c.objects[o].inconsistent, expected[o].inconsistent) << seed;
            EXPECT_EQ(c.objects[o].non_manifold, expected[o].non_manifold) << seed;
        }
    }
}

TEST(EdgeCensus, ManyCopiesOnOneSpotAreOneNonManifoldEdgeForNobody) {
    std::vector<Shape> copies(1000, make_cube());
    for (std::uint32_t i = 0; i < copies.size(); ++i) copies[i].object = i;
    const EdgeCensus c = census_of(copies, object_count(copies));
    EXPECT_EQ(c.border_edges.size(), 18u);
    for (const auto& object : c.objects) EXPECT_TRUE(object.is_closed() && object.non_manifold == 0);
}

}  // namespace
}  // namespace rakelight::test
