// SPDX-License-Identifier: Apache-2.0
#include "scene/drawn_vertices.h"

#include <rakelight/scene/scene_queries.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "math/linear.h"
#include "scene/placement.h"

namespace rakelight {
namespace {

constexpr std::size_t ways = 6;
using Reach = std::array<double, ways>;

/// The definition: a walk over all vertices that some triangle uses.
Reach walked(const Scene& scene, dvec3 about, const std::array<dvec3, ways>& directions, Bounds& bounds) {
    Reach reach;
    reach.fill(-HUGE_VAL);
    const std::vector<dmat4> world = world_matrices(scene);
    for (std::size_t i = 0; i < scene.nodes.size(); ++i)
        for (const std::uint32_t number : scene.nodes[i].meshes) {
            const Mesh& mesh = scene.meshes[number];
            const dmat4 m = world[i] * translation(mesh.origin);
            for (const std::uint32_t v : mesh.indices) {
                const dvec3 local = cast<double>(mesh.positions[v]), p = transform_point(m, local);
                if (is_finite(p)) bounds.low = min(bounds.low, p), bounds.high = max(bounds.high, p);
                for (std::size_t k = 0; k < ways; ++k) {
                    const dvec3 d = directions[k];
                    const dvec3 own{dot(m[0].xyz(), d), dot(m[1].xyz(), d), dot(m[2].xyz(), d)};
                    const double along = dot(local, own) + dot(m[3].xyz() - about, d);
                    if (std::isfinite(along)) reach[k] = std::max(reach[k], along);
                }
            }
        }
    for (double& r : reach)
        if (r == -HUGE_VAL) r = 0;
    return reach;
}

/// Objects of `vertices` each, some placed twice, some not at all, some mirrored; a third of the vertices is unused.
Scene random_scene(std::mt19937& random, std::size_t vertices, float size) {
    std::uniform_real_distribution<float> place(-size, size);
    std::uniform_int_distribution<std::uint32_t> index(0, std::uint32_t(vertices) - 1);
    Scene scene;
    for (int k = 0; k < 4; ++k) {
        Mesh mesh;
        std::vector<vec3> positions(vertices);
        for (vec3& p : positions) p = {place(random), place(random), place(random)};
        std::vector<std::uint32_t> indices(vertices / 3 * 3 + 3);
        for (std::uint32_t& i : indices) i = index(random);
        mesh.origin = {1e5 * k, 0, -3.0 * k};
        mesh.positions = std::move(positions), mesh.indices = std::move(indices);
        scene.meshes.push_back(std::move(mesh));
    }
    const auto number = [&] { return double(place(random) / size); };
    for (const std::vector<std::uint32_t>& meshes : {std::vector<std::uint32_t>{0}, {1, 0}, {}, {2}}) {
        Node node;
        node.meshes = meshes;
        node.local.translation = {100 * number(), 100 * number(), 100 * number()};
        node.local.scale = {3 * number(), 3 * number(), 3 * number()};
        scene.nodes.push_back(node);
    }
    return scene;
}

void expect_as_walked(const Scene& scene, dvec3 about, const std::array<dvec3, ways>& directions) {
    const DrawnVertices drawn(scene);
    Reach reach{};
    drawn.farthest_along(about, directions, reach);
    Bounds bounds;
    EXPECT_EQ(reach, walked(scene, about, directions, bounds));
    EXPECT_EQ(drawn.bounds().low, bounds.low);
    EXPECT_EQ(drawn.bounds().high, bounds.high);
}

std::array<dvec3, ways> random_directions(std::mt19937& random, double length) {
    std::uniform_real_distribution<double> number(-length, length);
    std::array<dvec3, ways> directions;
    for (dvec3& d : directions) d = {number(random), number(random), number(random)};
    directions[4] = {0, length, 0}, directions[5] = {-length, 0, 0};
    return directions;
}

TEST(DrawnVertices, AreThoseOfAWalkOverAllToTheBit) {
    std::mt19937 random(7);
    for (const std::size_t vertices : {1, 3, 63, 64, 65, 1000, 9000})
        for (const float size : {1e-30f, 1.0f, 3e38f})
            for (const double length : {1e-3, 1.0, 1e290}) {
                SCOPED_TRACE(testing::Message() << vertices << " vertices in " << size << ", directions of " << length);
                expect_as_walked(random_scene(random, vertices, size), {5, -2, 1e3}, random_directions(random, length));
            }
}

TEST(DrawnVertices, AreThoseOfAWalkWhereThePlacesAreNotFinite) {
    std::mt19937 random(8);
    constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    Scene scene = random_scene(random, 300, 1);
    for (Mesh& mesh : scene.meshes) {
        std::vector<vec3> positions(mesh.positions.begin(), mesh.positions.end());
        for (std::size_t v = 0; v < positions.size(); v += 3) positions[v] = {v % 2 ? inf : 1, -inf, v % 5 ? nan : 0};
        mesh.positions = std::move(positions);
    }
    scene.nodes[1].local.scale = {1e308, 1, 1};  // some overflow, some do not
    expect_as_walked(scene, {0, 0, 0}, random_directions(random, 20));
    scene.nodes[1].local.scale = {0, 0, 0};
    expect_as_walked(scene, {0, 0, 0}, random_directions(random, 20));
}

TEST(DrawnVertices, OfNothingReachNowhere) {
    Reach reach{1, 2, 3, 4, 5, 6};
    DrawnVertices(Scene{}).farthest_along({}, std::array<dvec3, ways>{}, reach);
    EXPECT_EQ(reach, Reach{});
}

}  // namespace
}  // namespace rakelight
