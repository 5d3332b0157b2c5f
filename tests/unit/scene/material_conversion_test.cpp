// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene/materials/material_conversion.h"

namespace rakelight {
namespace {

Material metallic_roughness(vec4 base, float metallic, float roughness) {
    Material m;
    m.base_color = base;
    m.metallic_roughness.metallic = metallic;
    m.metallic_roughness.roughness = roughness;
    return m;
}

Material classical(vec3 k_d, vec3 k_s, float shininess) {
    Material m;
    m.model = MaterialModel::classical;
    m.base_color = {k_d.x, k_d.y, k_d.z, 0.5f};
    m.classical.specular = k_s;
    m.classical.shininess = shininess;
    return m;
}

TEST(ClassicalFromMetallicRoughness, OfADielectricKeepsTheBaseAndReflectsFourPercent) {
    const Material c = classical_from_metallic_roughness(metallic_roughness({0.8f, 0.4f, 0.2f, 0.7f}, 0, 0.5f));
    EXPECT_EQ(c.model, MaterialModel::classical);
    EXPECT_EQ(c.base_color, (vec4{0.8f, 0.4f, 0.2f, 0.7f}));
    EXPECT_EQ(c.classical.ambient, (vec3{0.8f, 0.4f, 0.2f}));
    EXPECT_NEAR(c.classical.specular.x, 0.04f, 1e-7f);
    EXPECT_NEAR(c.classical.shininess, 2 / 0.0625 - 2, 1e-4);  // alpha = 0.25
}

TEST(ClassicalFromMetallicRoughness, OfAMetalHasNoDiffuseAndReflectsTheBase) {
    const Material c = classical_from_metallic_roughness(metallic_roughness({0.8f, 0.4f, 0.2f, 1}, 1, 0.5f));
    EXPECT_EQ(c.base_color, (vec4{0, 0, 0, 1}));
    EXPECT_EQ(c.classical.specular, (vec3{0.8f, 0.4f, 0.2f}));
}

TEST(ClassicalFromMetallicRoughness, KeepsTheExponentWithinItsLimits) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(classical_from_metallic_roughness(metallic_roughness({1, 1, 1, 1}, 0, 0)).classical.shininess, 10000);
    EXPECT_EQ(classical_from_metallic_roughness(metallic_roughness({1, 1, 1, 1}, 0, 1e-20f)).classical.shininess,
              10000);
    EXPECT_EQ(classical_from_metallic_roughness(metallic_roughness({1, 1, 1, 1}, 0, 1)).classical.shininess, 1);
    EXPECT_EQ(classical_from_metallic_roughness(metallic_roughness({1, 1, 1, 1}, 0, 7)).classical.shininess, 1);
    EXPECT_TRUE(std::isfinite(
        classical_from_metallic_roughness(metallic_roughness({1, 1, 1, 1}, nan, nan)).classical.shininess));
}

TEST(ClassicalFromMetallicRoughness, TakesIorAndSpecularFactorsIntoAccount) {
    Material m = metallic_roughness({1, 1, 1, 1}, 0, 0.5f);
    m.metallic_roughness.ior = 2;
    m.metallic_roughness.specular = 0.5f;
    m.metallic_roughness.specular_color = {1, 0, 100};
    const vec3 k_s = classical_from_metallic_roughness(m).classical.specular;
    EXPECT_NEAR(k_s.x, 0.5 / 9, 1e-6);
    EXPECT_EQ(k_s.y, 0);
    EXPECT_EQ(k_s.z, 0.5f) << "F0 never exceeds 1 before the strength";
}

TEST(ClassicalFromMetallicRoughness, LetsTheBaseColorShowWhereATextureDecidesWhatIsMetal) {
    Material m = metallic_roughness({1, 1, 1, 1}, 1, 1);
    m.metallic_roughness.texture.texture = 3;
    const Material c = classical_from_metallic_roughness(m);
    EXPECT_EQ(c.base_color, (vec4{1, 1, 1, 1}));
    EXPECT_NEAR(c.classical.shininess, 30, 1e-3);  // roughness 0.5
}

TEST(ClassicalFromMetallicRoughness, TintsTheHighlightOfAMetalWithTheBaseColorTexture) {
    Material m = metallic_roughness({1, 1, 1, 1}, 1, 0.5f);
    m.base_color_texture.texture = 4;
    EXPECT_EQ(classical_from_metallic_roughness(m).classical.specular_texture.texture, 4u);
    m.metallic_roughness.metallic = 0;
    EXPECT_FALSE(classical_from_metallic_roughness(m).classical.specular_texture);
}

TEST(MetallicRoughnessFromClassical, AndBackGivesTheSameColorsAndExponentInTheNormalizedForm) {
    for (const float n : {1.0f, 2.0f, 10.0f, 100.0f, 9999.0f, 10000.0f})
        for (const vec3 k_s : {vec3{0, 0, 0}, vec3{0.5f, 0.25f, 1}, vec3{1, 1, 1}}) {
            Material there = classical({0.3f, 0, 1}, k_s, n);
            there.specular_form = SpecularForm::normalized;
            const Material back = classical_from_metallic_roughness(metallic_roughness_from_classical(there));
            EXPECT_EQ(back.base_color, (vec4{0.3f, 0, 1, 0.5f}));
            EXPECT_NEAR(back.classical.specular.x, k_s.x, 1e-6);
            EXPECT_NEAR(back.classical.specular.y, k_s.y, 1e-6);
            EXPECT_NEAR(back.classical.specular.z, k_s.z, 1e-6);
            EXPECT_NEAR(back.classical.shininess, n, 1e-5 * n);
        }
}

TEST(MetallicRoughnessFromClassical, ATextbookHighlightKeepsTheBrightnessOfItsCenter) {
    for (const float n : {6.0f, 30.0f, 500.0f}) {
        const Material m = metallic_roughness_from_classical(classical({0, 0, 0}, {0.5f, 0.25f, 1}, n));
        const MetallicRoughnessParameters& p = m.metallic_roughness;
        const double f0 = double(p.specular_color.x) * double(p.specular) * 0.04;
        EXPECT_NEAR(f0 / (4 * std::pow(double(p.roughness), 4)), 0.5, 1e-5) << n;  // GGX's center
    }
}

TEST(MetallicRoughnessFromClassical, WhatHasNoHighlightHasNoneAtGrazingAnglesEither) {
    EXPECT_EQ(metallic_roughness_from_classical(classical({1, 1, 1}, {0, 0, 0}, 30)).metallic_roughness.specular, 0);
}

TEST(MetallicRoughnessFromClassical, StaysWithinZeroToOneForAnyExponent) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    for (const float n : {0.0f, -5.0f, 1.0f, 1e30f, nan, inf}) {
        const float r =
            metallic_roughness_from_classical(classical({1, 1, 1}, {1, 1, 1}, n)).metallic_roughness.roughness;
        EXPECT_GT(r, 0);
        EXPECT_LE(r, 1);
    }
}

TEST(MaterialConversions, LeaveUnlitAndAlreadyConvertedMaterialsAlone) {
    Material unlit = metallic_roughness({0.1f, 0.2f, 0.3f, 1}, 0.5f, 0.5f);
    unlit.model = MaterialModel::unlit;
    EXPECT_EQ(classical_from_metallic_roughness(unlit).model, MaterialModel::unlit);
    EXPECT_EQ(metallic_roughness_from_classical(unlit).base_color, unlit.base_color);
    const Material c = classical({1, 0, 0}, {0.5f, 0.5f, 0.5f}, 20);
    EXPECT_EQ(classical_from_metallic_roughness(c).classical.shininess, 20);
}

TEST(MaterialConversions, KeepWhatBothModelsShare) {
    Material c = classical({1, 0, 0}, {0.5f, 0.5f, 0.5f}, 20);
    c.name = "paint";
    c.normal_texture.texture = 2;
    c.classical.specular_texture.texture = 6;
    c.emission = {0, 3, 0};
    c.double_sided = true;
    const Material m = metallic_roughness_from_classical(c);
    EXPECT_EQ(m.name, "paint");
    EXPECT_EQ(m.normal_texture.texture, 2u);
    EXPECT_EQ(m.metallic_roughness.specular_color_texture.texture, 6u);
    EXPECT_EQ(m.emission, (vec3{0, 3, 0}));
    EXPECT_TRUE(m.double_sided);
}

TEST(MetallicRoughnessFromClassical, ShowsBothSidesAsClassicalMaterialsDo) {
    Material m;
    m.model = MaterialModel::classical;
    EXPECT_TRUE(metallic_roughness_from_classical(m).double_sided);
    m.model = MaterialModel::metallic_roughness;
    EXPECT_FALSE(metallic_roughness_from_classical(m).double_sided) << "it is none, and stays as it is";
}

}  // namespace
}  // namespace rakelight
