// SPDX-License-Identifier: Apache-2.0
#include "shading/materials.h"

#include <algorithm>
#include <cmath>

#include "math/functions.h"
#include "math/linear.h"
#include "scene/materials/material_conversion.h"
#include "scene/materials/uv_matrix.h"
#include "shading/refraction.h"

namespace rakelight::shading {
namespace {

void copy(float (&to)[3], vec3 from) {
    to[0] = from.x;
    to[1] = from.y;
    to[2] = from.z;
}

/// What the models of more parameters read.
void add_layers(const Material& m, MaterialFactors& v) {
    const MetallicRoughnessParameters& p = m.metallic_roughness;
#define RL_COPY(name) v.name = p.name;
    RL_COPIED_PARAMETERS(RL_COPY)
#undef RL_COPY
    v.lobe_roughness = float(roughness_of_exponent(double(v.shininess)));
    v.sigma = m.sigma_rad.value_or(-1);
    const vec2 alpha = m.ward_alpha.value_or(vec2{0, 0});
    v.ward_alpha[0] = alpha.x, v.ward_alpha[1] = alpha.y;
    v.anisotropy_axis[0] = float(math::cos(double(p.anisotropy_rotation_rad)));
    v.anisotropy_axis[1] = float(math::sin(double(p.anisotropy_rotation_rad)));
    copy(v.sheen_color, p.sheen_color);
}

/// Beer-Lambert: exp(-attenuation d) is the color at the distance that the material says.
vec3 attenuation_of(const MetallicRoughnessParameters& p) {
    if (!(p.attenuation_distance > 0) || !(p.thickness > 0)) return {};
    const auto per_meter = [&p](float color) {
        return float(-math::log(std::clamp(double(color), 1e-6, 1.0)) / double(p.attenuation_distance));
    };
    return {per_meter(p.attenuation_color.x), per_meter(p.attenuation_color.y), per_meter(p.attenuation_color.z)};
}

/// What is seen through it. Blur: KHR_materials_ior has none of it at an index of 1, all of it from 1.5 on.
void add_through(const MetallicRoughnessParameters& p, MaterialFactors& v) {
    v.through_blur = std::clamp(2 * p.ior - 2, 0.0f, 1.0f);
    v.through_parts = v.is_body && v.dispersion > 0;
    for (int color = 0; color < 3; ++color)
        v.through_eta[color] = v.is_body ? 1 / refraction_of(v, v.through_parts ? color : -1) : 1;
}

/// Where rays continue.
void add_transport(const Material& m, MaterialFactors& v) {
    static_assert(int(Mirror::constant) == mirror_constant && int(Mirror::fresnel) == mirror_fresnel);
    v.refraction = 1;
    if (m.model == MaterialModel::classical) {
        v.mirror = std::int32_t(m.classical.mirror);
        copy(v.filter, m.classical.transmission);
        v.is_body = m.classical.refraction_index > 0;
        if (v.is_body) v.refraction = m.classical.refraction_index;
    }
    if (m.model != MaterialModel::metallic_roughness) return;
    v.is_body = m.metallic_roughness.thickness > 0;
    if (v.is_body) v.refraction = m.metallic_roughness.ior, v.dispersion = m.metallic_roughness.dispersion;
    copy(v.attenuation, attenuation_of(m.metallic_roughness));
    add_through(m.metallic_roughness, v);
}

}  // namespace

std::vector<const TextureRole*> roles_of(const Material& m) {
    std::vector<const TextureRole*> roles;
    for (const TextureRole& role : texture_roles())
        if (role.in(m) && role.is_shown_by(m)) roles.push_back(&role);
    return roles;
}

MaterialFactors material_factors(const Material& m) {
    MaterialFactors v{};
    v.unlit = m.model == MaterialModel::unlit;
    v.metallic_roughness = m.model == MaterialModel::metallic_roughness;
    const vec4 c = m.base_color;
    v.base_color[0] = c.x, v.base_color[1] = c.y, v.base_color[2] = c.z, v.base_color[3] = c.w;
    if (m.model != MaterialModel::unlit) copy(v.emission, m.emission);  // KHR_materials_unlit: the base color alone
    copy(v.ambient, m.classical.ambient);
    copy(v.specular, m.classical.specular);
    v.shininess = m.classical.shininess < 1 ? 1 : m.classical.shininess;
    if (m.model == MaterialModel::classical && v.shininess <= 1024 && v.shininess == std::floor(v.shininess))
        v.whole_exponent = std::int32_t(v.shininess);
    copy(v.dielectric_color, m.metallic_roughness.specular_color * ior_f0(m.metallic_roughness.ior));
    v.specular_strength = m.metallic_roughness.specular;
    v.normal_scale = m.normal_scale;
    v.occlusion_strength = m.occlusion_strength;
    v.alpha_cutoff = m.alpha_mode == AlphaMode::mask ? m.alpha_cutoff : -1;
    v.blend = m.alpha_mode == AlphaMode::blend;
    add_layers(m, v);
    add_transport(m, v);
    return v;
}

UvTransform uv_transform(const TextureUse& use) {
    const UvMatrix m = uv_matrix(use.transform);
    const vec2 offset = use.transform.offset;
    return {float(m.uu), float(m.uv), float(m.vu), float(m.vv), offset.x, offset.y};
}

bool is_identity(const UvTransform& t) {
    return t.uu == 1 && t.uv == 0 && t.vu == 0 && t.vv == 1 && t.u0 == 0 && t.v0 == 0;
}

bool has_layers(const MaterialFactors& m) {
    return m.anisotropy > 0 || m.clearcoat > 0 || m.sheen_color[0] > 0 || m.sheen_color[1] > 0 ||
           m.sheen_color[2] > 0 || m.transmission > 0 || m.iridescence > 0;
}

}  // namespace rakelight::shading
