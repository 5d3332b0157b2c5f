// SPDX-License-Identifier: Apache-2.0
#include "bake/low/charts.h"

#include <gtest/gtest.h>

#include <random>

#include "bake/low/make_coordinates.h"
#include "bake/low/shelf_packing.h"
#include "bake/padding.h"
#include "support/thrown_error.h"
#include "unit/bake/bake_scenes.h"

namespace rakelight::bake {
namespace {

using namespace test;

/// A cube of side 2 about the origin; corners are shared.
Mesh cube() {
    Mesh mesh;
    std::vector<vec3> positions;
    for (int i = 0; i < 8; ++i) positions.push_back({i & 1 ? 1.f : -1.f, i & 2 ? 1.f : -1.f, i & 4 ? 1.f : -1.f});
    mesh.positions = std::move(positions);
    mesh.indices = std::vector<std::uint32_t>{0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                              2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
    return mesh;
}

TEST(Charts, ACubeHasOneForEachFaceAndAnEmptyListNone) {
    Context context({.threads = 1});
    const Mesh mesh = cube();
    std::vector<dvec3> places;
    for (const vec3 p : mesh.positions) places.push_back(cast<double>(p));
    const Charts charts = find_charts(places, mesh.indices, context);
    EXPECT_EQ(charts.axis, (std::vector<std::uint8_t>{1, 0, 3, 2, 5, 4}));
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(charts.high[i] - charts.low[i], (dvec2{2, 2}));
    EXPECT_TRUE(find_charts({}, {}, context).axis.empty());
}

TEST(Charts, FacesThatLookAlongOneAxisButTouchNowhereAreTwo) {
    Context context({.threads = 1});
    const std::vector<dvec3> places{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}};
    const std::vector<std::uint32_t> triangles{0, 1, 2, 3, 4, 5};
    EXPECT_EQ(find_charts(places, triangles, context).of_triangle, (std::vector<std::uint32_t>{0, 1}));
}

TEST(Charts, FlattenedOutsideIsNotMirrored) {
    const dvec3 right[6] = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
    const dvec3 out[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (std::uint8_t axis = 0; axis < 6; ++axis) {
        EXPECT_EQ(flattened(right[axis], axis), (dvec2{1, 0})) << int(axis);
        EXPECT_EQ(flattened(cross(out[axis], right[axis]), axis), (dvec2{0, -1})) << int(axis);  // up: v is down
    }
}

TEST(ShelfPacking, RectanglesKeepTheirMarginAndStayOnTheMap) {
    Context context({.threads = 1});
    std::mt19937 random(7);
    std::uniform_real_distribution<double> side(0, 3);
    std::vector<dvec2> sizes;
    for (int i = 0; i < 200; ++i) sizes.push_back({side(random), side(random)});
    const auto packing = pack_shelves(sizes, 512, 300, 3, context);
    ASSERT_TRUE(packing);
    const auto far = [&](std::size_t i) {
        return packing->place[i] + dvec2{std::max(1.0, std::ceil(sizes[i].x * packing->scale)),
                                         std::max(1.0, std::ceil(sizes[i].y * packing->scale))};
    };
    double area = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const dvec2 low = packing->place[i], high = far(i);
        EXPECT_TRUE(low.x >= 3 && low.y >= 3 && high.x <= 512 - 3 && high.y <= 300 - 3);
        area += (high.x - low.x) * (high.y - low.y);
        for (std::size_t k = 0; k < i; ++k) {
            const dvec2 a = packing->place[k], b = far(k);
            EXPECT_TRUE(low.x >= b.x + 3 || a.x >= high.x + 3 || low.y >= b.y + 3 || a.y >= high.y + 3)
                << i << " " << k;
        }
    }
    EXPECT_GT(area, 0.5 * 512 * 300);
}

TEST(ShelfPacking, NoneWhereNotEvenPointsFitAndAllOfNone) {
    Context context({.threads = 1});
    const std::vector<dvec2> sizes(100, dvec2{1, 1});
    EXPECT_FALSE(pack_shelves(sizes, 32, 32, 4, context));
    EXPECT_TRUE(pack_shelves({}, 32, 32, 4, context));
    EXPECT_TRUE(pack_shelves(std::vector<dvec2>(3, dvec2{0, 0}), 32, 32, 4, context));
}

TEST(MakeCoordinates, PlacementsOfOneMeshGetPlacesOfTheirOwn) {
    Context context({.threads = 1});
    Scene scene = scene_of(cube());
    scene.nodes.push_back(scene.nodes[0]);
    scene.nodes[1].local.matrix = translation(dvec3{5, 0, 0}) * scaling(dvec3{-2, 2, 2});
    const MadeCoordinates made = make_coordinates(scene, {256, 256, 4}, context);
    EXPECT_EQ(made.meshes, 2u);
    ASSERT_EQ(made.scene.meshes.size(), 2u);
    for (const Mesh& mesh : made.scene.meshes) {
        EXPECT_EQ(mesh.positions.size(), 24u);  // each corner is in three charts
        ASSERT_EQ(mesh.texcoords.size(), 1u);
    }
    // Twice as large in the world is twice as large on the map.
    const auto edge = [&](std::size_t m) {
        const Mesh& mesh = made.scene.meshes[m];
        const vec2 d = mesh.texcoords[0][mesh.indices[1]] - mesh.texcoords[0][mesh.indices[0]];
        return std::sqrt(double(dot(d, d)));
    };
    EXPECT_NEAR(edge(1), 2 * edge(0), 1e-5);
    EXPECT_NEAR(edge(0) * 256, 2 * made.scale, 1e-3);
}

TEST(Padding, TexelsTakeTheNearestCoveredOne) {
    Context context({.threads = 2});
    constexpr int width = 23, height = 17, padding = 5;
    std::mt19937 random(3);
    std::vector<std::uint8_t> covered(width * height, 0);
    for (int i = 0; i < 12; ++i) covered[random() % covered.size()] = 1;
    const std::vector<std::uint32_t> nearest = nearest_covered(covered, width, height, padding, context);
    for (int i = 0; i < width * height; ++i) {
        int least = padding * padding + 1;
        for (int k = 0; k < width * height; ++k) {
            const int dx = i % width - k % width, dy = i / width - k / width;
            if (covered[std::size_t(k)]) least = std::min(least, dx * dx + dy * dy);
        }
        const std::uint32_t found = nearest[std::size_t(i)];
        if (least > padding * padding) {
            EXPECT_EQ(found, no_index);
            continue;
        }
        ASSERT_NE(found, no_index);
        const int dx = i % width - int(found) % width, dy = i / width - int(found) / width;
        EXPECT_EQ(dx * dx + dy * dy, least);
        EXPECT_EQ(covered[found], 1);
    }
}

TEST(MakeCoordinates, ChartsOfManyPlacementsAreChargedToTheBudget) {
    Scene scene = scene_of(plain_sphere(60, 120));
    for (int i = 0; i < 200; ++i) {
        Node node;
        node.meshes = {0};
        node.local.matrix = translation(dvec3{3.0 * i, 0, 0});
        scene.nodes.push_back(node);
    }
    Context context({.threads = 1, .max_memory = 20'000'000});
    EXPECT_EQ(error_of([&] { (void)make_coordinates(scene, {4096, 4096, 1}, context); }).code(), ErrorCode::bad_file);
}

}  // namespace
}  // namespace rakelight::bake
