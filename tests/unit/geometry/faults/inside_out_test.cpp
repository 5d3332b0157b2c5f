// SPDX-License-Identifier: Apache-2.0
#include "geometry/faults/inside_out.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/faults/edge_census.h"
#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

using geometry::InsideOutBody;

std::vector<InsideOutBody> found_in(std::vector<Shape> shapes) {
    for (std::uint32_t i = 0; i < shapes.size(); ++i) shapes[i].object = i;
    Context context;
    const std::vector<AttributeMesh> meshes = views(shapes);
    const geometry::PlacedMeshes placed = geometry::place_vertices(meshes, -1, context);
    return find_inside_out(placed, count_edges(placed, std::uint32_t(shapes.size()), context).open_corners, context);
}

Shape turned(Shape s) {
    for (std::size_t i = 0; i < s.indices.size(); i += 3) std::swap(s.indices[i], s.indices[i + 1]);
    return s;
}

/// @param size  of what has size 1; then moved
Shape placed_at(Shape s, double size, dvec3 at) {
    for (std::size_t c = 0; c < 3; ++c) s.to_world[c][c] = size;
    s.to_world[3] = {at.x, at.y, at.z, 1};
    return s;
}

/// Triangles that have an area.
std::uint32_t faces(const Shape& s) {
    std::uint32_t count = 0;
    for (std::size_t t = 0; t < s.indices.size() / 3; ++t) count += length(edge_product(s, t)) > 0;
    return count;
}

TEST(InsideOut, PartsThatCloseTogetherAndLookInwardsAreOneBody) {
    for (const Shape& whole : {make_sphere(24, 12), make_torus(24, 12), make_cube()}) {
        for (const auto& parts : {cut_by_planes(whole, 4), cut_at_random(whole, 14, 5), std::vector{whole}})
            EXPECT_TRUE(found_in(parts).empty());
        const Shape inwards = turned(whole);
        for (const auto& parts : {cut_by_planes(inwards, 4), cut_at_random(inwards, 14, 5), std::vector{inwards}}) {
            const std::vector<InsideOutBody> found = found_in(parts);
            ASSERT_EQ(found.size(), 1u);
            EXPECT_EQ(found[0].triangles, faces(whole));
            EXPECT_EQ(found[0].objects.size(),
                      std::size_t(std::count_if(parts.begin(), parts.end(),
                                                [](const Shape& s) { return !s.indices.empty(); })));
        }
    }
}

TEST(InsideOut, WhatIsOpenOrWoundBothWaysIsNotJudged) {
    std::vector<Shape> parts = cut_by_planes(turned(make_sphere(24, 12)), 4);
    const Shape last = parts.back();
    parts.pop_back();
    EXPECT_TRUE(found_in(parts).empty());  // a part is missing
    parts.push_back(turned(last));
    EXPECT_TRUE(found_in(parts).empty());
    Shape sheet = make_cube();  // as flat as a sheet of paper: two sides back to back
    for (vec3& p : sheet.positions) p.z *= 1e-6f;
    EXPECT_TRUE(found_in({turned(sheet)}).empty());
}

TEST(InsideOut, TheInnerSideOfAHollowBodyLooksInwardsRightly) {
    const Shape ball = make_sphere(24, 12), hollow = placed_at(turned(ball), 0.9, {});
    EXPECT_TRUE(found_in({ball, hollow}).empty());
    EXPECT_EQ(found_in({ball, placed_at(turned(ball), 0.9, {5, 0, 0})}).size(), 1u);
    EXPECT_EQ(found_in({turned(ball), hollow}).size(), 1u) << "the outer one is wrong";
}

TEST(InsideOut, MatricesThatMirrorTurnTheFrontsAlong) {
    Shape mirrored = make_sphere(24, 12), wrong = turned(mirrored);
    mirrored.to_world[0][0] = wrong.to_world[0][0] = -1;
    EXPECT_TRUE(found_in({mirrored}).empty());
    EXPECT_EQ(found_in({wrong}).size(), 1u);
}

TEST(InsideOut, SeveralBodiesAreCountedWhereverTheyStand) {
    const Shape ball = make_sphere(24, 12), wrong = turned(ball);
    const std::vector<Shape> all = {placed_at(wrong, 1, {1e6, 0, 0}), placed_at(ball, 1, {1e6 + 3, 0, 0}),
                                    placed_at(wrong, 1e-3, {-1e3, 5, 0}), placed_at(wrong, 100, {0, 0, 1e6})};
    const std::vector<InsideOutBody> found = found_in(all);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].objects, std::vector<std::uint32_t>{0});
    EXPECT_EQ(found[1].objects, std::vector<std::uint32_t>{2});
    EXPECT_EQ(found[2].objects, std::vector<std::uint32_t>{3});
}

/// `n` tetrahedra in a row along x, [0, 1], that look inwards.
Shape tetrahedra(std::uint32_t n) {
    Shape s;
    for (std::uint32_t i = 0; i < n; ++i) {
        const float size = 0.5f / float(n), x = float(i) / float(n);
        for (const vec3 p : {vec3{0, 0, 0}, vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}})
            s.positions.push_back(p * size + vec3{x, 0.25f, 0.25f});
        for (const std::uint32_t k : {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2}) s.indices.push_back(4 * i + k);
    }
    return s;
}

TEST(InsideOut, AHundredThousandInOneBoxTakeNoPairsOfThem) {
    // The box comes last. Pairs of bodies would be 10^10, and the test run for minutes.
    const std::vector<Shape> all = {tetrahedra(100'000), placed_at(make_sphere(8, 4), 10, {})};
    EXPECT_TRUE(found_in(all).empty());
    EXPECT_EQ(found_in({tetrahedra(7)}).size(), 7u);
}

}  // namespace
}  // namespace rakelight::test
