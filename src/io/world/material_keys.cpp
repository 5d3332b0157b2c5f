// SPDX-License-Identifier: Apache-2.0
#include "io/world/material_keys.h"

#include "scene/materials/material_table.h"
#include "scene/materials/texture_uses.h"

namespace rakelight::io::world {
namespace {

using C = MaterialChange;

Relief& relief(C& c) { return c.material.relief ? *c.material.relief : c.material.relief.emplace(); }

void set_color(C& c) {
    const vec3 k = c.color();
    c.material.base_color = {k.x, k.y, k.z, c.material.base_color.w};
    c.material.classical.ambient = k;  // `ambient` is read after it
}

void set_opacity(C& c) {
    c.material.base_color.w = c.number();
    if (c.number() < 1 && c.material.alpha_mode == AlphaMode::opaque) c.material.alpha_mode = AlphaMode::blend;
}

void transform_textures(C& c, void (*change)(TextureTransform&, const C&)) {
    for_each_texture_use(c.material, [&](TextureUse& use) { change(use.transform, c); });
}

constexpr Word<AlphaMode> alpha_words[] = {
    {"opaque", AlphaMode::opaque}, {"mask", AlphaMode::mask}, {"blend", AlphaMode::blend}};

Of of_model(std::optional<MaterialModel> model) {
    if (!model) return Of::all;
    return *model == MaterialModel::classical ? Of::classical : Of::metallic_roughness;
}

std::vector<MaterialKey> pictures() {
    std::vector<MaterialKey> keys;
    for (const TextureRole& role : texture_roles())
        keys.push_back({{role.key, Kind::file, role.help}, of_model(role.model), [&role](C& c) {
                            role.in(c.material) = c.picture;
                            if (role.number == role_opacity && c.material.alpha_mode == AlphaMode::opaque)
                                c.material.alpha_mode = AlphaMode::blend;
                        }});
    return keys;
}

std::vector<MaterialKey> general() {
    return {
        {{"color", Kind::color, "Its base color; of classical materials k_d, and k_a without `ambient`"},
         Of::all,
         set_color},
        {{"opacity", Kind::number, "Opacity; below 1 the material is blended", from_0_to_1}, Of::all, set_opacity},
        {{"emission", Kind::color, "Emitted light"}, Of::all, [](C& c) { c.material.emission = c.color(); }},
        {{"unlit", Kind::flag, "Unlit: its color alone"},
         Of::all,
         [](C& c) {
             if (c.is_on()) c.material.model = MaterialModel::unlit;
         }},
        {{"alpha", Kind::word, "How opacity acts", any_number, names_of<AlphaMode>(alpha_words)},
         Of::all,
         [](C& c) { c.material.alpha_mode = value_of(alpha_words, c.word()); }},
        {{"alpha_cutoff", Kind::number, "mask: less is not drawn (default 0.5)", from_0_to_1},
         Of::all,
         [](C& c) { c.material.alpha_cutoff = c.number(); }},
        {{"double_sided", Kind::flag, "Back faces are lit too"},
         Of::all,
         [](C& c) { c.material.double_sided = c.is_on(); }},
        {{"occlusion_strength", Kind::number, "Strength of the occlusion texture (default 1)", from_0_to_1},
         Of::all,
         [](C& c) { c.material.occlusion_strength = c.number(); }},
        {{"texture_scale", Kind::pair, "Repetitions of its textures", {-1e6, 1e6}},
         Of::all,
         [](C& c) {
             transform_textures(c, [](TextureTransform& t, const C& k) { t.scale = {k.number(0), k.number(1)}; });
         }},
        {{"texture_offset", Kind::pair, "Shift of its textures", {-1e6, 1e6}},
         Of::all,
         [](C& c) {
             transform_textures(c, [](TextureTransform& t, const C& k) { t.offset = {k.number(0), k.number(1)}; });
         }},
        {{"texture_rotation_deg", Kind::number, "Rotation of its textures", {-360, 360}},
         Of::all,
         [](C& c) {
             transform_textures(c, [](TextureTransform& t, const C& k) { t.rotation_rad = radians(k.number()); });
         }},
    };
}

std::vector<MaterialKey> classical() {
    return {
        {{"ambient", Kind::color, "classical: k_a"},
         Of::classical,
         [](C& c) { c.material.classical.ambient = c.color(); }},
        {{"specular", Kind::color, "classical: k_s"},
         Of::classical,
         [](C& c) {
             c.material.classical.specular = c.color();
             c.material.classical.is_normalized = false;  // a textbook k_s, also where another kind of material was
         }},
        {{"shininess", Kind::number, "classical: exponent", {1, 1e6}},
         Of::classical,
         [](C& c) { c.material.classical.shininess = c.number(); }},
        {{"mirror", Kind::word, "classical: how much of the environment specular reflects; engine trace", any_number,
          names_of<Mirror>(mirror_words)},
         Of::classical,
         [](C& c) { c.material.classical.mirror = value_of(mirror_words, c.word()); }},
        {{"transmission_color", Kind::color, "classical: k_t, the light transmitted; engine trace"},
         Of::classical,
         [](C& c) { c.material.classical.transmission = c.color(); }},
        {{"refraction_index",
          Kind::number,
          "classical: index of refraction of a solid body; without it a thin wall",
          {0.1, 100}},
         Of::classical,
         [](C& c) { c.material.classical.refraction_index = c.number(); }},
    };
}

std::vector<MaterialKey> metallic_roughness() {
    std::vector<MaterialKey> keys;
    for (const MaterialParameter& p : metallic_roughness_parameters()) {
        if (p.color)
            keys.push_back({{p.key, Kind::color, p.help}, Of::metallic_roughness, [&p](C& c) {
                                c.material.metallic_roughness.*p.color = c.color();
                            }});
        else
            keys.push_back({{p.key, Kind::number, p.help, {p.low, p.high}}, Of::metallic_roughness, [&p](C& c) {
                                const bool is_angle = p.kind == MaterialParameter::Kind::angle;
                                c.material.metallic_roughness.*p.number = is_angle ? radians(c.number()) : c.number();
                            }});
    }
    return keys;
}

std::vector<MaterialKey> lighting() {
    return {
        {{"lighting", Kind::word, "Its lighting model; overrides lighting of [render]", any_number,
          names_of<Lighting>(lighting_words)},
         Of::all,
         [](C& c) { c.material.lighting = value_of(lighting_words, c.word()); }},
        {{"specular_form", Kind::word, "As specular of [render]", any_number,
          names_of<SpecularForm>(specular_form_words)},
         Of::all,
         [](C& c) { c.material.specular_form = value_of(specular_form_words, c.word()); }},
        {{"ward_form", Kind::word, "As ward-form of [render]", any_number, names_of<WardForm>(ward_form_words)},
         Of::all,
         [](C& c) { c.material.ward_form = value_of(ward_form_words, c.word()); }},
        {{"ward_alpha", Kind::pair, "Ward: widths along tangent and bitangent", {0.001, 10}},
         Of::all,
         [](C& c) {
             c.material.ward_alpha = vec2{c.number(0), c.number(1)};
         }},
        {{"sigma_deg", Kind::number, "Oren-Nayar: roughness of its facets", {0, 90}},
         Of::all,
         [](C& c) { c.material.sigma_rad = radians(c.number()); }},
        {{"shading", Kind::word, "How often its lighting is evaluated; overrides its model's and that of [render]",
          any_number, names_of<Shading>(shading_words)},
         Of::all,
         [](C& c) { c.material.shading = value_of(shading_words, c.word()); }},
    };
}

std::vector<MaterialKey> bumps() {
    return {
        {{"bump", Kind::word, "As bump of [render]", any_number, names_of<Bump>(bump_words)},
         Of::all,
         [](C& c) { c.material.bump = value_of(bump_words, c.word()); }},
        {{"bump_terms", Kind::word, "As bump-terms of [render]", any_number, names_of<BumpTerms>(bump_terms_words)},
         Of::all,
         [](C& c) { c.material.bump_terms = value_of(bump_terms_words, c.word()); }},
        {{"bump_depth", Kind::number, "As bump-depth of [render]", {0, 10}},
         Of::all,
         [](C& c) { relief(c).depth = c.number(); }},
        {{"bump_bias", Kind::number, "As bump-bias of [render]", from_0_to_1},
         Of::all,
         [](C& c) { relief(c).bias = c.number(); }},
        {{"bump_polarity", Kind::word, "As bump-polarity of [render]", any_number, names_of<bool>(polarity_words)},
         Of::all,
         [](C& c) { relief(c).holds_depth = value_of(polarity_words, c.word()); }},
        {{"bump_steps", Kind::integers, "As bump-steps of [render]", {1, 1024}},
         Of::all,
         [](C& c) { relief(c).min_steps = int(c.number(0)), relief(c).max_steps = int(c.number(1)); }},
        {{"bump_refinement", Kind::integer, "As bump-refinement of [render]", {0, 32}},
         Of::all,
         [](C& c) { relief(c).refinement_steps = int(c.number()); }},
        {{"bump_self_shadow", Kind::flag, "As bump-self-shadow of [render]"},
         Of::all,
         [](C& c) { relief(c).self_shadow = c.is_on(); }},
        {{"bump_silhouette", Kind::flag, "As bump-silhouette of [render]"},
         Of::all,
         [](C& c) { relief(c).limit_silhouette = c.is_on(); }},
        {{"normal_scale", Kind::number, "Strength of the normal map (default 1)", {-100, 100}},
         Of::all,
         [](C& c) { c.material.normal_scale = c.number(); }},
        {{"normal_green", Kind::word, "As normal-map-green of [render]", any_number, names_of<bool>(green_words)},
         Of::all,
         [](C& c) { c.material.green_down = value_of(green_words, c.word()); }},
        {{"normal_zero", Kind::word, "As normal-map-zero of [render]", any_number, names_of<bool>(zero_words)},
         Of::all,
         [](C& c) { c.material.centered_normals = value_of(zero_words, c.word()); }},
        {{"height_scale", Kind::number, "Factor on the depth of the height map (default 1)", {-100, 100}},
         Of::all,
         [](C& c) { c.material.height_scale = c.number(); }},
    };
}

}  // namespace

const std::vector<MaterialKey>& material_setters() {
    static const std::vector<MaterialKey> all = [] {
        std::vector<MaterialKey> keys;
        // Pictures first: texture_scale and the like act on them. Color before ambient.
        for (std::vector<MaterialKey> (*part)() : {pictures, general, classical, metallic_roughness, lighting, bumps})
            for (MaterialKey& key : part()) keys.push_back(std::move(key));
        return keys;
    }();
    return all;
}

const MaterialKey* find_material_key(std::string_view name) {
    for (const MaterialKey& key : material_setters())
        if (name == key.key.name) return &key;
    return nullptr;
}

std::vector<WorldKey> material_keys() {
    std::vector<WorldKey> keys = {
        {"name", Kind::text, "Of the material; '*': all of `model`", any_number, {}, true},
        {"model", Kind::text, "Name of a [[model]] or [[primitive]]: only its materials (default: all)"},
        {"object", Kind::text,
         "Name of an object of the model, or the number of its node there: only its materials (default: those of "
         "all)"}};
    for (const MaterialKey& key : material_setters()) keys.push_back(key.key);
    return keys;
}

}  // namespace rakelight::io::world
