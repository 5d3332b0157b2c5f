// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/linear.h"
#include "scene/near_surfaces.h"

namespace rakelight {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// One mesh at one node.
Scene scene_of(Topology topology, std::vector<vec3> positions, std::vector<std::uint32_t> indices, dmat4 place = {}) {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.topology = topology;
    mesh.positions = std::move(positions);
    mesh.indices = std::move(indices);
    Node& node = scene.nodes.emplace_back();
    node.meshes = {0};
    node.local.matrix = place;
    return scene;
}

/// From the origin along -Z, 90 degrees wide and high.
double nearest(const Scene& scene, double limit = 1000) { return NearSurfaces(scene).nearest({}, {1, 1}, limit); }

TEST(NearSurfaces, OnlyWhatLiesInThePictureCounts) {
    const std::vector<std::uint32_t> one{0, 1, 2};
    EXPECT_NEAR(nearest(scene_of(Topology::triangles, {{-1, 0, -5}, {1, 0, -5}, {0, 1, -5}}, one)), 5, 1e-12);
    // A floor 2 m below the eye comes into the picture at a distance of 2 m, though it passes beneath.
    EXPECT_NEAR(nearest(scene_of(Topology::triangles, {{-900, -2, 900}, {900, -2, 900}, {0, -2, -900}}, one)), 2, 1e-9);
    EXPECT_EQ(nearest(scene_of(Topology::triangles, {{-1, 0, 5}, {1, 0, 5}, {0, 1, 5}}, one)), 1000) << "behind";
    EXPECT_EQ(nearest(scene_of(Topology::triangles, {{50, 0, -5}, {51, 0, -5}, {50, 1, -5}}, one)), 1000) << "beside";
    EXPECT_EQ(nearest(scene_of(Topology::triangles, {{-1, 0, -5}, {1, 0, -5}, {0, 1, -5}}, one), 4), 4);
    EXPECT_NEAR(nearest(scene_of(Topology::triangles, {{0, 0, -3}, {0, 0, -3}, {0, 0, -3}}, one)), 3, 1e-12)
        << "no area";
    EXPECT_EQ(nearest(scene_of(Topology::triangles, {{nan, 0, -5}, {1, 0, -5}, {0, 1, -5}}, one)), 1000);
    EXPECT_EQ(nearest(Scene{}), 1000);
}

TEST(NearSurfaces, LinesAndPointsCountToo) {
    EXPECT_NEAR(nearest(scene_of(Topology::points, {{0, 0, -7}, {9, 0, -2}, {0, 0, 1}}, {0, 1, 2})), 7, 1e-12);
    EXPECT_NEAR(nearest(scene_of(Topology::lines, {{-3, 0, -1}, {3, 0, -1}, {0, 0, -9}, {0, 0, -8}}, {0, 1, 2, 3})), 1,
                1e-9);
}

TEST(NearSurfaces, PlacesScalesAndOriginsAreThoseOfTheWorld) {
    Scene scene =
        scene_of(Topology::points, {{0, 0, -1}}, {0}, translation(dvec3{0, 0, -10}) * scaling(dvec3{2, 2, 2}));
    EXPECT_NEAR(nearest(scene), 12, 1e-12);
    scene.meshes[0].origin = {0, 0, -1e6};
    EXPECT_NEAR(nearest(scene, 1e9), 12 + 2e6, 1e-6);
}

/// A sphere of many triangles about the eye, and one grain before it: found by runs as by a walk over all.
TEST(NearSurfaces, AGrainAmongManyTrianglesIsFound) {
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    const auto add = [&](vec3 p, float size) {
        for (const vec3 by : {vec3{0, 0, 0}, vec3{size, 0, 0}, vec3{0, size, 0}}) {
            indices.push_back(std::uint32_t(positions.size()));
            positions.push_back(p + by);
        }
    };
    double expected = 1e300;
    for (int i = 0; i < 5000; ++i) {
        const double z = 1 - 2 * (i + 0.5) / 5000, r = std::sqrt(1 - z * z), a = 2.399963 * i;
        const dvec3 at{80 * r * std::cos(a), 80 * r * std::sin(a), 80 * z};
        add(cast<float>(at), 0.001f);
        if (-at.z > 0 && std::fabs(at.x) < -at.z && std::fabs(at.y) < -at.z) expected = std::min(expected, -at.z);
    }
    const Scene shell = scene_of(Topology::triangles, positions, indices);
    EXPECT_NEAR(nearest(shell), expected, 0.01);
    add({0.01f, 0, -0.05f}, 0.001f);
    EXPECT_NEAR(nearest(scene_of(Topology::triangles, positions, indices)), double(0.05f), 1e-9);
}

}  // namespace
}  // namespace rakelight
