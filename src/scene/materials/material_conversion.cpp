// SPDX-License-Identifier: Apache-2.0
// Between classical (k_d, k_s, exponent) and metallic-roughness parameters.
//
// classical_from_metallic_roughness, for use with the normalized Blinn-Phong lobe (is_normalized): k_d = base (1 -
// metallic), k_a = base: uniform ambient light shows metals in their color k_s = mix(F0, base, metallic), F0 =
// min(((ior - 1) / (ior + 1))^2 specular_color, 1) specular: dielectric_f0() of
// src/lighting/models/ggx.glsl (KHR_materials_specular) n = clamp(2 / alpha^2 - 2, 1, 10000), alpha = roughness^2
// (Karis 2013, "Specular BRDF Reference": the exponent whose Blinn-Phong distribution matches a GGX or Beckmann alpha)
// Lost: Fresnel's rise at grazing angles, the long tail of GGX, roughness above 0.904 (n would be below 1), anisotropy,
// the metallic-roughness and specular textures. Values of a metallic-roughness texture are not known here: metallic
// counts as 0 (the base color is then diffuse) and roughness as half its factor. The base color texture tints the
// highlight where metallic > 1/2, else the specular color texture does.
//
// metallic_roughness_from_classical, preserving the brightness of the highlight's center: base = k_d, metallic = 0, ior
// = 1.5, roughness = (2 / (n + 2))^(1/4), so alpha^2 = 2 / (n + 2) F0 = min(1, min(1, 4 alpha^2) k_s): a textbook k_s
// is the brightness of the lobe's center, which for GGX at normal incidence is F0 / (4 alpha^2); min(1, k_s) in the
// normalized form (specular_form_of) specular = min(1, 50 F0), so that materials without a highlight have none at
// grazing angles either (KHR_materials_specular:
//        F90), specular_color = F0 / (0.04 specular)
//
// Lost: k_a, F0 above 1, exponents below 1 or above 10000. A round trip restores k_d and n, and gives F0 as k_s.
//
// tests/unit/raster/shade/shared_parameters_test.cpp compares rendered results of both models.
#include <algorithm>
#include <cmath>

#include "math/linear.h"
#include "scene/materials/material_conversion.h"

namespace rakelight {
namespace {

constexpr float dielectric_f0 = 0.04f;  // ior 1.5
constexpr double max_exponent = 10000;

float clamp01(float x) { return x > 0 ? std::min(x, 1.0f) : 0.0f; }  // NaN gives 0

float exponent_of(float roughness) {
    const double r = clamp01(roughness), alpha_squared = r * r * r * r;
    if (!(alpha_squared > 2 / (max_exponent + 2))) return float(max_exponent);
    return float(std::clamp(2 / alpha_squared - 2, 1.0, max_exponent));
}

float roughness_of(float exponent) {
    const double n = exponent >= 1 ? std::min(double(exponent), max_exponent) : 1.0;
    return float(roughness_of_exponent(n));
}

vec3 dielectric_specular(const MetallicRoughnessParameters& p) {
    const float f0 = ior_f0(std::isfinite(p.ior) && p.ior >= 0 ? p.ior : 1.5f), strength = clamp01(p.specular);
    return {clamp01(f0 * p.specular_color.x) * strength, clamp01(f0 * p.specular_color.y) * strength,
            clamp01(f0 * p.specular_color.z) * strength};
}

/// F0 of a GGX lobe with the center brightness of the classical lobe.
vec3 textbook_f0(const Material& m, float roughness) {
    const vec3 k_s = m.classical.specular;
    const float alpha = roughness * roughness;
    const bool is_normalized = specular_form_of(m, SpecularForm::automatic) == SpecularForm::normalized;
    const float share = is_normalized ? 1.0f : std::min(1.0f, 4 * alpha * alpha);
    return {clamp01(k_s.x * share), clamp01(k_s.y * share), clamp01(k_s.z * share)};
}

}  // namespace

Material classical_from_metallic_roughness(const Material& m) {
    if (m.model != MaterialModel::metallic_roughness) return m;
    Material out = m;
    const MetallicRoughnessParameters& p = m.metallic_roughness;
    const float metallic = p.texture ? 0.0f : clamp01(p.metallic);
    const vec3 base = m.base_color.xyz(), k_d = base * (1 - metallic);
    out.model = MaterialModel::classical;
    out.base_color = {k_d.x, k_d.y, k_d.z, m.base_color.w};
    out.classical.ambient = base;
    out.classical.specular = dielectric_specular(p) * (1 - metallic) + base * metallic;
    out.classical.shininess = exponent_of(p.texture ? 0.5f * clamp01(p.roughness) : p.roughness);
    out.classical.is_normalized = true;
    out.classical.specular_texture = metallic > 0.5f ? m.base_color_texture : p.specular_color_texture;
    out.metallic_roughness = {};
    return out;
}

Material metallic_roughness_from_classical(const Material& m) {
    if (m.model != MaterialModel::classical) return m;
    Material out = m;
    out.model = MaterialModel::metallic_roughness;
    out.metallic_roughness = {};
    MetallicRoughnessParameters& p = out.metallic_roughness;
    p.metallic = 0;
    p.roughness = roughness_of(m.classical.shininess);
    const vec3 f0 = textbook_f0(m, p.roughness);
    p.specular = std::min(1.0f, 50 * std::max(f0.x, std::max(f0.y, f0.z)));
    if (p.specular > 0) p.specular_color = f0 / (dielectric_f0 * p.specular);
    p.specular_color_texture = m.classical.specular_texture;
    out.classical = {};
    out.double_sided = true;  // as classical materials are drawn
    return out;
}

double roughness_of_exponent(double exponent) { return std::sqrt(std::sqrt(2 / (exponent + 2))); }

float ior_f0(float ior) {
    const float ratio = (ior - 1) / (ior + 1);
    return ratio * ratio;
}

SpecularForm specular_form_of(const Material& m, SpecularForm wanted) {
    const SpecularForm form = m.specular_form == SpecularForm::automatic ? wanted : m.specular_form;
    if (form != SpecularForm::automatic) return form;
    const bool is_normalized = m.model == MaterialModel::metallic_roughness ||
                               (m.model == MaterialModel::classical && m.classical.is_normalized);
    return is_normalized ? SpecularForm::normalized : SpecularForm::textbook;
}

bool needs_tangents(const Material& m) {
    const MetallicRoughnessParameters& p = m.metallic_roughness;
    return m.normal_texture || m.height_texture || p.clearcoat_normal_texture || m.ward_alpha ||
           (m.model == MaterialModel::metallic_roughness && p.anisotropy > 0);
}

Bump bump_of(const Material& m, Bump wanted) {
    const Bump bump = m.bump == Bump::automatic ? wanted : m.bump;
    if (bump != Bump::automatic) return bump;
    return m.normal_texture ? Bump::normal : m.height_texture ? Bump::height : Bump::none;
}

bool reads_heights(Bump bump) { return bump != Bump::none && bump != Bump::normal; }

}  // namespace rakelight
