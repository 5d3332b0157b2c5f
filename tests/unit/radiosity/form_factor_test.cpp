// SPDX-License-Identifier: Apache-2.0
// Form factors against the closed forms of the catalogue (Howell, "A Catalog of Radiation Heat Transfer Configuration Factors").
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "math/functions.h"
#include "radiosity/form_factor.h"

namespace rakelight::radiosity {
namespace {

using Triangle = std::array<dvec3, 3>;

double sum_over(const std::vector<Triangle>& triangles, dvec3 at, dvec3 normal) {
    double sum = 0;
    for (const Triangle& t : triangles) sum += form_factor_of_triangle(at, normal, t);
    return sum;
}

std::vector<Triangle> square(dvec3 corner, dvec3 u, dvec3 v) {
    return {{corner, corner + u, corner + u + v}, {corner, corner + u + v, corner + v}};
}

/// The mean over a unit square at z = 0, by the middles of n^2 cells.
double mean_over_square(const std::vector<Triangle>& triangles, int n) {
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) sum += sum_over(triangles, {(i + 0.5) / n, (j + 0.5) / n, 0}, {0, 0, 1});
    return sum / (double(n) * n);
}

TEST(FormFactor, ParallelUnitSquaresAtDistanceOne) {
    EXPECT_NEAR(mean_over_square(square({0, 0, 1}, {1, 0, 0}, {0, 1, 0}), 100), 0.199825, 1e-5);
}

TEST(FormFactor, PerpendicularUnitSquaresWithACommonEdge) {
    // steep near the edge: the error of the middles falls with 1 / n
    EXPECT_NEAR(mean_over_square(square({0, 0, 0}, {0, 1, 0}, {0, 0, 1}), 400), 0.200044, 1e-4);
}

TEST(FormFactor, EqualCoaxialDiscs) {
    constexpr int sides = 512, rings = 400;
    std::vector<Triangle> disc;
    const auto rim = [](int k) {
        const double angle = 2 * pi * k / sides;
        return dvec3{math::cos(angle), math::sin(angle), 1};
    };
    for (int k = 0; k < sides; ++k) disc.push_back({dvec3{0, 0, 1}, rim(k), rim(k + 1)});
    double sum = 0;
    for (int r = 0; r < rings; ++r) {
        const double radius = (r + 0.5) / rings;
        sum += sum_over(disc, {radius, 0, 0}, {0, 0, 1}) * 2 * radius / rings;
    }
    EXPECT_NEAR(sum, 0.381966, 1e-4);
}

TEST(FormFactor, ASmallPieceFarAwayIsCosinesOverSquaredDistance) {
    const Triangle t{dvec3{30, 0, 40}, dvec3{30.01, 0, 40}, dvec3{30, 0.01, 40}};  // at 50: both cosines are 0.8
    EXPECT_NEAR(form_factor_of_triangle({0, 0, 0}, {0, 0, 1}, t) / (0.64 * 5e-5 / (pi * 2500)), 1, 1e-3);
}

TEST(FormFactor, AllAroundIsOneAndHalfIsHidden) {
    // four walls and a ceiling, which close over the point; walls reach below the horizon
    std::vector<Triangle> box = square({-1, -1, 1}, {2, 0, 0}, {0, 2, 0});
    for (const auto& [corner, u] : {std::pair(dvec3{-1, -1, -1}, dvec3{2, 0, 0}),
                                    {dvec3{-1, 1, -1}, dvec3{2, 0, 0}},
                                    {dvec3{-1, -1, -1}, dvec3{0, 2, 0}},
                                    {dvec3{1, -1, -1}, dvec3{0, 2, 0}}})
        for (const Triangle& t : square(corner, u, {0, 0, 2})) box.push_back(t);
    for (const dvec3 at : {dvec3{0, 0, 0}, dvec3{0.9, -0.7, 0.3}}) EXPECT_NEAR(sum_over(box, at, {0, 0, 1}), 1, 1e-6);
}

TEST(FormFactor, NothingComesFromThePlaneOrBelowIt) {
    const dvec3 n{0, 0, 1};
    EXPECT_EQ(form_factor_of_triangle({0.2, 0.2, 0}, n, {dvec3{0, 0, 0}, dvec3{1, 0, 0}, dvec3{0, 1, 0}}), 0);
    EXPECT_EQ(form_factor_of_triangle({5, 5, 0}, n, {dvec3{0, 0, 0}, dvec3{1, 0, 0}, dvec3{0, 1, 0}}), 0);
    EXPECT_EQ(form_factor_of_triangle({0, 0, 0}, n, {dvec3{0, 0, -1}, dvec3{1, 0, -1}, dvec3{0, 1, -1}}), 0);
    EXPECT_EQ(form_factor_of_triangle({0, 0, 0}, n, {dvec3{1, 1, 1}, dvec3{1, 1, 1}, dvec3{1, 1, 1}}), 0);
}

TEST(FormFactor, IsTheSameFromBothSidesOfTheTriangle) {
    const dvec3 a{-0.3, 0.4, -0.2}, b{1.2, 0.1, 0.9}, c{0.1, 0.8, 1.3};
    const double one = form_factor_of_triangle({0, 0, 0}, {0, 0, 1}, {a, b, c});
    EXPECT_GT(one, 0.01);
    EXPECT_NEAR(form_factor_of_triangle({0, 0, 0}, {0, 0, 1}, {a, c, b}), one, 1e-12);
}

}  // namespace
}  // namespace rakelight::radiosity
