// SPDX-License-Identifier: Apache-2.0
#include "tools/texture_uses.h"

namespace rakelight {

std::vector<std::pair<const char*, TextureUse>> texture_uses(const Material& m) {
    std::vector<std::pair<const char*, TextureUse>> uses{
        {"base_color", m.base_color_texture}, {"normal", m.normal_texture},       {"height", m.height_texture},
        {"opacity", m.opacity_texture},       {"occlusion", m.occlusion_texture}, {"emission", m.emission_texture}};
    if (m.model == MaterialModel::classical) uses.emplace_back("specular", m.classical.specular_texture);
    if (m.model == MaterialModel::metallic_roughness) {
        const MetallicRoughnessParameters& p = m.metallic_roughness;
        uses.emplace_back("metallic_roughness", p.texture);
        uses.emplace_back("specular", p.specular_texture);
        uses.emplace_back("specular_color", p.specular_color_texture);
        uses.emplace_back("anisotropy", p.anisotropy_texture);
        uses.emplace_back("clearcoat", p.clearcoat_texture);
        uses.emplace_back("clearcoat_roughness", p.clearcoat_roughness_texture);
        uses.emplace_back("clearcoat_normal", p.clearcoat_normal_texture);
        uses.emplace_back("sheen_color", p.sheen_color_texture);
        uses.emplace_back("sheen_roughness", p.sheen_roughness_texture);
    }
    std::erase_if(uses, [](const auto& use) { return !use.second; });
    return uses;
}

const char* name_of(MaterialModel model) {
    switch (model) {
        case MaterialModel::classical:
            return "classical";
        case MaterialModel::metallic_roughness:
            return "metallic-roughness";
        case MaterialModel::unlit:
            return "unlit";
    }
    return "unlit";
}

const char* name_of(AlphaMode mode) {
    switch (mode) {
        case AlphaMode::opaque:
            return "opaque";
        case AlphaMode::mask:
            return "mask";
        case AlphaMode::blend:
            return "blend";
    }
    return "opaque";
}

const char* name_of(LightType type) {
    switch (type) {
        case LightType::ambient:
            return "ambient";
        case LightType::directional:
            return "directional";
        case LightType::point:
            return "point";
        case LightType::spot:
            return "spot";
    }
    return "point";
}

}  // namespace rakelight
