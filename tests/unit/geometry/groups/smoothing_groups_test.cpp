// SPDX-License-Identifier: Apache-2.0
// Smoothing groups of both kinds, hints, and their place beside the crease angle.
#include <gtest/gtest.h>

#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

// The two quads of a hinge as one mesh with six vertices; groups per quad.
Shape grouped_hinge(double bend_deg, GroupKind kind, std::uint32_t first, std::uint32_t second) {
    const auto parts = make_hinge(radians(bend_deg));
    Shape s = parts[0];
    s.positions.push_back(parts[1].positions[2]);
    s.positions.push_back(parts[1].positions[3]);
    s.indices.insert(s.indices.end(), {0, 4, 1, 0, 5, 4});
    s.kind = kind;
    s.smoothing = {first, first, second, second};
    return s;
}

AttributeOptions crease(double angle_deg) {
    AttributeOptions options = published();
    options.crease_angle_rad = radians(angle_deg);
    return options;
}

std::size_t splits(const Shape& s, double crease_deg) {
    return compute({s}, crease(crease_deg)).front().source_vertex.size();
}

TEST(SmoothingGroups, MasksJoinWhereTheyShareABit) {
    EXPECT_EQ(splits(grouped_hinge(90, GroupKind::masks, 0b0110, 0b0100), 10), 0u);
    EXPECT_EQ(splits(grouped_hinge(90, GroupKind::masks, 0b0110, 0b1001), 10), 2u);
    EXPECT_EQ(splits(grouped_hinge(90, GroupKind::masks, 0x80000000u, 0x80000001u), 10), 0u);
}

TEST(SmoothingGroups, NumbersJoinWhereTheyAreEqual) {
    EXPECT_EQ(splits(grouped_hinge(90, GroupKind::numbers, 6, 6), 10), 0u);
    EXPECT_EQ(splits(grouped_hinge(90, GroupKind::numbers, 6, 4), 10), 2u);  // as masks these would join
    EXPECT_EQ(splits(grouped_hinge(90, GroupKind::numbers, 4000000000u, 4000000000u), 10), 0u);
}

TEST(SmoothingGroups, ZeroIsFlatEvenBetweenCoplanarFaces) {
    // Two quads of two triangles: each triangle stands alone; of 6 vertices 4 have 2 faces, 2 (on the hinge) have 3 or 2.
    for (const GroupKind kind : {GroupKind::masks, GroupKind::numbers}) {
        const Shape s = grouped_hinge(90, kind, 0, 0);
        const MeshAttributes out = compute({s}, crease(60)).front();
        EXPECT_EQ(out.normals.size(), 12u);
    }
}

TEST(SmoothingGroups, RuleOverTheCreaseAngleInsideAnObject) {
    EXPECT_EQ(splits(grouped_hinge(170, GroupKind::numbers, 3, 3), 1), 0u);
    EXPECT_EQ(splits(grouped_hinge(5, GroupKind::numbers, 3, 4), 179), 2u);
    EXPECT_EQ(splits(grouped_hinge(5, GroupKind::masks, 1, 2), 180), 2u);
}

TEST(SmoothingGroups, AreIgnoredWithoutAKind) {
    EXPECT_EQ(splits(grouped_hinge(30, GroupKind::none, 3, 4), 60), 0u);
    EXPECT_EQ(splits(grouped_hinge(90, GroupKind::none, 3, 3), 60), 2u);
}

TEST(SmoothingGroups, CreaseAngleRulesAcrossObjectsUnlessGroupsDo) {
    auto parts = make_hinge(radians(40));
    for (std::uint32_t i = 0; i < 2; ++i) {
        parts[i].kind = GroupKind::numbers;
        parts[i].smoothing = {i + 1, i + 1};
    }
    const auto by_angle = compute(parts, crease(60));
    EXPECT_EQ(by_angle[0].normals[0], by_angle[1].normals[0]);
    AttributeOptions across = crease(60);
    across.groups_across = true;
    const auto by_group = compute(parts, across);
    EXPECT_NE(by_group[0].normals[0], by_group[1].normals[0]);
    parts[1].smoothing = {1, 1};
    AttributeOptions narrow = crease(10);
    EXPECT_NE(compute(parts, narrow)[0].normals[0], compute(parts, narrow)[1].normals[0]);
    narrow.groups_across = true;
    EXPECT_EQ(compute(parts, narrow)[0].normals[0], compute(parts, narrow)[1].normals[0]);
}

TEST(SmoothingGroups, GroupsMayBeSplitOverMeshesOfOneObject) {
    auto parts = make_hinge(radians(90));
    for (Shape& s : parts) {
        s.object = 7;
        s.kind = GroupKind::masks;
        s.smoothing = {4, 4};
    }
    const auto out = compute(parts, crease(10));
    EXPECT_EQ(out[0].normals[0], out[1].normals[0]);
}

TEST(SmoothingGroups, HintsJoinCornersOfOnePlaceThatAreEqual) {
    Shape s = grouped_hinge(90, GroupKind::none, 0, 0);
    s.smoothing.clear();
    const vec3 up{0, 1, 0}, side{-1, 0, 0}, both{-0.5f, 0.5f, 0};
    s.hints = {up, up, up, up, up, up, side, side, side, side, side, side};
    EXPECT_EQ(splits(s, 10), 2u);
    EXPECT_EQ(splits(s, 120), 2u);  // hints rule inside the object
    for (std::size_t i = 0; i < s.indices.size(); ++i)
        if (s.indices[i] < 2) s.hints[i] = both;
    EXPECT_EQ(splits(s, 10), 0u);
    s.hints[0] = {-0.5f, 0.5f, -0.0f};  // -0 is +0
    EXPECT_EQ(splits(s, 10), 0u);
}

TEST(SmoothingGroups, ManyPagesOnOneSpineFollowTheirGroups) {
    std::mt19937 random(4);
    for (const GroupKind kind : {GroupKind::numbers, GroupKind::masks}) {
        Shape book;
        book.kind = kind;
        book.positions = {{0, 0, 0}, {0, 0, 1}};
        std::vector<std::uint32_t> leader(100);
        for (std::uint32_t i = 0; i < 100; ++i) {
            const double a = radians(0.9 * i);  // on a quarter turn, so that no group cancels
            book.positions.push_back({float(std::cos(a)), float(std::sin(a)), 0.5f});
            book.indices.insert(book.indices.end(), {0, 1, 2 + i});
            book.smoothing.push_back(kind == GroupKind::numbers ? random() % 12
                                                                : 1u << (random() % 16) | 1u << (random() % 3));
            leader[i] = i;
        }
        const auto join = [&](std::uint32_t a, std::uint32_t b) {
            return kind == GroupKind::numbers ? a == b && a != 0 : (a & b) != 0;
        };
        for (int pass = 0; pass < 100; ++pass)
            for (std::uint32_t i = 0; i < 100; ++i)
                for (std::uint32_t j = 0; j < 100; ++j)
                    if (join(book.smoothing[i], book.smoothing[j]))
                        leader[i] = leader[j] = std::min(leader[i], leader[j]);
        const MeshAttributes out = compute({book}, crease(1)).front();
        for (std::size_t i = 0; i < 100; ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_EQ(leader[i] == leader[j], output_vertex(book, out, 3 * i) == output_vertex(book, out, 3 * j));
    }
}

}  // namespace
}  // namespace rakelight::test
