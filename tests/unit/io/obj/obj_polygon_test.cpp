// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "io/obj/polygon.h"

namespace rakelight::io::obj {
namespace {

struct Cut {
    PolygonCut result;
    std::vector<std::uint32_t> triangles;
};

Cut cut(const std::vector<dvec3>& corners) {
    Cut c;
    c.result = triangulate(corners, c.triangles);
    EXPECT_EQ(c.triangles.size(), 3 * (corners.size() - 2));
    for (const std::uint32_t i : c.triangles) EXPECT_LT(i, corners.size());
    return c;
}

double area2(dvec3 a, dvec3 b, dvec3 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// In the xy plane: every triangle turns like the polygon and the areas sum up to the polygon's, so nothing overlaps.
void expect_covers(const std::vector<dvec3>& p, const Cut& c) {
    double polygon = 0, triangles = 0;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) polygon += area2(p[0], p[i], p[i + 1]);
    for (std::size_t i = 0; i < c.triangles.size(); i += 3) {
        const double a = area2(p[c.triangles[i]], p[c.triangles[i + 1]], p[c.triangles[i + 2]]);
        EXPECT_GE(a * polygon, 0) << "triangle " << i / 3;
        triangles += a;
    }
    EXPECT_NEAR(triangles, polygon, 1e-9 * std::abs(polygon));
}

TEST(ObjPolygon, AConvexPolygonIsAFanFromItsFirstCorner) {
    EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).triangles,
              (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
}

TEST(ObjPolygon, AConcaveQuadIsCutAtItsInnerCornerInEveryOrder) {
    const std::vector<dvec3> arrow{{0, 0, 0}, {2, -2, 0}, {0, 4, 0}, {-2, -2, 0}};
    for (std::size_t turn = 0; turn < 4; ++turn) {
        std::vector<dvec3> p, mirrored;
        for (std::size_t i = 0; i < 4; ++i) p.push_back(arrow[(i + turn) % 4]);
        const Cut c = cut(p);
        EXPECT_EQ(c.result, PolygonCut::good);
        expect_covers(p, c);
        mirrored.assign(p.rbegin(), p.rend());
        expect_covers(mirrored, cut(mirrored));
    }
}

TEST(ObjPolygon, WindingIsKeptInEveryPlane) {
    // An L in each coordinate plane, seen from both sides.
    const std::vector<dvec2> shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    for (int axis = 0; axis < 3; ++axis)
        for (const bool flipped : {false, true}) {
            std::vector<dvec3> p;
            for (const dvec2 q : shape) {
                dvec3 r{1e6, 1e6, 1e6};
                r[std::size_t(axis)] += q.x;
                r[std::size_t((axis + 1) % 3)] += q.y;
                p.push_back(r);
            }
            if (flipped) std::reverse(p.begin(), p.end());
            const Cut c = cut(p);
            double sum = 0;
            const auto u = std::size_t(axis), v = std::size_t((axis + 1) % 3);
            for (std::size_t i = 0; i < c.triangles.size(); i += 3) {
                const dvec3 a = p[c.triangles[i]], b = p[c.triangles[i + 1]], d = p[c.triangles[i + 2]];
                const double area = (b[u] - a[u]) * (d[v] - a[v]) - (b[v] - a[v]) * (d[u] - a[u]);
                EXPECT_GT(flipped ? -area : area, 0);
                sum += area;
            }
            EXPECT_DOUBLE_EQ(std::abs(sum), 6);
        }
}

TEST(ObjPolygon, CornersOnAStraightEdgeDoNotSpoilTheCut) {
    const std::vector<dvec3> p{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
    const Cut c = cut(p);
    EXPECT_EQ(c.result, PolygonCut::good);
    expect_covers(p, c);
}

TEST(ObjPolygon, ABridgeToAHoleIsCutRight) {
    // A square with a square hole, joined by an edge that is walked twice.
    const std::vector<dvec3> p{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0},
                               {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}, {3, 3, 0}};
    const Cut c = cut(p);
    EXPECT_EQ(c.result, PolygonCut::good);
    expect_covers(p, c);
}

TEST(ObjPolygon, DegeneratePolygonsBecomeFans) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(cut({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).result, PolygonCut::degenerate);
    EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).result, PolygonCut::degenerate);
    EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {nan, 0, 0}, {0, 1, 0}}).result, PolygonCut::degenerate);
    EXPECT_EQ(cut({{0, 0, 0}, {1e300, 0, 0}, {1e300, 1e300, 0}, {0, 1e300, 0}}).result, PolygonCut::degenerate);
    EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}).result, PolygonCut::good);
}

TEST(ObjPolygon, APolygonThatCrossesItselfStillGivesItsTriangles) {
    std::vector<dvec3> star;
    const double x[] = {0, 0.5878, -0.9511, 0.9511, -0.5878}, y[] = {1, -0.8090, 0.3090, 0.3090, -0.8090};
    for (int i = 0; i < 5; ++i) star.push_back({x[i], y[i], 0});
    cut(star);
    cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 3, 0}});
}

TEST(ObjPolygon, ALargeZigzagIsCutWithinTheWorkBound) {
    std::vector<dvec3> p;
    const int n = 20'000;
    for (int i = 0; i < n; ++i) p.push_back({double(i), double((i * 7919) % 97), 0});
    p.push_back({double(n), 200, 0});
    p.push_back({-1, 200, 0});
    const Cut c = cut(p);
    EXPECT_EQ(c.result, PolygonCut::good);
    expect_covers(p, c);
}

TEST(ObjPolygon, ASpiralIsCutWithinTheWorkBound) {
    std::vector<dvec3> p;
    const int turns = 400;
    for (int i = 0; i < turns; ++i) {
        const double low = i, high = 1000 - i;
        p.insert(p.end(), {{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}, {low, low + 1, 0}});
    }
    std::vector<dvec3> back(p.rbegin(), p.rend());
    for (dvec3& q : back) q = {q.x + (q.x < 500 ? 0.25 : -0.25), q.y + (q.y < 500 ? 0.25 : -0.25), 0};
    p.insert(p.end(), back.begin(), back.end());
    cut(p);
}

}  // namespace
}  // namespace rakelight::io::obj
