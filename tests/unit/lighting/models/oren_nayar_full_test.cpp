// SPDX-License-Identifier: Apache-2.0
// The full model of Oren and Nayar against their equations 27 to 29 written once more in double, by angles and libm; Lambert as its
// limit; reciprocity; how far the qualitative model (eq. 30) is from it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "unit/lighting/material_rows.h"

namespace rakelight::lighting_test {
namespace {

/// Radiance over E cos(theta_i) of a surface of facets of albedo rho [1/sr].
double full_model(double theta_i, double theta_r, double phi, double sigma, double rho) {
    const double s2 = sigma * sigma, alpha = std::max(theta_i, theta_r), beta = std::min(theta_i, theta_r);
    const double c1 = 1 - 0.5 * s2 / (s2 + 0.33);
    const double cube = std::pow(2 * beta / pi_d, 3);
    const double c2 = 0.45 * s2 / (s2 + 0.09) * (std::cos(phi) >= 0 ? std::sin(alpha) : std::sin(alpha) - cube);
    const double c3 = 0.125 * s2 / (s2 + 0.09) * std::pow(4 * alpha * beta / (pi_d * pi_d), 2);
    const double direct =
        rho / pi_d *
        (c1 + std::cos(phi) * c2 * std::tan(beta) + (1 - std::fabs(std::cos(phi))) * c3 * std::tan((alpha + beta) / 2));
    const double bounced =
        0.17 * rho * rho / pi_d * s2 / (s2 + 0.13) * (1 - std::cos(phi) * std::pow(2 * beta / pi_d, 2));
    return direct + bounced;
}

double qualitative_model(double theta_i, double theta_r, double phi, double sigma) {
    const double s2 = sigma * sigma, alpha = std::max(theta_i, theta_r), beta = std::min(theta_i, theta_r);
    return (1 - 0.5 * s2 / (s2 + 0.33) +
            0.45 * s2 / (s2 + 0.09) * std::max(0.0, std::cos(phi)) * std::sin(alpha) * std::tan(beta)) /
           pi_d;
}

struct Directions {
    double theta_i, theta_r, phi, sigma;
};

/// Angles to the normal up to 88 degrees, all ways round, roughness to 60 degrees.
std::vector<Directions> all_directions() {
    std::vector<Directions> all;
    const double deg = pi_d / 180;
    for (const double i : {0.0, 0.5, 10.0, 30.0, 45.0, 60.0, 75.0, 85.0, 88.0})
        for (const double r : {0.0, 0.5, 10.0, 30.0, 45.0, 60.0, 75.0, 85.0, 88.0})
            for (const double phi : {0.0, 20.0, 89.0, 91.0, 120.0, 180.0, 250.0, 340.0})
                for (const double sigma : {0.0, 5.0, 20.0, 40.0, 60.0})
                    all.push_back({i * deg, r * deg, phi * deg, sigma * deg});
    return all;
}

vec3 direction(double theta, double phi) {
    return {float(std::sin(theta) * std::cos(phi)), float(std::sin(theta) * std::sin(phi)), float(std::cos(theta))};
}

Item item_of(const Directions& d, vec3 rho, bool is_swapped = false) {
    Item item;
    item.l = direction(d.theta_i, 0.3), item.v = direction(d.theta_r, 0.3 + d.phi);
    if (is_swapped) std::swap(item.l, item.v);
    item.s = float(d.sigma), item.kd = rho;
    return item;
}

const vec3 facet_color{0.9f, 0.5f, 0.1f};

TEST(OrenNayarFull, IsItsEquationsInDouble) {
    Items items;
    for (const Directions& d : all_directions()) items.push(item_of(d, facet_color));
    const Results got = run(scalar::kernel, "oren_nayar_full_brdf", items);
    std::size_t i = 0;
    for (const Directions& d : all_directions()) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double albedo = double(facet_color[c]),
                         expected = full_model(d.theta_i, d.theta_r, d.phi, d.sigma, albedo);
            // per unit of rho; cosines of 88 degrees are rounded to float
            EXPECT_NEAR(double(got[c][i]) * albedo, expected, 2e-6 + 5e-5 * expected)
                << d.theta_i << " " << d.theta_r << " " << d.phi << " " << d.sigma;
        }
        ++i;
    }
}

TEST(OrenNayarFull, IsReciprocal) {
    Items there, back;
    for (const Directions& d : all_directions())
        there.push(item_of(d, facet_color)), back.push(item_of(d, facet_color, true));
    const Results a = run(scalar::kernel, "oren_nayar_full_brdf", there),
                  b = run(scalar::kernel, "oren_nayar_full_brdf", back);
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < there.size(); ++i)
            EXPECT_NEAR(a[c][i], b[c][i], 1e-6 + 2e-5 * double(a[c][i])) << c << " " << i;
}

TEST(OrenNayarFull, WithoutSlopesIsLambertToTheBit) {
    Items items;
    for (MaterialRow row : material_rows()) {
        row.ax = 0;  // sigma
        items.push(item_of(row));
    }
    const Results got = material(scalar::kernel, items, {oren_nayar_full});
    const Results expected = terms(scalar::kernel, items, {lambert, textbook, 1});
    for (std::size_t i = 0; i < items.size(); ++i) EXPECT_EQ(got[3][i], expected[3][i]) << i;
}

TEST(OrenNayarFull, GrowsWithTheSquareOfTheAlbedo) {
    Items items;
    Directions d{0.7, 0.4, 2.0, 0.6};
    items.push(item_of(d, {0, 0.4f, 0.8f}));
    const Results got = run(scalar::kernel, "oren_nayar_full_brdf", items);
    // Per unit of rho what interreflection adds is linear, and its factor that of eq. 28.
    const double per_rho = 0.17 * 0.36 / (0.36 + 0.13) * (1 - std::cos(2.0) * std::pow(0.8 / pi_d, 2)) / pi_d;
    EXPECT_NEAR(double(got[1][0]) - double(got[0][0]), 0.4 * per_rho, 1e-6);
    EXPECT_NEAR(double(got[2][0]) - double(got[0][0]), 0.8 * per_rho, 1e-6);
}

/// By a quadrature of its own in double: 1.050 of white at 89.9 degrees and sigma 0.3, below 1 from sigma 45 degrees on.
TEST(OrenNayarFull, SendsOutItsSurplusAndNoMore) {
    const Outgoing out = whole_hemisphere();
    double most = 0, most_of_rough = 0;
    for (const double angle : furnace_degrees)
        for (const float sigma : {0.0f, 0.15f, 0.3f, 0.45f, 0.8f, 1.2f}) {
            Item like;
            like.s = sigma, like.kd = {1, 1, 1};
            const double a = albedo("oren_nayar_full_brdf", beam(angle), out, like);
            most = std::max(most, a);
            if (sigma >= 0.8f) most_of_rough = std::max(most_of_rough, a);
        }
    EXPECT_NEAR(most, 1.050, 0.002);
    EXPECT_LT(most_of_rough, 1);
}

/// The paper fits eq. 30 by leaving out C3, the part of C2 behind the plane of incidence, and interreflection.
TEST(OrenNayarFull, DiffersFromTheQualitativeModelByWhatThatLeavesOut) {
    Items items;
    for (const Directions& d : all_directions()) items.push(item_of(d, {0, 0.5f, 1}));
    const Results full = run(scalar::kernel, "oren_nayar_full_brdf", items),
                  simple = run(scalar::kernel, "oren_nayar_brdf", items);
    double most_inside = 0, most = 0;
    std::size_t i = 0;
    for (const Directions& d : all_directions()) {
        const double expected = full_model(d.theta_i, d.theta_r, d.phi, d.sigma, 1) -
                                qualitative_model(d.theta_i, d.theta_r, d.phi, d.sigma);
        EXPECT_NEAR(double(full[2][i]) - double(simple[0][i]), expected, 1e-5 + 1e-4 * double(full[2][i])) << i;
        most = std::max(most, std::fabs(expected));
        const double in_plane = std::fabs(std::fabs(std::cos(d.phi)) - 1);
        if (in_plane < 1e-9 && std::cos(d.phi) > 0)  // without rho nothing is left out there: C3 is 0
            most_inside = std::max(
                most_inside, std::fabs(double(full[0][i]) - double(simple[0][i])) / std::max(1.0, double(full[0][i])));
        ++i;
    }
    EXPECT_LT(most_inside, 2e-6);
    EXPECT_GT(most, 0.1);  // [1/sr] where both directions graze: not a matter of digits
}

}  // namespace
}  // namespace rakelight::lighting_test
