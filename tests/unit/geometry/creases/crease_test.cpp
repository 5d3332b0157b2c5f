// SPDX-License-Identifier: Apache-2.0
// Crease angle: which faces share a normal, where the limit lies, and that joining is transitive.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "unit/geometry/shapes.h"

namespace rakelight::test {
namespace {

AttributeOptions crease(double angle_deg) {
    AttributeOptions options = published();
    options.crease_angle_rad = radians(angle_deg);
    options.tangents = false;
    return options;
}

/// A strip of quads along z, each bent from the one before by `step_deg`, as one object each: the edge between two is shared.
std::vector<Shape> make_chain(int quads, double step_deg) {
    std::vector<Shape> chain;
    dvec3 at;
    for (int i = 0; i < quads; ++i) {
        const double a = radians(step_deg * i);
        const dvec3 next = at + dvec3{std::cos(a), std::sin(a), 0};
        Shape s;
        s.object = std::uint32_t(i);
        const vec3 p = cast<float>(at), q = cast<float>(next);
        s.positions = {p, q, {q.x, q.y, -1}, {p.x, p.y, -1}};
        s.indices = {0, 1, 2, 0, 2, 3};
        chain.push_back(s);
        at = next;
    }
    return chain;
}

TEST(Crease, CubeStaysHardBelowNinetyDegrees) {
    const Shape cube = make_cube();
    const MeshAttributes out = compute({cube}, crease(60)).front();
    EXPECT_EQ(out.normals.size(), 24u);
    EXPECT_EQ(out.source_vertex.size(), 16u);
    EXPECT_EQ(out.indices.size(), 36u);
    for (std::size_t i = 0; i < 36; ++i) {
        const vec3 n = corner_normal(cube, out, i);
        EXPECT_FLOAT_EQ(std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z), 1.0f);
        const std::uint32_t v = out.indices[i];
        EXPECT_EQ(v < 8 ? v : out.source_vertex[v - 8], cube.indices[i]);  // an appended vertex copies the corner's own
    }
}

TEST(Crease, OneHundredEightyDegreesJoinTheCubesCorners) {
    const Shape cube = make_cube();
    AttributeOptions options = crease(180);
    options.weight = CornerWeight::angle;
    const MeshAttributes out = compute({cube}, options).front();
    EXPECT_TRUE(out.indices.empty());
    ASSERT_EQ(out.normals.size(), 8u);
    for (std::size_t v = 0; v < 8; ++v) {
        const vec3 outward = cube.positions[v] + vec3{-0.5f, -0.5f, -0.5f};
        EXPECT_LT(angle_between(out.normals[v], normalize_or(outward, vec3{})), 1e-6);
    }
}

TEST(Crease, LimitIsInclusive) {
    for (const double bend : {30.0, 45.0, 60.0, 90.0, 120.0, 179.0}) {
        const auto hinge = make_hinge(radians(bend));
        const auto joined = compute(hinge, crease(bend)), apart = compute(hinge, crease(bend - 0.01));
        EXPECT_EQ(joined[0].normals[0], joined[1].normals[0]) << bend;
        EXPECT_NEAR(degrees(angle_between(joined[0].normals[0], joined[0].normals[2])), bend / 2, bend / 4) << bend;
        EXPECT_NEAR(degrees(angle_between(apart[0].normals[0], apart[1].normals[0])), bend, 1e-3) << bend;
        EXPECT_EQ(apart[0].normals[0], apart[0].normals[2]) << bend;
    }
}

TEST(Crease, RegularPrismsJoinAtTheirOwnAngle) {
    // The float positions of a hexagon bend a little more or less than 60 degrees: all edges must fall on one side.
    for (const std::uint32_t sides : {3u, 5u, 6u, 7u, 12u, 90u}) {
        const Shape prism = make_cylinder(sides, 1);
        EXPECT_TRUE(compute({prism}, crease(360.0 / sides)).front().indices.empty()) << sides;
        EXPECT_GT(compute({prism}, crease(360.0 / sides - 0.01)).front().source_vertex.size(), sides) << sides;
    }
}

TEST(Crease, ZeroIsFlat) {
    const Shape sphere = make_sphere(24, 12);
    const MeshAttributes out = compute({sphere}, crease(0)).front();
    for (std::size_t t = 0; t < sphere.indices.size() / 3; ++t) {
        const auto p = [&](std::size_t k) { return cast<double>(sphere.positions[sphere.indices[3 * t + k]]); };
        const dvec3 n = normalize_or(cross(p(1) - p(0), p(2) - p(0)), dvec3{});
        if (n == dvec3{}) continue;
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(corner_normal(sphere, out, 3 * t + k), cast<float>(n));
    }
}

TEST(Crease, OppositeFacesJoinOnlyAtOneHundredEighty) {
    // A sheet folded onto itself: the fold's two vertices see normals exactly 180 degrees apart and a third face between.
    Shape fan;
    fan.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
    fan.indices = {0, 1, 2, 0, 4, 1, 0, 3, 1};  // up (0,1,0), down (0,-1,0), (-1,0,0)... all about the edge 0-1
    const MeshAttributes below = compute({fan}, crease(179.9)).front(), all = compute({fan}, crease(180)).front();
    EXPECT_GT(below.normals.size(), 0u);
    EXPECT_TRUE(all.indices.empty());
}

TEST(Crease, ActsAcrossObjects) {
    const auto parts = cut_by_planes(make_cylinder(24, 2), 3);
    const auto smooth = compute(parts, crease(15)), hard = compute(parts, crease(14.9));
    std::size_t shared = 0;
    for (std::size_t a = 0; a < parts[0].indices.size(); ++a)
        for (std::size_t b = 0; b < parts[1].indices.size(); ++b) {
            if (parts[0].positions[parts[0].indices[a]] != parts[1].positions[parts[1].indices[b]]) continue;
            EXPECT_EQ(corner_normal(parts[0], smooth[0], a), corner_normal(parts[1], smooth[1], b));
            ++shared;
        }
    EXPECT_GT(shared, 0u);
    std::size_t differing = 0;
    for (std::size_t a = 0; a < parts[0].positions.size(); ++a)
        for (std::size_t b = 0; b < parts[1].positions.size(); ++b)
            differing += parts[0].positions[a] == parts[1].positions[b] && hard[0].normals[a] != hard[1].normals[b];
    EXPECT_GT(differing, 0u);
}

TEST(Crease, ChainsJoinTransitively) {
    // At the apex of a fan the first and the last face are 90 degrees apart, neighbors 30: all one group at 30.
    std::vector<Shape> fan;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const double a = radians(30.0 * i), b = radians(30.0 * (i + 1));
        Shape s;
        s.object = i;
        s.positions = {
            {0, 0, 0}, {float(std::cos(a)), float(std::sin(a)), 1}, {float(std::cos(b)), float(std::sin(b)), 1}};
        s.indices = {0, 1, 2};
        fan.push_back(s);
    }
    const auto bend = angle_between(compute(fan, crease(0))[0].normals[0], compute(fan, crease(0))[1].normals[0]);
    const auto out = compute(fan, crease(degrees(bend)));
    for (std::size_t i = 1; i < fan.size(); ++i) EXPECT_EQ(out[0].normals[0], out[i].normals[0]) << i;
    const auto apart = compute(fan, crease(degrees(bend) - 0.01));
    for (std::size_t i = 1; i < fan.size(); ++i) EXPECT_NE(apart[0].normals[0], apart[i].normals[0]) << i;
}

TEST(Crease, FacesThatShareOnlyAVertexAreNotJoinedBelowOneHundredEighty) {
    Shape bow_tie;  // two coplanar triangles that touch in one vertex, one tilted by 10 degrees
    bow_tie.positions = {{0, 0, 0}, {1, 0, -1}, {1, 0.2f, 1}, {-1, 0, 1}, {-1, 0, -1}};
    bow_tie.indices = {0, 2, 1, 0, 4, 3};
    EXPECT_EQ(compute({bow_tie}, crease(90)).front().source_vertex.size(), 1u);
    EXPECT_TRUE(compute({bow_tie}, crease(180)).front().indices.empty());
}

TEST(Crease, ManyPagesOnOneSpineGroupAsByComparingAllPairs) {
    // More faces on an edge than are compared pair by pair: the circular way must find the same groups.
    std::mt19937 random(9);
    for (int round = 0; round < 20; ++round) {
        const std::size_t count = 20 + random() % 60;
        std::vector<double> angle;
        std::vector<Shape> pages;
        for (std::size_t i = 0; i < count; ++i) {
            angle.push_back(double(random() % 3600) / 10);
            Shape s;
            s.object = std::uint32_t(i);
            s.positions = {
                {0, 0, 0}, {0, 0, 1}, {float(std::cos(radians(angle[i]))), float(std::sin(radians(angle[i]))), 0.5f}};
            s.indices = {0, 1, 2};
            pages.push_back(s);
        }
        const double limit = 2.05;
        std::vector<std::size_t> group(count);
        for (std::size_t i = 0; i < count; ++i) group[i] = i;
        for (std::size_t pass = 0; pass < count; ++pass)
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t j = 0; j < count; ++j) {
                    const double d = std::fabs(angle[i] - angle[j]);
                    if (std::fmin(d, 360 - d) <= limit) group[i] = group[j] = std::min(group[i], group[j]);
                }
        const auto out = compute(pages, crease(limit));
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                if (group[i] == group[j])
                    EXPECT_EQ(out[i].normals[0], out[j].normals[0]) << round;
                else
                    EXPECT_NE(out[i].normals[0], out[j].normals[0]) << round;
            }
    }
}

// Two triangles of a roof, n times over, with as many facing the other way: at pi all normals cancel, and the sides count.
TEST(Crease, SidesOfManyCoincidentShellsAreSmoothOverTheirRidge) {
    for (const std::uint32_t count : {1u, 4u, 5u, 20u}) {
        std::vector<Shape> shells(2);
        for (std::uint32_t side = 0; side < 2; ++side)
            for (const std::uint32_t eaves : {2u, 3u})
                for (std::uint32_t k = 0; k < count; ++k) {
                    Shape& s = shells[side];
                    const auto first = std::uint32_t(s.positions.size());
                    s.positions.insert(s.positions.end(), {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {-1, 0.5f, 1}});
                    const bool turned = (eaves == 3) != (side == 1);
                    s.indices.insert(s.indices.end(),
                                     {first, first + (turned ? eaves : 1), first + (turned ? 1 : eaves)});
                    s.object = side;
                }
        const auto out = compute(shells, published());
        for (std::uint32_t side = 0; side < 2; ++side) {
            const vec3 normal = corner_normal(shells[side], out[side], 0);
            EXPECT_GT(std::fabs(normal.x), 0.2f) << count;  // neither page's own
            for (std::size_t i = 0; i < shells[side].indices.size(); i += 3)
                EXPECT_EQ(corner_normal(shells[side], out[side], i), normal) << count << " " << i;
        }
    }
}

TEST(Crease, DegenerateTriangleDoesNotJoinTwoFaces) {
    // Two coplanar triangles that touch in one vertex, bridged by a triangle of no area.
    Shape s;
    s.positions = {{0, 0, 0}, {1, 0, -1}, {1, 0.2f, 1}, {-1, 0, 1}, {-1, 0, -1}, {2, 0.4f, 2}};
    s.indices = {0, 2, 1, 0, 4, 3, 0, 2, 5};
    const MeshAttributes out = compute({s}, crease(90)).front();
    EXPECT_EQ(out.degenerate_faces, 1u);
    EXPECT_EQ(out.source_vertex.size(), 1u);
}

TEST(Crease, ChainOfObjectsIsSmoothAtEachOfItsEdges) {
    const auto chain = make_chain(6, 20);
    const auto out = compute(chain, crease(20));
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
        EXPECT_EQ(out[i].normals[1], out[i + 1].normals[0]);
        EXPECT_NE(out[i].normals[0], out[i].normals[1]);  // groups are of one place, not of the whole strip
    }
}

// --- crease angles of single meshes ---------------------------------------------------------------------------------

/// @param own_deg  [shapes] < 0: none
std::vector<MeshAttributes> compute_with(const std::vector<Shape>& shapes, const std::vector<double>& own_deg,
                                         const AttributeOptions& options) {
    std::vector<AttributeMesh> meshes = views(shapes);
    for (std::size_t m = 0; m < meshes.size(); ++m)
        meshes[m].crease_angle_rad = own_deg[m] < 0 ? -1 : radians(own_deg[m]);
    Context context;
    return compute_attributes(meshes, options, context);
}

TEST(CreaseOfMeshes, OneForAllIsAsTheOptionsHaveIt) {
    const auto parts = cut_at_random(make_torus(24, 12), 3, 4);
    for (const double angle_deg : {0.0, 20.0, 180.0})
        for (const double other_deg : {0.0, 20.0, 180.0}) {
            const auto own = compute_with(parts, {angle_deg, angle_deg, angle_deg}, crease(other_deg));
            const auto by_options = compute(parts, crease(angle_deg));
            for (std::size_t m = 0; m < parts.size(); ++m) {
                EXPECT_EQ(own[m].normals, by_options[m].normals) << angle_deg << " in place of " << other_deg;
                EXPECT_EQ(own[m].indices, by_options[m].indices);
            }
        }
}

TEST(CreaseOfMeshes, BetweenTwoMeshesTheSmallerRules) {
    const auto chain = make_chain(3, 40);
    const auto is_joined = [&](std::vector<double> own_deg, double options_deg) {
        const auto out = compute_with(chain, own_deg, crease(options_deg));
        return std::pair(out[0].normals[1] == out[1].normals[0], out[1].normals[1] == out[2].normals[0]);
    };
    EXPECT_EQ(is_joined({-1, -1, -1}, 60), std::pair(true, true));
    EXPECT_EQ(is_joined({180, 50, 30}, 0), std::pair(true, false));
    EXPECT_EQ(is_joined({30, 180, 180}, 0), std::pair(false, true));
    EXPECT_EQ(is_joined({180, -1, 180}, 30), std::pair(false, false));
    EXPECT_EQ(is_joined({180, -1, 180}, 41), std::pair(true, true));
}

TEST(CreaseOfMeshes, MeshesOf180DegreesJoinAtAPlaceWithoutACommonEdge) {
    std::vector<Shape> parts(3);
    parts[0].positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, -1}};
    parts[1].positions = {{0, 0, 0}, {-1, 1, 0}, {-1, 1, 1}};
    parts[2].positions = {{0, 0, 0}, {0, -1, 3}, {0.5f, -1, 3}};
    for (std::uint32_t m = 0; m < 3; ++m) parts[m].indices = {0, 1, 2}, parts[m].object = m;
    auto out = compute_with(parts, {180, 180, 60}, crease(60));
    EXPECT_EQ(out[0].normals[0], out[1].normals[0]);
    EXPECT_NE(out[0].normals[0], out[2].normals[0]);
    out = compute_with(parts, {180, 179, 180}, crease(60));
    EXPECT_NE(out[0].normals[0], out[1].normals[0]);
    EXPECT_EQ(out[0].normals[0], out[2].normals[0]);
}

// Faces like the pages of a book, each a mesh with one of three angles; against every pair compared.
TEST(CreaseOfMeshes, ManyFacesOnOneEdgeAreJoinedAsEveryPairAsks) {
    constexpr double angles_deg[] = {5, 25, 120};
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        std::mt19937 random(seed);
        const std::size_t count = 5 + random() % 40;
        std::vector<Shape> pages(count);
        std::vector<double> turn(count), own(count);
        std::vector<dvec3> normal(count);
        for (std::size_t i = 0; i < count; ++i) {
            turn[i] = radians(double(random() % 3600) / 10 + 0.013 * double(i));  // no angle at a limit
            own[i] = angles_deg[random() % 3];
            pages[i].object = std::uint32_t(i);
            pages[i].positions = {{0, 0, 0}, {0, 0, 1}, {float(std::cos(turn[i])), float(std::sin(turn[i])), 0}};
            pages[i].indices = {0, 1, 2};
            normal[i] = normalize_or(cross(dvec3{0, 0, 1}, cast<double>(pages[i].positions[2])), dvec3{});
        }
        std::vector<std::size_t> group(count);
        for (std::size_t i = 0; i < count; ++i) group[i] = i;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const double angle_deg = degrees(std::acos(std::clamp(dot(normal[i], normal[j]), -1.0, 1.0)));
                if (angle_deg > std::min(own[i], own[j]) || group[i] == group[j]) continue;
                const std::size_t from = group[i], to = group[j];
                for (std::size_t& g : group) g = g == from ? to : g;
            }
        const auto out = compute_with(pages, own, crease(60));
        for (std::size_t i = 0; i < count; ++i) {
            dvec3 sum;
            for (std::size_t j = 0; j < count; ++j) sum += group[i] == group[j] ? normal[j] : dvec3{};
            if (length(sum) < 0.1) continue;  // what cancels is taken apart
            EXPECT_LT(angle_between(out[i].normals[0], cast<float>(normalize_or(sum, dvec3{}))), 1e-4)
                << seed << " " << i;
        }
    }
}

TEST(CreaseOfMeshes, BeyondAHalfTurnIsRefused) {
    EXPECT_THROW(compute_with(make_chain(1, 0), {181}, crease(60)), Error);
}

}  // namespace
}  // namespace rakelight::test
