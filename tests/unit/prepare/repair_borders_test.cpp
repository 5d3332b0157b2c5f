// SPDX-License-Identifier: Apache-2.0
// Normals made to agree along borders without shared vertices: what turns along, what stays shared, which meshes take part.
#include "prepare/normals/repair_borders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <rakelight/base/error.h>
#include <rakelight/prepare/prepare.h>

#include "near_borders.h"

namespace rakelight {
namespace {

using namespace near_borders;

Scene repaired(const Scene& scene, double distance, MatchReport* borders = nullptr) {
    Context context({.threads = 2});
    return repair_borders(scene, {.distance = distance}, context, borders);
}

float apart(vec3 a, vec3 b) { return length(a - b); }

bool says(Context& context, Remark kind, const std::string& words) {
    for (const ReportEntry& entry : context.report().entries())
        if (entry.remark == kind && entry.message.find(words) != std::string::npos) return true;
    return false;
}

TEST(RepairBorders, NormalsAgreeTangentsTurnAllElseKeepsItsBits) {
    const Scene before = two_squares();
    MatchReport borders;
    const Scene after = repaired(before, 0.02, &borders);
    EXPECT_EQ(borders.leading, 2u);
    EXPECT_EQ(borders.following, 3u);
    EXPECT_EQ(borders.turned, 5u);
    EXPECT_GT(borders.max_deg, borders.mean_deg * 0.999);
    for (std::size_t m = 0; m < 2; ++m) {
        const Mesh &a = before.meshes[m], &b = after.meshes[m];
        EXPECT_EQ(a.positions, b.positions) << "shared";
        EXPECT_EQ(a.indices, b.indices);
        for (std::size_t v = 0; v < a.positions.size(); ++v) {
            const bool at_border = std::fabs(a.positions[v].x - 1) < 0.1f;
            EXPECT_EQ(a.normals[v] == b.normals[v], !at_border);
            EXPECT_EQ(a.tangents[v] == b.tangents[v], !at_border);
            EXPECT_NEAR(dot(b.normals[v], b.tangents[v].xyz()), 0, 1e-6);
            EXPECT_EQ(b.tangents[v].w, -1);
        }
    }
    const Mesh &left = after.meshes[0], &right = after.meshes[1];
    EXPECT_EQ(left.normals[3], right.normals[0]);
    EXPECT_EQ(left.normals[2], right.normals[2]);
    EXPECT_LT(apart(right.normals[1], normalize_or(left.normals[2] + left.normals[3], vec3{})), 1e-6f);
    EXPECT_LT(apart(left.tangents[3].xyz(), right.tangents[0].xyz()), 1e-6f);
}

TEST(RepairBorders, WithoutAnythingNearTheArraysAreTheSame) {
    const Scene scene = two_squares();
    MatchReport borders;
    const Scene after = repaired(scene, 0.005, &borders);
    EXPECT_EQ(borders, MatchReport{});
    for (std::size_t m = 0; m < 2; ++m) EXPECT_TRUE(after.meshes[m] == scene.meshes[m]);
}

TEST(RepairBorders, MorphTargetsTurnAlong) {
    Scene scene = two_squares();
    MorphTarget target;
    target.normals = std::vector<vec3>(4, vec3{0, 0, 0.5f});
    target.positions = std::vector<vec3>(4, vec3{0, 0.1f, 0});
    scene.meshes[0].targets = {target};
    const Scene after = repaired(scene, 0.02);
    const MorphTarget& turned = after.meshes[0].targets[0];
    EXPECT_EQ(turned.positions, target.positions);
    EXPECT_EQ(turned.normals[0], target.normals[0]) << "away from the border";
    EXPECT_NEAR(turned.normals[2].z, 0.5, 1e-6) << "along the axis of the turn";
}

TEST(RepairBorders, InstancesWithOtherNeighborsGetAMeshOfTheirOwn) {
    Scene scene = two_squares();
    scene.nodes.push_back(at(0, translation(dvec3{0, 9, 0})));
    const Scene after = repaired(scene, 0.02);
    ASSERT_EQ(after.meshes.size(), 3u);
    EXPECT_EQ(after.nodes[0].meshes[0], 0u);
    EXPECT_EQ(after.meshes[after.nodes[2].meshes[0]].normals[2], scene.meshes[0].normals[2]);
    Context context;
    EXPECT_EQ(repair_borders(scene, {.distance = 0.02}, context, nullptr, true).meshes.size(), 2u) << "kept shared";
}

TEST(RepairBorders, MeshesOfOneArrayOfVerticesGoOnSharingIt) {
    const Scene apart_scene = two_squares();
    const Mesh &a = apart_scene.meshes[0], &b = apart_scene.meshes[1];
    const auto both = [](const auto& x, const auto& y) {
        std::vector values(x.begin(), x.end());
        values.insert(values.end(), y.begin(), y.end());
        return values;
    };
    Mesh left, right;
    left.positions = both(a.positions, b.positions), left.normals = both(a.normals, b.normals);
    left.tangents = both(a.tangents, b.tangents), left.indices = a.indices;
    right = left;
    std::vector<std::uint32_t> indices;
    for (const std::uint32_t v : b.indices) indices.push_back(v + 4);
    right.indices = std::move(indices);
    Scene scene = apart_scene;
    scene.meshes = {left, right};
    const Scene after = repaired(scene, 0.02), expected = repaired(apart_scene, 0.02);
    EXPECT_EQ(after.meshes[0].normals.identity(), after.meshes[1].normals.identity());
    EXPECT_EQ(after.meshes[0].tangents.identity(), after.meshes[1].tangents.identity());
    for (std::size_t v = 0; v < 4; ++v) EXPECT_EQ(after.meshes[0].normals[v], expected.meshes[0].normals[v]);
    for (std::size_t v = 0; v < 5; ++v) {
        EXPECT_EQ(after.meshes[0].normals[4 + v], expected.meshes[1].normals[v]);
        EXPECT_EQ(after.meshes[0].tangents[4 + v], expected.meshes[1].tangents[v]);
    }
}

TEST(RepairBorders, OutOfRangeIsRefused) {
    Context context;
    for (const double distance : {-1.0, 0.0, std::numeric_limits<double>::infinity(), std::nan("")})
        EXPECT_THROW(repair_borders(two_squares(), {.distance = distance}, context), Error) << distance;
    for (const double distance : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")})
        EXPECT_THROW(prepare_scene(two_squares(), {.border_distance = distance}, context), Error) << distance;
}

/// What preparing makes of the middle of the second square's border.
vec3 middle(const Scene& scene, const PrepareOptions& options, Context& context) {
    const Scene after = prepare_scene(scene, options, context);
    return after.meshes[after.nodes[1].meshes[0]].normals[1];
}

TEST(PrepareBorders, TheFilesNormalsAreJoinedUnlessTheyAreAskedFor) {
    const Scene scene = two_squares();
    const vec3 own = scene.meshes[1].normals[1];
    Context context;
    EXPECT_EQ(middle(scene, {}, context), own) << "off by default";
    EXPECT_TRUE(context.report().entries().empty());
    EXPECT_NE(middle(scene, {.border_distance = 0.02}, context), own);
    EXPECT_TRUE(says(context, Remark::note, "3 border vertices follow 2 leading ones; 5 normals turn"));
    EXPECT_NE(middle(scene, {.normals = NormalSource::seams, .border_distance = 0.02}, context), own);
    Context of_file, of_none;
    EXPECT_EQ(middle(scene, {.normals = NormalSource::file, .border_distance = 0.02}, of_file), own);
    EXPECT_TRUE(says(of_file, Remark::warning, "'normals' file keeps"));
    EXPECT_EQ(middle(scene, {.border_distance = 0.005}, of_none), own);
    EXPECT_TRUE(says(of_none, Remark::warning, "'border-distance' 0.005 turns nothing"));
}

/// A seam of the two halves, in the middle of the first edge at the top of their tube.
double seam_of(const Scene& scene) {
    const Mesh &left = scene.meshes[scene.nodes[0].meshes[0]], &right = scene.meshes[scene.nodes[1].meshes[0]];
    const vec3 between = normalize_or(left.normals[0] + left.normals[9], vec3{});
    return degrees(2 * std::asin(0.5 * double(apart(between, right.normals[9 + 8]))));
}

TEST(PrepareBorders, MadeNormalsMatchWithinTheirScope) {
    Context context;
    const Scene halves = two_halves(4, 0.01);
    const auto seam = [&](const PrepareOptions& options, const Scene& scene) {
        return seam_of(prepare_scene(scene, options, context));
    };
    EXPECT_NEAR(seam({.normals = NormalSource::model}, halves), 22.5, 0.1);
    EXPECT_LT(seam({.normals = NormalSource::model, .border_distance = 0.02}, halves), 0.01);
    EXPECT_LT(seam({.border_distance = 0.02}, halves), 0.01) << "made, since there are none";
    EXPECT_NEAR(seam({.normals = NormalSource::object, .border_distance = 0.02}, halves), 22.5, 0.1);
    Scene one = halves;  // one object of two meshes
    one.nodes[0].meshes = {0, 1};
    one.meshes[1].origin = {0.01, 0, 0};
    one.nodes[1].meshes = {1};
    one.nodes[1].local.matrix = translation(dvec3{0, 99, 0});
    const Scene after = prepare_scene(one, {.normals = NormalSource::object, .border_distance = 0.02}, context);
    EXPECT_LT(
        apart(after.meshes[after.nodes[0].meshes[0]].normals[0], after.meshes[after.nodes[0].meshes[1]].normals[8]),
        1e-5f);
    Context of_flat;
    prepare_scene(halves, {.normals = NormalSource::flat, .border_distance = 0.02}, of_flat);
    EXPECT_TRUE(says(of_flat, Remark::warning, "faces are flat here"));
}

TEST(PrepareBorders, PartsThatAskForOtherScopesStayOut) {
    Context context;
    Scene scene = two_halves(4, 0.01);
    scene.meshes[0].normal_choice = NormalChoice{.source = NormalSource::model};
    scene.meshes[1].normal_choice = NormalChoice{.source = NormalSource::object};
    EXPECT_NEAR(seam_of(prepare_scene(scene, {.border_distance = 0.02}, context)), 22.5, 0.1);
    scene.meshes[1].normal_choice->source = NormalSource::seams;
    EXPECT_LT(seam_of(prepare_scene(scene, {.border_distance = 0.02}, context)), 0.01);
}

TEST(PrepareBorders, TheSameBitsForAnyNumberOfThreads) {
    const Scene halves = two_halves(40, 0.01);
    const auto prepared = [&](int threads) {
        Context context({.threads = threads});
        return prepare_scene(halves, {.normals = NormalSource::model, .border_distance = 0.02}, context);
    };
    const Scene a = prepared(1), b = prepared(2);
    for (std::size_t m = 0; m < 2; ++m)
        EXPECT_TRUE(std::equal(a.meshes[m].normals.begin(), a.meshes[m].normals.end(), b.meshes[m].normals.begin(),
                               b.meshes[m].normals.end()));
}

}  // namespace
}  // namespace rakelight
