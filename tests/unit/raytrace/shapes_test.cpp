// SPDX-License-Identifier: Apache-2.0
// Surfaces by their formulas: every meeting lies on them, none is missed, and silhouettes are those of the formulas.
#include "engines/raytrace/scene/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engines/raytrace/scene/polynomial_roots.h"
#include "math/linear.h"

namespace rakelight::raytrace {
namespace {

using Kind = ExactShape::Kind;

/// [m] of a place from the whole surface, by its formula; of the plane from its whole plane.
double off(const ExactShape& s, dvec3 p) {
    const double rho = std::hypot(p.x, p.z);
    switch (s.kind) {
        case Kind::sphere:
            return length(p) - s.radius;
        case Kind::torus:
            return std::hypot(rho - s.radius, p.y) - s.tube_radius;
        case Kind::cylinder:
            return std::max(rho - s.radius, std::fabs(p.y) - s.height / 2);
        case Kind::cone:
            return std::max((rho - s.radius * (0.5 - p.y / s.height)) * s.height / std::hypot(s.radius, s.height),
                            -p.y - s.height / 2);
        case Kind::plane:
            return p.y;
    }
    return 0;
}

const ExactShape shapes[] = {{Kind::sphere, 1.5},         {Kind::cylinder, 0.7, 0, 2.5}, {Kind::cone, 0.9, 0, 1.6},
                             {Kind::torus, 1.2, 0.4},     {Kind::torus, 1, 0.001},       {Kind::torus, 1, 1},
                             {Kind::plane, 0, 0, 0, 2, 3}};

class Shapes : public testing::TestWithParam<ExactShape> {
protected:
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
    dvec3 place(double reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }
    std::mt19937_64 random_{25};
};

TEST_P(Shapes, MeetingsLieOnTheSurfaceAndTellTheSide) {
    const ExactShape& s = GetParam();
    int met = 0;
    for (int i = 0; i < 40000; ++i) {
        const dvec3 origin = place(i % 2 ? 3 : 300), direction = (place(1.2) - origin) * number(0.001, 10);
        const ShapeHits hits = meet(s, origin, direction);
        for (int k = 0; k < hits.count; ++k) {
            const ShapeHit& hit = hits.at[std::size_t(k)];
            const dvec3 p = origin + direction * hit.t;
            ASSERT_NEAR(off(s, p), 0, 1e-9 * (1 + length(origin))) << i;
            ASSERT_LE(hits.at[std::size_t(std::max(k - 1, 0))].t, hit.t);
            const dvec3 n = normalize_or(outward(s, hit.face, p), dvec3{});
            ASSERT_NEAR(length(n), 1, 1e-9);
            if (s.kind != Kind::plane && s.tube_radius != 1 &&
                std::fabs(dot(n, direction)) > 1e-3 * length(direction)) {
                const double step = 1e-6 * (1 + s.tube_radius);
                ASSERT_GT(off(s, p + n * step), off(s, p - n * step)) << "outward";
            }
            ++met;
        }
    }
    EXPECT_GT(met, 100);
}

/// From a place inside a closed surface every ray leaves it; through the whole of it an even number of times.
TEST_P(Shapes, AreClosed) {
    const ExactShape& s = GetParam();
    if (s.kind == Kind::plane) GTEST_SKIP() << "a plane is open";
    for (int i = 0; i < 60000; ++i) {
        const dvec3 origin = place(2.5), direction = place(1);
        const ShapeHits hits = meet(s, origin, direction);
        int ahead = 0, all = hits.count;
        for (int k = 0; k < hits.count; ++k) ahead += hits.at[std::size_t(k)].t > 0;
        EXPECT_EQ(all % 2, 0) << i;
        if (std::fabs(off(s, origin)) < 1e-6) continue;
        EXPECT_EQ(ahead % 2 == 1, off(s, origin) < 0) << i;
    }
}

/// Marching along the ray finds no crossing that was missed.
TEST_P(Shapes, NothingIsMissed) {
    const ExactShape& s = GetParam();
    if (s.kind == Kind::plane) GTEST_SKIP() << "its rim is not in the formula";
    for (int i = 0; i < 300; ++i) {
        const dvec3 origin = place(3), direction = normalize_or(place(0.8) - origin, dvec3{1, 0, 0});
        int crossings = 0;
        double before = off(s, origin);
        for (int k = 1; k <= 20000; ++k) {
            const double now = off(s, origin + direction * (k * 8.0 / 20000));
            crossings += (before < 0) != (now < 0);
            before = now;
        }
        const ShapeHits hits = meet(s, origin, direction);
        int ahead = 0;
        for (int k = 0; k < hits.count; ++k) ahead += hits.at[std::size_t(k)].t > 0 && hits.at[std::size_t(k)].t < 8;
        EXPECT_LE(crossings, ahead) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Shapes, testing::ValuesIn(shapes));

/// Rays that graze: the silhouette is where the formula says, without speckles inside or outside.
TEST(TorusSilhouette, HasNoSpeckles) {
    const ExactShape torus{Kind::torus, 1, 0.25};
    for (int i = 0; i <= 100000; ++i) {
        const double x = 1.3 * i / 100000.0;
        const bool is_met = meet(torus, {x, 5, 0.0}, {0, -1, 0}).count > 0;
        if (std::fabs(std::fabs(x - 1) - 0.25) < 1e-9) continue;
        ASSERT_EQ(is_met, std::fabs(x - 1) < 0.25) << x;
    }
}

TEST(PolynomialRoots, AreThoseThatThePolynomialIsMadeOf) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution number(-1.0, 1.0);
    for (int i = 0; i < 20000; ++i) {
        std::array<double, 4> r{number(random), number(random), number(random), number(random)};
        if (i % 4 == 0) r[1] = r[0] + 1e-5;
        std::sort(r.begin(), r.end());
        if (r[1] - r[0] < 1e-6 || r[2] - r[1] < 1e-6 || r[3] - r[2] < 1e-6) continue;
        const double s1 = r[0] + r[1], p1 = r[0] * r[1], s2 = r[2] + r[3], p2 = r[2] * r[3];
        const Roots roots = quartic_roots({p1 * p2, -(s1 * p2 + s2 * p1), p1 + p2 + s1 * s2, -(s1 + s2), 1}, -2, 2);
        ASSERT_EQ(roots.count, 4) << i;
        for (std::size_t k = 0; k < 4; ++k) ASSERT_NEAR(roots.at[k], r[k], i % 4 == 0 ? 1e-6 : 1e-8) << i;
    }
    const Roots far = quadratic_roots(1, -5e7, 1);  // the textbook's formula loses the small one
    ASSERT_EQ(far.count, 2);
    EXPECT_NEAR(far.at[0], 1e-8, 1e-15);
}

}  // namespace
}  // namespace rakelight::raytrace
