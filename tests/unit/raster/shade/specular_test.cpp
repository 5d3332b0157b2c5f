// SPDX-License-Identifier: Apache-2.0
// KHR_materials_ior and KHR_materials_specular on pixels: what a surface mirrors of a light that faces it, and at its
// rim.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/raster/facing_square.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

/// Where light and viewer face a plastic of roughness 0.5: diffuse what is not mirrored, and pi D V = 1 / (4 alpha^2).
double facing(double base, double f0, double greatest_f0) {
    return base * (1 - greatest_f0) + f0 / (4 * std::pow(0.5, 4));
}

Material plastic() { return metallic(0, 0.5f); }

TEST(Specular, AnIndexOfRefractionMirrorsTheSquareOfItsDifferenceOverItsSum) {
    for (const float ior : {1.0f, 1.33f, 1.5f, 2.4f}) {
        Material m = plastic();
        m.metallic_roughness.ior = ior;
        const double f0 = std::pow((double(ior) - 1) / (double(ior) + 1), 2);
        EXPECT_NEAR(middle(facing_square(m), Lighting::pbr).x, facing(0.5, f0, f0), 2e-5) << ior;
    }
}

TEST(Specular, IndexZeroMirrorsAll) {
    Material m = plastic();
    m.metallic_roughness.ior = 0;  // the extension's case for specular-glossiness
    EXPECT_NEAR(middle(facing_square(m), Lighting::pbr).x, facing(0.5, 1, 1), 2e-4);
}

TEST(Specular, TheFactorMultipliesAndTheColorTints) {
    Material m = plastic();
    m.metallic_roughness.specular = 0.5f;
    m.metallic_roughness.specular_color = {1, 0.5f, 0.25f};
    const vec4 seen = middle(facing_square(m), Lighting::pbr);
    EXPECT_NEAR(seen.x, facing(0.5, 0.02, 0.02), 2e-5);
    EXPECT_NEAR(seen.y, facing(0.25, 0.01, 0.02), 2e-5);  // the diffuse light loses by the greatest component
    EXPECT_NEAR(seen.z, facing(1, 0.005, 0.02), 2e-5);
}

TEST(Specular, ColorsBeyondAllLightEndAtAll) {
    Material m = plastic();
    m.metallic_roughness.ior = 2;  // 1/9
    m.metallic_roughness.specular_color = {30, 1, 1};
    const vec4 seen = middle(facing_square(m), Lighting::pbr);
    EXPECT_NEAR(seen.x, facing(0.5, 1, 1), 2e-4);
    EXPECT_NEAR(seen.y, facing(0.25, 1.0 / 9, 1), 2e-5);
}

TEST(Specular, MetalsIgnoreBoth) {
    Material m = metallic(1, 0.5f);
    const vec4 plain = middle(facing_square(m), Lighting::pbr);
    m.metallic_roughness.ior = 2.4f, m.metallic_roughness.specular = 0.2f;
    m.metallic_roughness.specular_color = {0, 1, 0};
    EXPECT_EQ(middle(facing_square(m), Lighting::pbr), plain);
}

TEST(Specular, OnlyTheFactorTakesFromTheRim) {
    // seen at 86 degrees in even light, where Fresnel's term is close to its end
    const auto rim = [](float factor, vec3 color) {
        Material m = metallic(0, 0.2f, {0, 0, 0});
        m.metallic_roughness.specular = factor, m.metallic_roughness.specular_color = color;
        Scene scene = facing_square(m, {1, 1, 1}, {0, 0, 0});
        scene.nodes[0].local.matrix = dmat4{
            {{std::cos(1.5), 0, -std::sin(1.5), 0}, {0, 1, 0, 0}, {std::sin(1.5), 0, std::cos(1.5), 0}, {0, 0, 0, 1}}};
        const Frame f = draw(scene, flat_camera(), {.width = 33, .height = 33, .lighting = Lighting::pbr});
        return pixel(f, 16, 16);
    };
    const vec4 whole = rim(1, {1, 1, 1}), half = rim(0.5f, {1, 1, 1}), green = rim(1, {0, 1, 0});
    EXPECT_GT(whole.x, 0.5f);
    EXPECT_NEAR(half.x, 0.5f * whole.x, 1e-3);
    EXPECT_NEAR(green.x, whole.x, 0.03f);  // all but f0 times what is left of it
    EXPECT_EQ(green.y, whole.y);
}

}  // namespace
