// SPDX-License-Identifier: Apache-2.0
// Which blended triangles are said to need no sorting, beside a look at every pixel and sample.
#include "engines/raster/shade/blend_groups.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "engines/raster/multisample.h"
#include "engines/raster/shade/blend_tile.h"
#include "engines/raster/shade/layer_order.h"
#include "engines/raster/visibility/coverage.h"
#include "unit/raster/drawn.h"
#include "unit/raster/geometry/one_tile.h"

using namespace rakelight;
using namespace rakelight::test;
using namespace rakelight::raster;

namespace {

constexpr Window all{0, 0, 64, 64};

void add_glass(Scene& scene, std::vector<vec3> positions, std::vector<std::uint32_t> indices) {
    Mesh mesh;
    mesh.material = add_unlit(scene, {1, 0, 0, 0.5f}, AlphaMode::blend);
    mesh.positions = std::move(positions);
    mesh.indices = std::move(indices);
    add_object(scene, std::move(mesh));
}

/// A pane over all of the picture that is `depth` meters away in its middle.
void add_pane(Scene& scene, float depth, float slope_x, float slope_y) {
    std::vector<vec3> corners;
    for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}})
        corners.push_back({9 * x, 9 * y, -depth + 9 * (slope_x * x + slope_y * y)});
    add_glass(scene, corners, {0, 1, 2, 0, 2, 3});
}

std::vector<GroupedTriangle> groups_of(const OneTile& t, bool by_pixel = false) {
    return blend_groups(t.job, 0, all, blending_order(t.job, 0), by_pixel);
}

/// [samples][pixels] of a triangle's plane; -1 where it does not cover the sample.
std::vector<float> keys_of(const ScreenTriangle& t, int samples) {
    const auto positions = sample_positions(samples);
    std::vector<float> keys(positions.size() * tile_pixels, -1);
    KeyPlane plane;
    set_plane(t, 0, 0, plane);
    for (std::size_t k = 0; k < positions.size(); ++k)
        cover(seen_from(positions[k], t), all, 0, 0, [&](int x, int y, float) {
            keys[k * tile_pixels + std::size_t(tile_size * y + x)] =
                depth_at(plane, float(x) + float(positions[k].x) / 16, float(y) + float(positions[k].y) / 16);
        });
    return keys;
}

/// Of two groups the first is farther at all common samples; where one of a group's triangles does not wait, it has no
/// common samples with the others.
void expect_right(const OneTile& t, int samples, unsigned seed) {
    const std::vector<GroupedTriangle> grouped = groups_of(t);
    std::vector<std::vector<float>> keys;
    for (const GroupedTriangle& g : grouped) keys.push_back(keys_of(*t.job.binned.items[g.number], samples));
    for (std::size_t i = 0; i < grouped.size(); ++i)
        for (std::size_t j = i + 1; j < grouped.size(); ++j) {
            const bool is_sorted = grouped[i].group != grouped[j].group;
            if (!is_sorted && grouped[i].waits && grouped[j].waits) continue;
            for (std::size_t k = 0; k < keys[i].size(); ++k) {
                const bool both = keys[i][k] >= 0 && keys[j][k] >= 0;
                ASSERT_TRUE(!both || (is_sorted && is_laid_before({keys[i][k], 1}, {keys[j][k], 0})))
                    << seed << ", " << k;
            }
        }
}

/// Panes, large and small triangles in every attitude, quads in parts.
Scene random_scene(unsigned seed) {
    Scene scene;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> part(-1, 1);
    const float size = seed % 2 ? 0.3f : 3.0f;
    for (int n = 0; n < 12; ++n) {
        const vec3 middle{3 * part(random), 3 * part(random), -6 + 3 * part(random)};
        const auto beside = [&] {
            return vec3{middle.x + size * part(random), middle.y + size * part(random), middle.z + part(random)};
        };
        add_glass(scene, {beside(), beside(), beside(), beside()}, {0, 1, 2, 2, 1, 3});
    }
    for (int n = 0; n < 4; ++n) add_pane(scene, 6 + 2 * part(random), 0.3f * part(random), 0.3f * part(random));
    return scene;
}

ScreenTriangle triangle_of(const std::int32_t (&x)[3], const std::int32_t (&y)[3]) {
    ScreenTriangle s{};
    const std::int64_t area = std::int64_t(x[1] - x[0]) * (y[2] - y[0]) - std::int64_t(x[2] - x[0]) * (y[1] - y[0]);
    const std::size_t second = area < 0 ? 2 : 1;
    s.x0 = x[0], s.x1 = x[second], s.x2 = x[3 - second];
    s.y0 = y[0], s.y1 = y[second], s.y2 = y[3 - second];
    s.key0 = s.key1 = s.key2 = 1;
    return s;
}

}  // namespace

TEST(BlendGroups, OfRandomScenesAreInOrderAtEverySample) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        const OneTile t(random_scene(seed), one_tile);
        expect_right(t, 1, seed);
        expect_right(t, 4, seed);
    }
}

TEST(BlendGroups, LeaningPanesOneBehindAnotherAreEachAGroupWhereNothingWaits) {
    Scene scene;
    for (int i = 0; i < 20; ++i) add_pane(scene, 4 + 0.1f * float(i), 0.25f, -0.15f);
    const std::vector<GroupedTriangle> grouped = groups_of(OneTile(scene, one_tile));
    ASSERT_EQ(grouped.size(), 40u);
    for (std::size_t i = 0; i < grouped.size(); ++i) {
        EXPECT_EQ(grouped[i].group, i / 2);
        EXPECT_EQ(grouped[i].number / 2, 19 - i / 2);
        EXPECT_FALSE(grouped[i].waits);
    }
}

TEST(BlendGroups, CrossingPanesWaitTogetherAndThoseBehindAndBeforeThemDoNot) {
    Scene scene;
    add_pane(scene, 12, 0, 0);
    add_pane(scene, 6, 0.1f, 0);
    add_pane(scene, 6, -0.1f, 0);
    add_pane(scene, 3, 0, 0);
    const std::vector<GroupedTriangle> grouped = groups_of(OneTile(scene, one_tile));
    ASSERT_EQ(grouped.size(), 8u);
    for (std::size_t i = 0; i < grouped.size(); ++i) EXPECT_EQ(grouped[i].waits, i >= 2 && i < 6) << i;
    EXPECT_EQ(grouped[2].group, grouped[5].group);
}

TEST(BlendGroups, WherePixelsHaveOneOrderTheHalvesOfAPaneWait) {
    Scene scene;
    add_pane(scene, 6, 0.1f, 0);
    for (const GroupedTriangle& g : groups_of(OneTile(scene, one_tile), true)) EXPECT_TRUE(g.waits);
    for (const GroupedTriangle& g : groups_of(OneTile(scene, one_tile), false)) EXPECT_FALSE(g.waits);
}

TEST(BlendGroups, MethodsWithoutDepthKeepTheirOrder) {
    Scene scene;
    add_pane(scene, 6, 0.1f, 0);
    add_pane(scene, 6, -0.1f, 0);
    RenderSettings s = one_tile;
    s.visibility = Visibility::none;
    const std::vector<GroupedTriangle> grouped = groups_of(OneTile(scene, s));
    for (std::size_t i = 0; i < grouped.size(); ++i) {
        EXPECT_EQ(grouped[i].number, i);
        EXPECT_FALSE(grouped[i].waits);
    }
}

TEST(BlendGroups, TrianglesThatLieApartCoverNoCommonPixel) {
    std::mt19937 random(4);
    std::size_t apart = 0, touching = 0;
    for (int n = 0; n < 4000; ++n) {
        std::int32_t x[6], y[6];
        for (int k = 0; k < 6; ++k) {  // on the centers of few pixels, so that many touch
            x[k] = 128 + 256 * std::int32_t(random() % 8);
            y[k] = 128 + 256 * std::int32_t(random() % 8);
        }
        const ScreenTriangle a = triangle_of({x[0], x[1], x[2]}, {y[0], y[1], y[2]});
        const ScreenTriangle b = triangle_of({x[3], x[4], x[5]}, {y[3], y[4], y[5]});
        if (!lie_apart(a, b)) continue;
        ++apart;
        const std::vector<float> of_a = keys_of(a, 1), of_b = keys_of(b, 1);
        for (std::size_t k = 0; k < of_a.size(); ++k) ASSERT_TRUE(of_a[k] < 0 || of_b[k] < 0) << n;
        for (int i = 0; i < 3; ++i)
            for (int j = 3; j < 6; ++j) touching += x[i] == x[j] && y[i] == y[j];
    }
    EXPECT_GT(apart, 500u);
    EXPECT_GT(touching, 50u);
}
