// SPDX-License-Identifier: Apache-2.0
// The fan of facets against the lobe that it stands for: its mean direction, and where its rays can lie at all.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/lighting/furnace.h"

namespace rakelight::lighting_test {
namespace {

constexpr int facets = 16;

struct Ray {
    vec3 l;
    float weight;
};

std::vector<Ray> fan_of(vec3 v, double width) {
    Items items;
    for (int i = 0; i < facets; ++i) {
        Item item;
        item.v = v, item.p = {1, 0, 0};
        item.s = float(width), item.t = (float(i) + 0.5f) / facets;
        items.push(item);
    }
    const Results l = run(scalar::kernel, "facet_ray", items), weight = run(scalar::kernel, "facet_weight", items);
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < facets; ++i) rays.push_back({l.vector(0, i), weight[0][i]});
    return rays;
}

dvec3 view_from(double degrees_off, double degrees_about) {
    const double s = std::sin(radians(degrees_off));
    return {s * std::cos(radians(degrees_about)), s * std::sin(radians(degrees_about)), std::cos(radians(degrees_off))};
}

/// Of the light that the lobe sends from v, weighed by its share: facets of slope x = ax q / (1 - |q|), y alike.
dvec3 mean_of_lobe(dvec3 v, double ax, double ay) {
    constexpr int steps = 160;
    Items items;
    std::vector<dvec3> directions;
    std::vector<double> shares;
    for (int i = 0; i < steps * steps; ++i) {
        const double q = (i % steps + 0.5) / steps * 2 - 1, p = (i / steps + 0.5) / steps * 2 - 1;
        const double x = ax * q / (1 - std::fabs(q)), y = ay * p / (1 - std::fabs(p)),
                     z = 1 / std::sqrt(1 + x * x + y * y);
        const double area = ax / std::pow(1 - std::fabs(q), 2) * ay / std::pow(1 - std::fabs(p), 2);
        const dvec3 h = {x * z, y * z, z};
        const double v_dot_h = dot(v, h);
        const dvec3 l = h * (2 * v_dot_h) - v;
        if (v_dot_h <= 0 || l.z <= 0) continue;
        Item item;
        item.l = cast<float>(l), item.v = cast<float>(v), item.p = {1, 0, 0};
        item.ka = {float(ax), float(ay), 0};
        items.push(item);
        directions.push_back(l);
        shares.push_back(l.z * 4 * v_dot_h * area * z * z * z);  // the last four: solid angle, but for a constant
    }
    const Results f = run(scalar::kernel, "ggx_anisotropic_brdf", items);
    dvec3 sum;
    for (std::size_t i = 0; i < shares.size(); ++i) sum = sum + directions[i] * (shares[i] * double(f[0][i]));
    return normalize_or(sum, {0, 0, 1});
}

double degrees_between(dvec3 a, dvec3 b) { return std::acos(std::min(1.0, dot(a, b))) * 180 / pi_d; }

TEST(AnisotropicFan, ItsMeanDirectionIsThatOfTheLobe) {
    for (const double roughness : {0.15, 0.3})
        for (const double strength : {0.3, 0.6, 1.0}) {
            const double ay = roughness * roughness, ax = ay + (1 - ay) * strength * strength;
            for (const double off : {30, 60, 75})
                for (const double about : {0, 45, 90, 180}) {
                    const dvec3 v = view_from(off, about);
                    dvec3 sum;
                    for (const Ray& ray : fan_of(cast<float>(v), std::sqrt(ax * ax - ay * ay)))
                        sum = sum + cast<double>(ray.l) * double(ray.weight);
                    EXPECT_LT(degrees_between(normalize_or(sum, {0, 0, 1}), mean_of_lobe(v, ax, ay)), 7)
                        << roughness << " " << strength << " from " << off << ", " << about;
                }
        }
}

TEST(AnisotropicFan, WithoutWidthEveryFacetMirrorsAboutTheNormal) {
    const vec3 v = cast<float>(view_from(50, 30));
    for (const Ray& ray : fan_of(v, 0)) {
        EXPECT_NEAR(ray.l.x, -v.x, 1e-6);
        EXPECT_NEAR(ray.l.y, -v.y, 1e-6);
        EXPECT_NEAR(ray.l.z, v.z, 1e-6);
        EXPECT_NEAR(ray.weight, 1, 1e-5);
    }
}

TEST(AnisotropicFan, RaysLieOnTheConeAboutTheGrainThroughTheMirrorDirection) {
    // facets that are tilted along t alone keep the part of v along the grain
    for (const double about : {20, 70, 200}) {
        const vec3 v = cast<float>(view_from(60, about));
        float least = 1, most = -1;
        for (const Ray& ray : fan_of(v, 0.8)) {
            EXPECT_NEAR(ray.l.y, -v.y, 1e-5);
            EXPECT_NEAR(dot(ray.l, ray.l), 1, 1e-5);
            if (ray.weight > 0) least = std::min(least, ray.l.x), most = std::max(most, ray.l.x);
        }
        EXPECT_GT(most - least, 0.8f) << about;
    }
}

TEST(AnisotropicFan, WhatLiesBelowTheHorizonHasNoShare) {
    bool any = false;
    for (const Ray& ray : fan_of(cast<float>(view_from(80, 0)), 1)) {
        EXPECT_EQ(ray.weight > 0, ray.l.z > 0);
        any |= ray.weight > 0;
    }
    EXPECT_TRUE(any);
}

TEST(AnisotropicFan, TheOtherSideIsItsMirrorImage) {
    const std::vector<Ray> right = fan_of(cast<float>(view_from(55, 25)), 0.7),
                           left = fan_of(cast<float>(view_from(55, 155)), 0.7);
    for (std::size_t i = 0; i < facets; ++i) {
        EXPECT_NEAR(right[i].l.x, -left[i].l.x, 1e-6);
        EXPECT_NEAR(right[i].l.z, left[i].l.z, 1e-6);
        EXPECT_NEAR(right[i].weight, left[i].weight, 1e-6);
    }
}

}  // namespace
}  // namespace rakelight::lighting_test
