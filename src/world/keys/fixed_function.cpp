// SPDX-License-Identifier: Apache-2.0
#include "world/keys/fixed_function.h"

#include <algorithm>

#include "math/linear.h"
#include "scene/materials/material_conversion.h"

namespace rakelight {
namespace {

bool is_classical(Lighting lighting) {
    return lighting == Lighting::automatic || lighting == Lighting::lambert || lighting == Lighting::phong ||
           lighting == Lighting::blinn_phong;
}

/// k_s as bright as the center of the normalized lobe, which is (n + 2) / 8 times its k_s: F0 / (4 alpha^2), at most 1.
vec3 textbook_specular(vec3 normalized, float exponent) {
    const vec3 center = normalized * ((exponent + 2) / 8);
    return {std::min(center.x, 1.0f), std::min(center.y, 1.0f), std::min(center.z, 1.0f)};
}

/// A fixed-function material: one texture, k_a, k_d, k_s, an exponent and an emission.
Material fixed_material(const Material& material) {
    Material m = classical_from_metallic_roughness(material);
    if (m.model == MaterialModel::classical) {
        ClassicalParameters& p = m.classical;
        p.shininess = std::min(p.shininess, max_fixed_shininess);
        if (p.is_normalized) p.specular = textbook_specular(p.specular, p.shininess);
        p.is_normalized = false;
        p.specular_texture = {}, p.mirror = Mirror::none;
    }
    if (m.emission_texture) m.emission = {}, m.emission_texture = {};  // per-texel emission is not supported
    m.occlusion_texture = {};
    m.lighting = Lighting::automatic, m.specular_form = SpecularForm::automatic;
    return m;
}

bool has_place_or_direction(const Light& light) { return light.type != LightType::ambient; }

}  // namespace

bool is_preset_key(std::string_view key) {
    constexpr std::string_view keys[] = {"shading",          "lighting",     "specular",    "multiple-scattering",
                                         "viewer-infinity",  "bump",         "shadows",     "ambient-occlusion",
                                         "bump-self-shadow", "hdri-ambient", "tone-mapping"};
    return std::ranges::find(keys, key) != std::end(keys);
}

void set_preset(Preset preset, PictureRequest& request) {
    if (preset == Preset::none) return;
    RenderSettings& s = request.settings;
    s.shading = Shading::gouraud;
    s.lighting = Lighting::blinn_phong;
    s.specular_form = SpecularForm::textbook;
    s.viewer_at_infinity = true;  // GL_LIGHT_MODEL_LOCAL_VIEWER is off
    s.bump = Bump::none;
}

Scene with_preset(Scene scene, const PictureRequest& request) {
    if (request.preset == Preset::none) return scene;
    if (scene.environment && !request.hdri_ambient.value_or(false)) scene.environment->is_light = false;
    if (scene.environment && !scene.environment->is_light && !scene.environment->is_background)
        scene.environment.reset();
    const bool has_fixed_lighting = request.settings.lighting_text.empty() && is_classical(request.settings.lighting);
    for (Material& m : scene.materials) {
        if (has_fixed_lighting) m = fixed_material(m);
        m.shading.reset();
        if (request.settings.bump == Bump::none) m.bump = Bump::none;
    }
    for (Node& node : scene.nodes) node.shading.reset();
    return scene;
}

std::size_t lights_beyond_preset(const std::vector<Light>& lights, const PictureRequest& request) {
    if (request.preset == Preset::none) return 0;
    const std::size_t count = std::size_t(std::ranges::count_if(lights, has_place_or_direction));
    return count > max_fixed_lights ? count - max_fixed_lights : 0;
}

std::vector<Light> within_preset(std::vector<Light> lights, const PictureRequest& request) {
    if (request.preset == Preset::none) return lights;
    std::size_t taken = 0;
    std::erase_if(lights,
                  [&](const Light& light) { return has_place_or_direction(light) && ++taken > max_fixed_lights; });
    return lights;
}

}  // namespace rakelight
