// SPDX-License-Identifier: Apache-2.0
#include "tools/material_names.h"

#include "scene/materials/material_table.h"

namespace rakelight {

namespace {

/// In `inspect`, whose names stay: KHR_materials_specular's strength had the name of the classical color there from the
/// beginning.
const char* inspected_name(const TextureRole& role) {
    return role.number == role_specular_strength ? "specular" : role.name;
}

}  // namespace

std::vector<std::pair<const char*, TextureUse>> named_texture_uses(const Material& m) {
    std::vector<std::pair<const char*, TextureUse>> uses;
    for (const TextureRole& role : texture_roles())
        if (role.is_of(m.model)) uses.emplace_back(inspected_name(role), role.in(m));
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
