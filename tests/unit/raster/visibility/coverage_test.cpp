// SPDX-License-Identifier: Apache-2.0
// Rasterization rules against a slow reference in exact integers.
#include "engines/raster/visibility/coverage.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

using namespace rakelight;
using namespace rakelight::raster;

namespace {

using Point = std::pair<std::int32_t, std::int32_t>;  // 1/256 px

ScreenTriangle triangle_of(Point a, Point b, Point c) {
    ScreenTriangle s{};
    const std::int64_t area = std::int64_t(b.first - a.first) * (c.second - a.second) -
                              std::int64_t(c.first - a.first) * (b.second - a.second);
    if (area < 0) std::swap(b, c);
    s.x0 = a.first, s.x1 = b.first, s.x2 = c.first;
    s.y0 = a.second, s.y1 = b.second, s.y2 = c.second;
    s.key0 = s.key1 = s.key2 = 1;
    return s;
}

std::multiset<Point> pixels_of(const ScreenTriangle& s, Window area) {
    std::multiset<Point> covered;
    cover(s, area, 0, 0, [&](int x, int y, float) { covered.insert({x, y}); });
    return covered;
}

/// Strictly inside all three edges, in exact integers.
bool is_strictly_inside(const ScreenTriangle& s, int x, int y) {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t n = (k + 1) % 3;
        const __int128 e =
            __int128(s.x(n) - s.x(k)) * (y * 256 + 128 - s.y(k)) - __int128(s.y(n) - s.y(k)) * (x * 256 + 128 - s.x(k));
        if (e <= 0) return false;
    }
    return true;
}

}  // namespace

TEST(Coverage, APixelSquareOfTwoTrianglesCoversItsPixelsOnce) {
    const Window area{0, 0, 64, 64};
    const Point a{0, 0}, b{8 * 256, 0}, c{8 * 256, 8 * 256}, d{0, 8 * 256};
    std::multiset<Point> all = pixels_of(triangle_of(a, b, c), area);
    all.merge(pixels_of(triangle_of(a, c, d), area));
    EXPECT_EQ(all.size(), 64u);
    EXPECT_EQ(std::set<Point>(all.begin(), all.end()).size(), 64u);
}

TEST(Coverage, CentersExactlyOnTheBorderBelongToTopAndLeftEdges) {
    const Window area{0, 0, 64, 64};
    const Point a{128, 128}, b{128 + 512, 128}, c{128 + 512, 128 + 512},
        d{128, 128 + 512};  // centers of pixels 0 and 2
    std::multiset<Point> all = pixels_of(triangle_of(a, b, c), area);
    all.merge(pixels_of(triangle_of(a, c, d), area));
    EXPECT_EQ(all, (std::multiset<Point>{{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
}

/// Random triangulations of a square: a jittered grid, slivers included. Every pixel of it exactly once.
TEST(Coverage, EveryPixelOfARandomMeshIsCoveredExactlyOnce) {
    const Window area{0, 0, 64, 64};
    std::mt19937 random(3);
    for (int round = 0; round < 200; ++round) {
        const int n = 2 + int(random() % 12), size = 64 * 256;
        std::map<Point, Point> grid;
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                const int step = size / n;
                const auto jitter = [&](int k) {
                    return k == 0 || k == n ? 0 : int(random() % unsigned(step)) - step / 2;
                };
                const int snap = round % 3 == 0 ? 128 : 1;  // every third mesh has vertices on pixel centers
                const auto place = [&](int k) { return k == n ? size : (k * step + jitter(k)) / snap * snap; };
                grid[{i, j}] = {place(i), place(j)};
            }
        std::map<Point, int> count;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const Point a = grid[{i, j}], b = grid[{i + 1, j}], c = grid[{i + 1, j + 1}], d = grid[{i, j + 1}];
                // A fan about an inner point keeps also folded quads a tiling in the signed sense; use only convex ones.
                const auto side = [](Point p, Point q, Point r) {
                    return std::int64_t(q.first - p.first) * (r.second - p.second) -
                           std::int64_t(r.first - p.first) * (q.second - p.second);
                };
                for (const auto& [p, q, r] : {std::tuple(a, b, c), std::tuple(a, c, d)}) {
                    const std::int64_t area2 = side(p, q, r);
                    if (area2 == 0) continue;
                    for (const Point& pixel : pixels_of(triangle_of(p, q, r), area)) count[pixel] += area2 > 0 ? 1 : -1;
                }
            }
        // Signed: a folded quad covers some pixels once more with each sign, so the sum is one everywhere all the same.
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                ASSERT_EQ((count[{x, y}]), 1) << "round " << round << " pixel " << x << ", " << y;
    }
}

TEST(Coverage, AgreesWithAnExactReferenceAwayFromEdges) {
    const Window area{0, 0, 64, 64};
    std::mt19937 random(11);
    for (int round = 0; round < 500; ++round) {
        const bool huge = round % 5 == 0;  // corners at the guard band
        const auto coordinate = [&] {
            return huge ? std::int32_t(random() % (1u << 29)) - (1 << 28)
                        : std::int32_t(random() % (96 * 256)) - 16 * 256;
        };
        const Point a{coordinate(), coordinate()}, b{coordinate(), coordinate()}, c{coordinate(), coordinate()};
        const ScreenTriangle s = triangle_of(a, b, c);
        const std::multiset<Point> covered = pixels_of(s, area);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x)
                if (is_strictly_inside(s, x, y)) {
                    ASSERT_EQ(covered.count({x, y}), 1u) << round;
                }
        for (const Point& p : covered) EXPECT_TRUE(p.first >= 0 && p.first < 64 && p.second >= 0 && p.second < 64);
    }
}

TEST(Coverage, ATriangleBetweenPixelCentersCoversNothing) {
    EXPECT_TRUE(pixels_of(triangle_of({130, 130}, {250, 130}, {130, 250}), {0, 0, 64, 64}).empty());
}

TEST(Coverage, OnlyPixelsOfTheWindowAreTouched) {
    const auto covered = pixels_of(triangle_of({0, 0}, {64 * 256, 0}, {0, 64 * 256}), {5, 7, 3, 2});
    EXPECT_EQ(covered.size(), 6u);
    for (const Point& p : covered) EXPECT_TRUE(p.first >= 5 && p.first < 8 && p.second >= 7 && p.second < 9);
}
