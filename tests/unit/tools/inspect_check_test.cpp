// SPDX-License-Identifier: Apache-2.0
#include <rakelight/tools/inspect.h>
#include <rakelight/tools/rows.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

#include "unit/render/test_scene.h"

namespace rakelight {
namespace {

using test::two_squares;

Inspection inspected(const Scene& scene) {
    Context context;
    return inspect(scene, {}, context);
}

/// All limits.
constexpr CheckLimits strict{.no_degenerate = true,
                             .no_t_junctions = true,
                             .no_non_manifold = true,
                             .consistent_winding = true,
                             .closed = true,
                             .unit_normals = true};

std::vector<std::string> limits_passed(const Scene& scene, const CheckLimits& limits) {
    std::vector<std::string> names;
    for (const CheckFailure& f : check_limits(inspected(scene), limits)) {
        EXPECT_EQ(f.message.find('\n'), std::string::npos);
        names.push_back(f.limit);
    }
    return names;
}

/// A closed tetrahedron.
Scene tetrahedron() {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.indices = std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    scene.nodes.emplace_back().meshes = {0};
    return scene;
}

using Names = std::vector<std::string>;

TEST(InspectCheck, AnObjectOfTrianglesThatArePointsIsNotClosed) {
    Scene scene = tetrahedron();
    EXPECT_EQ(limits_passed(scene, {.closed = true}), Names{});
    scene.meshes[0].indices = std::vector<std::uint32_t>{0, 0, 0, 1, 1, 2};
    EXPECT_EQ(limits_passed(scene, {.closed = true}), Names{"closed"});
    scene.meshes[0].indices = std::vector<std::uint32_t>{};  // nothing is open where there is no triangle
    EXPECT_EQ(limits_passed(scene, {.closed = true}), Names{});
}

TEST(InspectCheck, ACleanClosedModelPassesEverything) {
    EXPECT_EQ(limits_passed(tetrahedron(), strict), Names{});
    EXPECT_EQ(limits_passed(Scene{}, strict), Names{});
}

TEST(InspectCheck, ASeamIsNamedWithItsPairAndItsAngle) {
    Scene scene = two_squares();
    scene.meshes[1].normals = std::vector<vec3>(4, vec3{0.6f, 0, 0.8f});
    const auto failures = check_limits(inspected(scene), {});
    ASSERT_EQ(failures.size(), 1u);
    EXPECT_EQ(failures[0].limit, "max-seam");
    EXPECT_NE(failures[0].message.find("36.87 degrees between 'left' and 'right'"), std::string::npos)
        << failures[0].message;
    EXPECT_TRUE(check_limits(inspected(scene), {.max_seam_deg = 40}).empty());
    EXPECT_TRUE(check_limits(inspected(scene), {.max_seam_deg = std::nullopt}).empty());
    scene.nodes[0].name.clear();
    EXPECT_NE(check_limits(inspected(scene), {})[0].message.find("between node 0 and 'right'"), std::string::npos);
}

TEST(InspectCheck, EachFaultPassesItsOwnLimit) {
    EXPECT_EQ(limits_passed(two_squares(), strict), Names{"closed"});

    Scene scene = tetrahedron();
    scene.meshes[0].indices = std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 0, 1};
    EXPECT_EQ(limits_passed(scene, strict), Names{"no-degenerate"});

    scene = tetrahedron();
    scene.meshes[0].indices = std::vector<std::uint32_t>{0, 1, 2, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    EXPECT_EQ(limits_passed(scene, strict), Names{"consistent-winding"});

    scene = tetrahedron();
    scene.meshes[0].positions = std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, -1, 0}};
    scene.meshes[0].indices = std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3, 0, 3, 4};
    EXPECT_EQ(limits_passed(scene, strict), (Names{"no-non-manifold", "closed"}));

    scene = tetrahedron();
    scene.meshes[0].normals = std::vector<vec3>{{0, 0, 1}, {0, 0, 0}, {0, 3, 0}, {NAN, 0, 0}};
    EXPECT_EQ(limits_passed(scene, strict), Names{"unit-normals"});
    EXPECT_NE(check_limits(inspected(scene), strict)[0].message.find("3 zero"), std::string::npos);

    scene = two_squares();
    scene.meshes[0].positions = std::vector<vec3>{{-1, 0, 0}, {0, 0.5f, 0}, {0, 1, 0}, {-1, 1, 0}};
    EXPECT_EQ(limits_passed(scene, {.no_t_junctions = true}), Names{"no-t-junctions"});
    EXPECT_NE(check_limits(inspected(scene), {.no_t_junctions = true})[0].message.find("0 0.5 0"), std::string::npos);
}

TEST(InspectCheck, AnObjectInsideOutIsInconsistentWithItsNeighbor) {
    Scene scene = two_squares();
    scene.meshes[1].indices = std::vector<std::uint32_t>{0, 2, 1, 0, 3, 2};
    EXPECT_EQ(limits_passed(scene, {.consistent_winding = true}), Names{"consistent-winding"});
    EXPECT_EQ(inspected(scene).seams.inconsistent_edges, 1u);
    const Inspection i = inspected(scene);
    ASSERT_EQ(i.borders.size(), 1u);
    EXPECT_EQ(i.borders[0].inconsistent_edges, 1u);
    EXPECT_NE(
        check_limits(i, {.consistent_winding = true})[0].message.find(
            "edges of inconsistent winding: 1 between '" + i.objects[0].name + "' and '" + i.objects[1].name + "'"),
        std::string::npos)
        << check_limits(i, {.consistent_winding = true})[0].message;
    Context context;
    EXPECT_EQ(check_limits(inspect(scene, {.borders = false}, context), {.consistent_winding = true}).size(), 1u);
}

TEST(InspectCheck, TheReportCountsTheFaultsOfEachObject) {
    Scene scene = two_squares();
    scene.meshes[1].normals = std::vector<vec3>{{0, 0, 1}, {0, 0, 0}, {0, 0, 1}, {0, 0, 1}};
    scene.meshes[1].texcoords = {std::vector<vec2>{{0, 0}, {1, 0}, {0, 0}, {0, 1}}};
    const Inspection i = inspected(scene);
    ASSERT_EQ(i.surfaces.size(), 2u);
    EXPECT_EQ(i.surfaces[0].edges, 5u);
    EXPECT_EQ(i.surfaces[0].open_edges, 4u);
    EXPECT_FALSE(i.surfaces[0].closed);
    EXPECT_EQ(i.surfaces[0].zero_normals, 0u);
    EXPECT_EQ(i.surfaces[1].zero_normals, 1u);
    std::vector<InspectionRow> rows(1);
    rows[0].inspection = i;
    rows[0].check = check_limits(i, strict);
    const auto json = nlohmann::json::parse(to_json(rows))["rows"][0];
    EXPECT_EQ(json["objects"][1]["surface"]["zero_normals"], 1);
    EXPECT_EQ(json["check"]["passed"], false);
    EXPECT_EQ(json["check"]["failures"][0]["limit"], "closed");
    EXPECT_EQ(json["seams"]["positions"], 2);
    EXPECT_EQ(json["t_junctions"]["count"], 0);
}

}  // namespace
}  // namespace rakelight
