// SPDX-License-Identifier: Apache-2.0
#include "io/gltf/materials.h"

#include <rakelight/base/report.h>

#include <algorithm>
#include <limits>

#include "math/linear.h"
#include "scene/materials/material_table.h"
#include "scene/materials/texture_uses.h"

namespace rakelight::io::gltf {
namespace {

constexpr double rounding = 1e-4;  // exporters write 1.0000001

/// A factor within its range; one outside is moved to the nearest end and reported.
float within(const Document& document, const Value& source, const char* name, double value, double high) {
    const double kept = std::clamp(value, 0.0, high);
    if (kept < value - rounding || kept > value + rounding)
        document.remark(Remark::changed, source.place(),
                        std::string(name) + " is out of range; taken as the nearest value within");
    return float(kept);
}

float unit(const Document& document, const Value& source, const char* name, double fallback) {
    return within(document, source, name, source.number(name, fallback), 1);
}

float not_negative(const Document& document, const Value& source, const char* name, double fallback) {
    return within(document, source, name, source.number(name, fallback), std::numeric_limits<float>::max());
}

vec3 color3(const Document& document, const Value& source, const char* name, vec3 fallback) {
    const auto c = source.numbers<3>(name);
    if (!c) return fallback;
    const auto part = [&](std::size_t i) {
        return within(document, source, name, (*c)[i], std::numeric_limits<float>::max());
    };
    return {part(0), part(1), part(2)};
}

vec4 color4(const Document& document, const Value& source, const char* name) {
    const auto c = source.numbers<4>(name);
    if (!c) return {1, 1, 1, 1};
    const auto part = [&](std::size_t i) { return within(document, source, name, (*c)[i], 1); };
    return {part(0), part(1), part(2), part(3)};
}

/// The product, kept in float's range: factors of up to 1e38 come from files.
vec3 scaled(vec3 color, float factor) {
    const auto part = [factor](float v) { return std::min(v * factor, std::numeric_limits<float>::max()); };
    return {part(color.x), part(color.y), part(color.z)};
}

AlphaMode alpha_mode_of(const Value& source) {
    const std::string mode = source.text("alphaMode", "OPAQUE");
    if (mode == "OPAQUE") return AlphaMode::opaque;
    if (mode == "MASK") return AlphaMode::mask;
    if (mode == "BLEND") return AlphaMode::blend;
    source.fail("alphaMode '" + one_line(mode, 20) + "' is unknown");
}

}  // namespace

std::uint32_t Materials::load(std::uint32_t index, const Value& from) {
    if (index == no_index) return no_index;
    if (const auto known = loaded_.find(index); known != loaded_.end()) return known->second;
    const Value source = document_.element(material_kind, index, from);
    Material material;
    material.name = Document::name_of(source, material_kind, index);
    read_common(source, material);
    if (source.extension("KHR_materials_pbrSpecularGlossiness"))
        read_specular_glossiness(source, material);
    else
        read_metallic_roughness(source, material);
    read_extensions(source, material);
    scene_.materials.push_back(std::move(material));
    return loaded_[index] = std::uint32_t(scene_.materials.size() - 1);
}

void Materials::read_common(const Value& source, Material& material) {
    material.normal_texture = textures_.use(source, "normalTexture");
    material.normal_scale = source.object("normalTexture").real("scale", 1);
    material.occlusion_texture = textures_.use(source, "occlusionTexture");
    material.occlusion_strength = unit(document_, source.object("occlusionTexture"), "strength", 1);
    material.emission = color3(document_, source, "emissiveFactor", {0, 0, 0});
    material.emission_texture = textures_.use(source, "emissiveTexture");
    if (source.object("emissiveTexture") && !material.emission_texture)
        drop_emission(material, document_.context().report(), document_.path(), source.place());
    material.alpha_mode = alpha_mode_of(source);
    material.alpha_cutoff = not_negative(document_, source, "alphaCutoff", 0.5);
    material.double_sided = source.boolean("doubleSided", false);
}

void Materials::read_metallic_roughness(const Value& source, Material& material) {
    const Value values = source.object("pbrMetallicRoughness");
    material.base_color = color4(document_, values, "baseColorFactor");
    material.base_color_texture = textures_.use(values, "baseColorTexture");
    MetallicRoughnessParameters& target = material.metallic_roughness;
    target.metallic = unit(document_, values, "metallicFactor", 1);
    target.roughness = unit(document_, values, "roughnessFactor", 1);
    target.texture = textures_.use(values, "metallicRoughnessTexture");
}

/// The diffuse color becomes the base color of a dielectric whose reflectance at normal incidence is the specular
/// color: F0 = min(0.04 * specular_color, 1) * specular for an index of refraction of 1.5 (KHR_materials_specular), so
/// specular_color = specularFactor / 0.04. Glossiness in the texture's alpha has no counterpart and is left out.
void Materials::read_specular_glossiness(const Value& source, Material& material) {
    const Value values = source.extension("KHR_materials_pbrSpecularGlossiness");
    constexpr float dielectric_f0 = 0.04f;
    material.base_color = color4(document_, values, "diffuseFactor");
    material.base_color_texture = textures_.use(values, "diffuseTexture");
    MetallicRoughnessParameters& target = material.metallic_roughness;
    const vec3 specular = color3(document_, values, "specularFactor", {1, 1, 1});
    target.metallic = 0;
    target.roughness = 1 - unit(document_, values, "glossinessFactor", 1);
    target.specular_color = scaled(specular, 1 / dielectric_f0);
    target.specular_color_texture = textures_.use(values, "specularGlossinessTexture");
    document_.remark(Remark::changed, source.place(), "specular-glossiness parameters became metallic-roughness ones");
    if (target.specular_color_texture)
        document_.remark(Remark::dropped, source.place(),
                         "the glossiness in the alpha of specularGlossinessTexture is left out");
}

void Materials::read_extensions(const Value& source, Material& material) {
    MetallicRoughnessParameters& target = material.metallic_roughness;
    if (source.extension("KHR_materials_unlit")) material.model = MaterialModel::unlit;
    const float strength =
        not_negative(document_, source.extension("KHR_materials_emissive_strength"), "emissiveStrength", 1);
    material.emission = scaled(material.emission, strength);
    for (const MaterialParameter& p : metallic_roughness_parameters())
        if (p.gltf.extension)
            if (const Value object = source.extension(p.gltf.extension)) read_parameter(object, p, target);
    for (const TextureRole& role : texture_roles())
        if (role.gltf.extension)
            if (const Value object = source.extension(role.gltf.extension))
                role.in(material) = textures_.use(object, role.gltf.name);
    if (const Value coat = source.extension("KHR_materials_clearcoat"))
        target.clearcoat_normal_scale = coat.object("clearcoatNormalTexture").real("scale", 1);
}

void Materials::read_parameter(const Value& object, const MaterialParameter& p, MetallicRoughnessParameters& target) {
    using Range = MaterialParameter::Range;
    const char* const name = p.gltf.name;
    if (p.color) {
        vec3& color = target.*p.color;
        color = color3(document_, object, name, MetallicRoughnessParameters{}.*p.color);
        if (p.gltf_range == Range::unit) color = min(color, vec3{1, 1, 1});
        return;
    }
    float& number = target.*p.number;
    if (p.gltf_range == Range::unit) number = unit(document_, object, name, double(number));
    if (p.gltf_range == Range::not_negative) number = not_negative(document_, object, name, double(number));
    if (p.gltf_range == Range::any) number = object.real(name, number);
}

}  // namespace rakelight::io::gltf
