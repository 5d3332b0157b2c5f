// SPDX-License-Identifier: Apache-2.0
// Ends for lights that have none: where they lie, against closed forms, and that no place loses more light than was
// said.
#include "scene/light_cutoff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <rakelight/scene/light_limits.h>

namespace rakelight {
namespace {

constexpr float endless = std::numeric_limits<float>::infinity();

Light classical(float constant, float linear, float quadratic, float color = 1) {
    Light light;
    light.constant = constant, light.linear = linear, light.quadratic = quadratic;
    light.diffuse = light.specular = {color, 0.5f * color, 0};
    return light;
}

Light photometric(float candela, LightType type = LightType::point) {
    Light light;
    light.type = type;
    light.units = LightUnits::photometric;
    light.intensity = candela;
    return light;
}

/// What arrives of the brightest color, without and with the window of KHR_lights_punctual.
double light_at(const Light& l, double d, bool with_range) {
    const double brightest =
        l.units == LightUnits::photometric
            ? double(l.intensity) / pi / (d * d)
            : double(l.diffuse.x) / (double(l.constant) + d * (double(l.linear) + d * double(l.quadratic)));
    if (!with_range) return brightest;
    const double ratio = d / double(l.range);
    return brightest * std::clamp(1 - ratio * ratio * ratio * ratio, 0.0, 1.0);
}

TEST(LightCutoff, ReachesAreThoseOfTheClosedForms) {
    EXPECT_NEAR(reach_of(classical(1, 0, 4), 0.01), std::sqrt(99.0 / 4), 1e-9);
    EXPECT_NEAR(reach_of(classical(0, 2, 0), 0.01), 50, 1e-9);
    EXPECT_NEAR(reach_of(classical(0, 0, 1, 4), 0.01), 20, 1e-9);
    EXPECT_NEAR(reach_of(classical(1, 3, 2), 1.0 / 6), 1, 1e-9);
    EXPECT_NEAR(reach_of(photometric(float(pi)), 0.0001), 100, 1e-4);
}

TEST(LightCutoff, AmbientAndTheLargerOfDiffuseAndSpecularCountTogetherInTheBrightestChannel) {
    Light light = classical(0, 0, 1);  // diffuse and specular are (1, 0.5, 0)
    light.ambient = {8, 0, 0};
    EXPECT_NEAR(reach_of(light, 0.01), 30, 1e-9);
    light.specular = {0, 16, 0};
    EXPECT_NEAR(reach_of(light, 0.01), 40, 1e-9);
}

TEST(LightCutoff, NoDistanceLosesMoreThanTheCutoff) {
    for (Light light : {classical(1, 0, 4), classical(0, 1, 0), classical(0.01f, 0, 1), classical(5, 0, 0.001f),
                        classical(0, 0.3f, 2, 50), photometric(400), photometric(0.01f)})
        for (const double cutoff : {0.1, 1.0 / 255, 0.0003}) {
            std::vector<Light> cut = {light};
            cut_lights(cut, cutoff);
            double most = 0;
            for (double d = 1e-3; d < 1e5; d *= 1.001)
                most = std::max(most, light_at(light, d, false) - light_at(cut[0], d, true));
            EXPECT_LE(most, cutoff * (1 + 1e-6)) << light.constant << ' ' << light.linear << ' ' << light.quadratic;
            EXPECT_GT(most, std::min(cutoff, 1.0 / 5) * 0.99) << "the bound is reached, at the range";
        }
}

TEST(LightCutoff, ALightThatNeverBringsSoMuchIsGoneAndOneThatDoesNotThinOutStays) {
    std::vector<Light> lights = {classical(500, 0, 1), classical(1, 0, 0), classical(0, 0, 0)};
    const CutLights result = cut_lights(lights, 1.0 / 255);
    EXPECT_EQ(lights[0].range, std::nextafter(float(min_light_range), 1.0f));
    EXPECT_EQ(lights[1].range, endless);
    EXPECT_EQ(lights[2].range, endless);
    EXPECT_EQ(result.cut, 1u);
    EXPECT_EQ(result.endless, 2u);
}

TEST(LightCutoff, LightsThatEndAndThoseWithoutAPlaceStayAsTheyAre) {
    Light ends = classical(1, 0, 4), sun = photometric(3, LightType::directional), sky;
    ends.range = 100;
    sky.type = LightType::ambient;
    std::vector<Light> lights = {ends, sun, sky};
    EXPECT_EQ(cut_lights(lights, 0.5).cut, 0u);
    EXPECT_EQ(lights[0].range, 100);
    EXPECT_EQ(lights[1].range, endless);
    EXPECT_EQ(lights[2].range, endless);
}

TEST(LightCutoff, WhatWasDoneIsSaid) {
    std::vector<Light> lights = {classical(0, 0, 1), classical(0, 0, 1, 4), photometric(float(pi), LightType::spot),
                                 classical(1, 0, 0)};
    EXPECT_EQ(said(cut_lights(lights, 0.01), 0.01),
              "light cutoff 0.01: 3 lights cut at 10 to 20 m; without an end, since they stay brighter: 1");
    EXPECT_EQ(said(CutLights{}, 0.5), "light cutoff 0.5: no light is cut");
}

}  // namespace
}  // namespace rakelight
