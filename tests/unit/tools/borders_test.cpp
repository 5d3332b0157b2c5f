// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect/borders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <random>

#include "math/linear.h"
#include "tools/inspect/border_corners.h"
#include "tools/inspect/place_angles.h"
#include "tools/inspect/surfaces.h"
#include "unit/geometry/shapes.h"
#include "unit/render/test_scene.h"

namespace rakelight {
namespace {

using test::two_squares;

/// Beside the normals that smoothing over the whole model gives.
Inspection inspected(const Scene& scene, const PrepareOptions& prepare = {}, bool lines = false) {
    Context context;
    return inspect(scene,
                   {.surfaces = false, .seam_lines = lines, .authored = AuthoredNormals::replaced, .prepare = prepare},
                   context);
}

/// Beside what smooth_file() makes of the scene.
Inspection inspected_as_smooth_does(const Scene& scene, bool lines = false) {
    Context context;
    return inspect(scene, {.surfaces = false, .seam_lines = lines}, context);
}

/// Both squares, the right one with this normal everywhere.
Scene squares_with_normal(vec3 right) {
    Scene scene = two_squares();
    scene.meshes[1].normals = std::vector<vec3>(4, right);
    return scene;
}

/// The unit vector at an angle from +Z towards +X.
vec3 tilted(double deg) { return {float(std::sin(radians(deg))), 0, float(std::cos(radians(deg)))}; }

TEST(Borders, TwoSquaresShareTheTwoEndsOfTheirEdge) {
    const Inspection i = inspected(two_squares());
    EXPECT_EQ(i.shared_positions, 2u);
    ASSERT_EQ(i.borders.size(), 1u);
    const BorderSummary& b = i.borders[0];
    EXPECT_EQ(b.object_a, 0u);
    EXPECT_EQ(b.object_b, 1u);
    EXPECT_EQ(b.positions, 2u);
    EXPECT_EQ(b.continuous, 2u);
    EXPECT_EQ(b.joined, 2u);
    EXPECT_EQ(b.largest_deg, 0);
    EXPECT_EQ(b.seam_deg, 0);
    EXPECT_EQ(i.seams.normals_before, "the file's");
}

TEST(Borders, ASeamIsTheAngleBetweenTheNormalsInTheWorld) {
    Scene scene = squares_with_normal({0.6f, 0, 0.8f});
    const BorderSummary b = inspected(scene).borders[0];
    EXPECT_NEAR(b.seam_deg, 36.8699, 1e-3);
    EXPECT_NEAR(b.before.max_deg, 36.8699, 1e-3);
    EXPECT_NEAR(b.before.mean_deg, 36.8699, 1e-3);
    EXPECT_NEAR(b.before.p95_deg, 36.8699, 1e-3);
    EXPECT_EQ(b.after.max_deg, 0);
    EXPECT_EQ(b.continuous, 0u);
    EXPECT_EQ(b.joined, 2u);
    EXPECT_EQ(b.seam_position.x, 0);
    scene.nodes[1].local.scale = {1, 1, -1};  // mirrored in its own plane: the normal points to the back in the world
    EXPECT_NEAR(inspected(scene).borders[0].largest_deg, 180 - 36.8699, 1e-3);
}

/// One object of both squares, red and blue.
Scene object_of_two_materials(vec3 right) {
    Scene scene = squares_with_normal(right);
    scene.nodes.resize(1);
    scene.nodes[0].name = "car";
    scene.nodes[0].meshes = {0, 1};
    scene.materials.resize(2);
    scene.materials[0].name = "red", scene.materials[1].name = "blue";
    scene.meshes[0].material = 0, scene.meshes[1].material = 1;
    return scene;
}

TEST(Borders, MeshesOfOneObjectArePartsToo) {
    const Scene scene = object_of_two_materials({0.6f, 0, 0.8f});
    const Inspection i = inspected_as_smooth_does(scene, true);
    EXPECT_EQ(i.shared_positions, 2u);
    ASSERT_EQ(i.borders.size(), 1u);
    const BorderSummary& b = i.borders[0];
    EXPECT_EQ(std::pair(b.object_a, b.object_b), std::pair(0u, 0u));
    EXPECT_EQ(std::pair(b.mesh_a, b.mesh_b), std::pair(0u, 1u));
    EXPECT_EQ(std::pair(b.material_a, b.material_b), std::pair(0u, 1u));
    EXPECT_NEAR(b.seam_deg, 36.8699, 1e-3);
    ASSERT_EQ(i.seam_lines.size(), 1u);
    EXPECT_NEAR(i.seam_lines[0].deg_b, 36.8699, 1e-3);
    EXPECT_EQ(i.seams.normals_after, "joined where parts meet");
    const std::vector<CheckFailure> failures = check_limits(i, {});
    ASSERT_EQ(failures.size(), 1u);
    EXPECT_NE(failures[0].message.find("between 'red' and 'blue' of 'car'"), std::string::npos) << failures[0].message;
    EXPECT_TRUE(inspected_as_smooth_does(object_of_two_materials({0, 0, 1}), true).seam_lines.empty());
}

TEST(Borders, PairsOfObjectsHoldTheWorstOfTheirMeshes) {
    // Four squares at one edge pair: a left object of two meshes, a right one whose two meshes lean by 5 and 20 degrees.
    Scene scene = two_squares();
    scene.meshes.push_back(scene.meshes[0]), scene.meshes.push_back(scene.meshes[1]);
    scene.meshes[1].normals = std::vector<vec3>(4, tilted(5));
    scene.meshes[3].normals = std::vector<vec3>(4, tilted(20));
    scene.nodes[0].meshes = {0, 2}, scene.nodes[1].meshes = {1, 3};
    const Inspection i = inspected(scene);
    EXPECT_EQ(i.seams.positions, 6u) << "those of the edge, and the far ends of squares that lie on one another";
    ASSERT_EQ(i.borders.size(), 3u);
    for (const BorderSummary& b : i.borders) {
        const double wanted = b.object_a != b.object_b ? 20 : b.object_a == 1 ? 15 : 0;
        EXPECT_NEAR(b.seam_deg, wanted, 1e-4) << b.object_a << ' ' << b.object_b;
    }
}

TEST(Borders, WhatSmoothKeepsIsNoSeam) {
    Scene scene = squares_with_normal({0.6f, 0, 0.8f});  // a hinge of 37 degrees, authored flat
    scene.meshes[1].positions = std::vector<vec3>{{0, 0, 0}, {0.8f, 0, -0.6f}, {0.8f, 1, -0.6f}, {0, 1, 0}};
    const Inspection kept = inspected_as_smooth_does(scene);
    EXPECT_NEAR(kept.borders[0].largest_deg, 36.8699, 1e-3);
    EXPECT_NEAR(kept.borders[0].after.max_deg, 36.8699, 1e-3);
    EXPECT_EQ(kept.seams.seam_deg, 0);
    EXPECT_NEAR(inspected(scene).seams.seam_deg, 36.8699, 1e-3) << "smoothed over the whole model";
    scene.meshes[1].normals = std::vector<vec3>(4, tilted(15));  // these bend towards the other square
    EXPECT_NEAR(inspected_as_smooth_does(scene).seams.seam_deg, 15, 1e-3);
}

TEST(Borders, AnEdgeSharperThanTheCreaseAngleIsNoSeam) {
    Scene scene = squares_with_normal({1, 0, 0});
    scene.meshes[1].positions = std::vector<vec3>{{0, 0, 0}, {0, 0, -1}, {0, 1, -1}, {0, 1, 0}};
    const Inspection i = inspected(scene);
    EXPECT_NEAR(i.borders[0].largest_deg, 90, 1e-4);
    EXPECT_NEAR(i.borders[0].after.max_deg, 90, 1e-4);
    EXPECT_EQ(i.borders[0].joined, 0u);
    EXPECT_EQ(i.borders[0].seam_deg, 0);
    EXPECT_EQ(i.seams.seam_deg, 0);
    EXPECT_NEAR(inspected(scene, {.crease_angle_rad = radians(91)}).borders[0].seam_deg, 90, 1e-4);
}

TEST(Borders, TheNearestTwoNormalsCountWhereAnObjectHasSeveral) {
    Scene scene = two_squares();
    Mesh& right = scene.meshes[1];
    std::vector<vec3> positions(right.positions.begin(), right.positions.end());
    positions.push_back(positions[0]);
    right.positions = positions;
    right.normals = std::vector<vec3>{{1, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    right.indices = std::vector<std::uint32_t>{0, 1, 2, 4, 2, 3};
    EXPECT_EQ(inspected(scene).borders[0].largest_deg, 0);
}

TEST(Borders, ASeamOnOneSideOfACreaseIsNotHiddenByTheOtherSide) {
    const dvec3 up{0, 0, 1}, side{1, 0, 0}, off = cast<double>(tilted(12));
    const std::vector<CornerNormals> a{{up, up}, {side, side}}, b{{off, up}, {side, side}};
    const PairAngle angle = pair_angle({0, a}, {1, b});
    EXPECT_TRUE(angle.joined);
    EXPECT_NEAR(angle.before_deg, 12, 1e-5);
    EXPECT_EQ(angle.after_deg, 0);
}

TEST(Borders, MeanAndPercentileAreOverThePositions) {
    Scene scene;  // two strips along x that share 101 positions; position i has a seam of i / 100 * 20 degrees
    for (int object = 0; object < 2; ++object) {
        std::vector<vec3> positions, normals;
        std::vector<std::uint32_t> indices;
        for (std::uint32_t i = 0; i <= 100; ++i) {
            positions.insert(positions.end(), {{float(i), 0, 0}, {float(i), object ? -1.0f : 1.0f, 0}});
            const vec3 n = object ? tilted(0.2 * i) : vec3{0, 0, 1};
            normals.insert(normals.end(), {n, n});
            if (i > 0) {
                std::uint32_t p = 2 * i - 2, q = 2 * i;
                if (object) std::swap(p, q);  // the strip below goes the other way round
                indices.insert(indices.end(), {p, q, p + 1, q, q + 1, p + 1});
            }
        }
        Mesh& mesh = scene.meshes.emplace_back();
        mesh.positions = positions, mesh.normals = normals, mesh.indices = indices;
        scene.nodes.emplace_back().meshes = {std::uint32_t(object)};
    }
    const BorderSummary b = inspected(scene).borders[0];
    EXPECT_EQ(b.positions, 101u);
    EXPECT_EQ(b.continuous, 1u);
    EXPECT_NEAR(b.before.max_deg, 20, 1e-4);
    EXPECT_NEAR(b.before.mean_deg, 10, 1e-4);
    EXPECT_NEAR(b.before.p95_deg, 19, 1e-4);  // the 96th of 101
    EXPECT_NEAR(b.median_deg, 10, 1e-4);
    EXPECT_EQ(b.seam_position.x, 100);
}

TEST(Borders, WhereTheFileHasNoNormalsThoseOfTheObjectCount) {
    Scene scene = two_squares();
    scene.meshes[1].positions = std::vector<vec3>{{0, 0, 0}, {0.8f, 0, 0.6f}, {0.8f, 1, 0.6f}, {0, 1, 0}};
    scene.meshes[1].normals = {};
    const Inspection i = inspected(scene);
    EXPECT_NEAR(i.borders[0].seam_deg, 36.8699, 1e-3);
    EXPECT_EQ(i.seams.normals_before, "the file's, smoothed per object where it has none (1 of 2 meshes)");
    EXPECT_EQ(inspected(scene, {.normals = NormalSource::model}).borders[0].seam_deg, 0);
    EXPECT_EQ(inspected(scene, {.normals = NormalSource::model}).seams.normals_before, "smoothed over the model");
    scene.meshes[0].normals = {};
    EXPECT_EQ(inspected(scene).seams.normals_before, "smoothed per object");
}

TEST(Borders, PositionsAreComparedInTheWorldAndMinusZeroIsZero) {
    Scene scene = two_squares();
    scene.meshes[0].positions = std::vector<vec3>{{-1, -0.0f, 0}, {-0.0f, -0.0f, -0.0f}, {-0.0f, 1, 0}, {-1, 1, 0}};
    EXPECT_EQ(inspected(scene).shared_positions, 2u);
    scene.nodes[1].local.translation = {1e-3, 0, 0};
    EXPECT_EQ(inspected(scene).shared_positions, 0u);
    EXPECT_TRUE(inspected(scene).borders.empty());
}

TEST(Borders, RoundingByDifferentMatricesIsForgivenAsTheAttributesDo) {
    Scene scene = two_squares();
    scene.nodes[1].local.translation = {1e-8, 0, 0};
    EXPECT_EQ(inspected(scene).shared_positions, 2u);
}

TEST(Borders, AWeldDistanceMakesOnePlaceOfWhatIsNear) {
    Scene scene = two_squares();
    scene.nodes[1].local.translation = {1e-3, 0, 0};
    Context context;
    EXPECT_EQ(inspect(scene, {.weld_distance = 2e-3}, context).shared_positions, 2u);
    EXPECT_EQ(inspect(scene, {.weld_distance = 2e-3}, context).surfaces[0].open_edges, 4u);
    EXPECT_EQ(inspect(scene, {.weld_distance = 0}, context).shared_positions, 0u);
    EXPECT_THROW(inspect(scene, {.weld_distance = std::numeric_limits<double>::infinity()}, context), Error);
}

TEST(Borders, VerticesThatNoTriangleUsesDoNotCount) {
    Scene scene = two_squares();
    scene.meshes[1].indices = std::vector<std::uint32_t>{1, 2, 2};
    EXPECT_EQ(inspected(scene).shared_positions, 0u);
}

TEST(Borders, NeedlesWhoseDirectionIsRoundingDoNotCount) {
    Scene scene = two_squares();
    for (const double height : {1e-7, 1e-3}) {
        Mesh& left = scene.meshes[0];
        left.positions = std::vector<vec3>{{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {0, 0.5f, float(height)},
                                           {0, 0, 0},  {0, 1, 0}};
        left.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3, 5, 4, 6};
        left.normals = std::vector<vec3>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}};
        const BorderSummary b = inspected(scene, {.crease_angle_rad = pi}).borders[0];
        EXPECT_EQ(b.largest_deg, 0) << height;
        Context context;
        const Surfaces surfaces = collect_surfaces(scene, std::vector<std::uint32_t>{0, 1}, NormalSource::automatic);
        const geometry::PlacedMeshes placed = geometry::place_vertices(surfaces.meshes, -1, context);
        const SeamNormals normals{normals_before(surfaces, InspectOptions{}, context),
                                  normals_after(surfaces, InspectOptions{}, context)};
        const std::vector<BorderCorner> corners = find_border_corners(placed, normals, context);
        EXPECT_EQ(std::count_if(corners.begin(), corners.end(), [](const BorderCorner& c) { return c.before >= 4; }),
                  height < 1e-5 ? 0 : 2);
    }
}

TEST(Borders, NumbersThatAreNotFiniteMeetNobody) {
    Scene scene = two_squares();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (Mesh& mesh : scene.meshes) mesh.positions = std::vector<vec3>(4, vec3{nan, 0, 0});
    EXPECT_EQ(inspected(scene).shared_positions, 0u);
}

TEST(Borders, NormalsThatAreZeroOrNotFiniteAreThoseMadeInTheirPlace) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const vec3 none : {vec3{nan, 0, 0}, vec3{0, 0, 0}}) {
        const Inspection i = inspected(squares_with_normal(none));
        EXPECT_EQ(i.shared_positions, 2u);
        EXPECT_EQ(i.seams.missing_normals, 4u);
        ASSERT_EQ(i.borders.size(), 1u);
        EXPECT_EQ(i.borders[0].largest_deg, 0) << "the squares lie in one plane";
    }
}

TEST(Borders, TwentyThousandObjectsOnOneSpotDoNotMakeTwoHundredMillionPairs) {
    Scene scene = two_squares();
    scene.nodes.resize(20'000);
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) scene.nodes[i].meshes = {i == 12'345 ? 1u : 0u};
    scene.meshes[1] = scene.meshes[0];
    scene.meshes[1].normals = std::vector<vec3>(4, tilted(33));
    const Inspection i = inspected(scene);
    EXPECT_EQ(i.shared_positions, 4u);
    EXPECT_LE(i.seams.pairs, 28u);
    EXPECT_EQ(i.seams.crowded_positions, 4u);
    EXPECT_EQ(i.seams.pairings_left_out, 4 * (20'000ull * 19'999 / 2 - 28));
    ASSERT_FALSE(i.borders.empty());  // the one that differs is among the few
    EXPECT_NEAR(i.borders[0].seam_deg, 33, 1e-4);
    EXPECT_TRUE(i.borders[0].object_a == 12'345 || i.borders[0].object_b == 12'345);
}

TEST(Borders, RandomModelsAgreeWithEveryVertexAgainstEveryVertex) {
    for (std::uint32_t seed = 0; seed < 30; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> value(-1, 1);
        const std::vector<test::Shape> parts = test::cut_at_random(test::make_torus(9, 7), 2 + random() % 6, seed);
        Scene scene;
        for (const test::Shape& part : parts) {
            Mesh& mesh = scene.meshes.emplace_back();
            std::vector<vec3> normals;  // outwards and a random bit of anything
            for (const vec3 p : part.positions)
                normals.push_back(normalize_or(p + vec3{value(random), value(random), value(random)}, vec3{1, 0, 0}));
            mesh.positions = part.positions, mesh.indices = part.indices, mesh.normals = normals;
            scene.nodes.emplace_back().meshes = {std::uint32_t(scene.meshes.size() - 1)};
        }
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<double>> expected;
        for (std::uint32_t a = 0; a < parts.size(); ++a)
            for (std::uint32_t b = a + 1; b < parts.size(); ++b) {
                std::map<std::array<float, 3>, double> nearest;  // at each position
                for (std::size_t i = 0; i < parts[a].positions.size(); ++i)
                    for (std::size_t k = 0; k < parts[b].positions.size(); ++k) {
                        const vec3 p = parts[a].positions[i];
                        if (!(p == parts[b].positions[k])) continue;
                        double& angle = nearest.try_emplace({p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}, 360).first->second;
                        angle = std::min(angle, degrees(test::angle_between(scene.meshes[a].normals[i],
                                                                            scene.meshes[b].normals[k])));
                    }
                for (const auto& [position, angle] : nearest) expected[{a, b}].push_back(angle);
            }
        const Inspection i = inspected(scene, {.crease_angle_rad = pi});
        ASSERT_EQ(i.borders.size(), expected.size()) << seed;
        for (const BorderSummary& border : i.borders) {
            std::vector<double> angles = expected[{border.object_a, border.object_b}];
            std::sort(angles.begin(), angles.end());
            ASSERT_EQ(border.positions, angles.size()) << seed;
            EXPECT_EQ(border.joined, angles.size()) << seed;
            EXPECT_NEAR(border.before.max_deg, angles.back(), 1e-4);
            EXPECT_NEAR(border.seam_deg, angles.back(), 1e-4);
            EXPECT_NEAR(border.before.mean_deg,
                        std::accumulate(angles.begin(), angles.end(), 0.0) / double(angles.size()), 1e-4);
            EXPECT_NEAR(border.before.p95_deg, angles[std::size_t(std::ceil(0.95 * double(angles.size()))) - 1], 1e-4);
            EXPECT_LT(border.after.max_deg, continuous_deg);
        }
    }
}

TEST(Borders, InstancesThatAskForTooMuchMemoryAreAnError) {
    Scene scene = two_squares();
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < 10'000; ++i) indices.insert(indices.end(), {0, 1, 2});
    scene.meshes[0].indices = indices;
    scene.nodes.assign(20'000, scene.nodes[0]);  // 600 million corners
    Context context;
    EXPECT_THROW(inspect(scene, {}, context), Error);
    EXPECT_EQ(inspect(scene, {.borders = false, .surfaces = false}, context).triangles, 200'000'000u);
}

TEST(Borders, TheTableHoldsTheTenThousandWorstPairs) {
    Scene scene;  // a chain of triangles that touch in single points; the seam grows along it
    constexpr std::uint32_t count = 10'102;
    for (std::uint32_t i = 0; i < count; ++i) {
        const float x = float(i);
        Mesh& mesh = scene.meshes.emplace_back();
        mesh.positions = std::vector<vec3>{{x, 0, 0}, {x + 1, 0, 0}, {x + 0.5f, 1, 0}};
        mesh.indices = std::vector<std::uint32_t>{0, 1, 2};
        mesh.normals = std::vector<vec3>(3, tilted(i % 2 ? 0 : 40.0 * i / count));
        scene.nodes.emplace_back().meshes = {i};
    }
    const Inspection i = inspected(scene, {.crease_angle_rad = pi}, true);
    EXPECT_EQ(i.seams.pairs, count - 1);
    EXPECT_EQ(i.borders.size(), 10'000u);
    EXPECT_EQ(i.borders_left_out, count - 1 - 10'000);
    EXPECT_NEAR(i.borders.front().seam_deg, i.seams.seam_deg, 1e-9);
    EXPECT_GE(i.borders.back().object_a, 100u);
    for (std::size_t k = 1; k < i.borders.size(); ++k) EXPECT_GE(i.borders[k - 1].seam_deg, i.borders[k].seam_deg);
    ASSERT_FALSE(i.seam_lines.empty());  // points: the triangles share no edge
    EXPECT_EQ(i.seam_lines[0].a, i.seam_lines[0].b);
}

TEST(Borders, SeamLinesAreTheEdgesOfTheBorder) {
    const Inspection i = inspected(squares_with_normal({0.6f, 0, 0.8f}), {}, true);
    ASSERT_EQ(i.seam_lines.size(), 1u);
    EXPECT_EQ(i.seam_lines[0].a.x, 0);
    EXPECT_EQ(std::fabs(i.seam_lines[0].a.y - i.seam_lines[0].b.y), 1);
    EXPECT_NEAR(i.seam_lines[0].deg_a, 36.8699, 1e-3);
    EXPECT_TRUE(inspected(two_squares(), {}, true).seam_lines.empty());
    EXPECT_TRUE(inspected(squares_with_normal({0.6f, 0, 0.8f})).seam_lines.empty());
}

TEST(Borders, AnObjectAloneHasNone) {
    Scene scene = two_squares();
    scene.nodes.resize(1);
    EXPECT_EQ(inspected(scene).shared_positions, 0u);
    EXPECT_EQ(inspected(Scene{}).shared_positions, 0u);
}

TEST(Borders, TheCrowdIsRepresentedByThoseThatDifferMostAndTheNearestToTheMean) {
    std::vector<CornerNormals> normals;
    for (int i = 0; i < 100; ++i) {
        const dvec3 n = cast<double>(tilted(i < 3 ? 50 + i : 0));
        normals.push_back({n, n});
    }
    std::vector<PartAtPlace> parts;
    for (std::uint32_t i = 0; i < 100; ++i) parts.push_back({i, std::span(normals).subspan(i, 1)});
    const std::vector<PartAtPlace> few = most_different(parts, 4);
    ASSERT_EQ(few.size(), 4u);
    for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(few[i].part, i);
    EXPECT_EQ(most_different(parts, 100).size(), 100u);
}

}  // namespace
}  // namespace rakelight
