// SPDX-License-Identifier: Apache-2.0
// Pictures and factors from the command line in the place of the materials' own.
#include <algorithm>
#include <map>

#include <rakelight/material_changes.h>
#include <rakelight/request.h>

#include "io/file.h"
#include "io/image_io.h"
#include "io/world/material_keys.h"
#include "scene/scene_tools.h"
#include "world/change_material.h"
#include "world/scene_of_request.h"

namespace rakelight {
namespace {

/// Adds a picture file as a repeating texture and returns its use.
TextureUse add_texture(Scene& scene, const std::string& path, Context& context) {
    try {  // what the caller asked for must not be left out silently; the engine decodes it again when it needs it
        const io::Bytes bytes = io::read_file(path, context);
        io::decode_image(*bytes, context);
    } catch (const Error& error) {
        throw error.with_file(path);
    }
    scene.textures.push_back({path, io::image_from_file(path, path, path), {}});
    TextureUse use;
    use.texture = std::uint32_t(scene.textures.size() - 1);
    return use;
}

/// Base color as it is, not metallic. A classical material without a highlight (k_s = 0: many have never been given
/// one) becomes an ordinary dielectric: who asks for a roughness is to see it.
Material as_metallic_roughness(const Material& m) {
    Material out = metallic_roughness_from_classical(m);
    if (m.model == MaterialModel::classical && out.metallic_roughness.specular == 0)
        out.metallic_roughness.specular = 1, out.metallic_roughness.specular_color = {1, 1, 1};
    return out;
}

/// The factors of metallic-roughness materials, and those of every kind.
void set_factors(Material& m, const MaterialOverrides& o) {
    if (o.roughness || o.metallic) m = as_metallic_roughness(m);
    if (o.roughness) m.metallic_roughness.roughness = float(*o.roughness);
    if (o.metallic) m.metallic_roughness.metallic = float(*o.metallic);
    if (o.color) {
        m.base_color = {o.color->x, o.color->y, o.color->z, m.base_color.w};
        m.classical.ambient = *o.color;  // as loaders have it where a file gives no k_a
    }
    if (!o.opacity) return;
    m.base_color.w = float(*o.opacity);
    if (*o.opacity < 1) m.alpha_mode = AlphaMode::blend;
}

/// The values as their words say, with the checks of a command line's: a caller may have made them otherwise.
std::vector<WorldValue> checked(const std::vector<WorldValue>& values) {
    std::vector<std::string> words;
    for (const WorldValue& value : values) {
        std::string& text = words.emplace_back(value.key + "=");
        for (std::size_t i = 0; i < value.words.size(); ++i) text += (i ? "," : "") + value.words[i];
    }
    return material_values(words);
}

/// Calls change(material, picture) for all materials; a picture that several name becomes one texture.
template <class Change>
void for_each_material(Scene& scene, Context& context, const Change& change) {
    std::map<std::string, TextureUse> pictures;
    const auto picture = [&](const WorldValue& value) {
        const auto known = pictures.find(value.words[0]);
        if (known != pictures.end()) return known->second;
        return pictures.emplace(value.words[0], add_texture(scene, value.words[0], context)).first->second;
    };
    for (Material& m : scene.materials) change(m, picture);
}

/// The keys of a world file's [[material]]. Classical materials under keys of metallic-roughness ones show a highlight.
void set_values(Scene& scene, const std::vector<WorldValue>& values, Context& context) {
    if (values.empty()) return;
    const bool is_metallic_roughness = std::any_of(values.begin(), values.end(), [](const WorldValue& value) {
        return io::world::find_material_key(value.key)->of == io::world::Of::metallic_roughness;
    });
    for_each_material(scene, context, [&](Material& m, const auto& picture) {
        if (is_metallic_roughness && m.model == MaterialModel::classical) m = as_metallic_roughness(m);
        change_material(m, values, picture);
    });
}

}  // namespace

Scene override_materials(const Scene& scene, const MaterialOverrides& overrides, Context& context) {
    validate(scene);
    Scene changed = valid::override_materials(scene, overrides, context);
    validate_changes(changed, scene);  // a factor may be no number
    return changed;
}

Scene with_material_values(Scene scene, const std::string& name, const std::vector<WorldValue>& values,
                           Context& context) {
    validate(scene);
    const Scene before = scene;
    name_default_material(scene);
    const std::vector<WorldValue> as_said = checked(values);
    for_each_material(scene, context, [&](Material& m, const auto& picture) {
        if (m.name == name) change_material(m, as_said, picture);
    });
    validate_changes(scene, before);
    return scene;
}

Scene valid::override_materials(Scene scene, const MaterialOverrides& overrides, Context& context) {
    if (overrides == MaterialOverrides{}) return scene;
    name_default_material(scene);
    set_values(scene, checked(overrides.values), context);
    TextureUse base_color, normal, height;
    if (!overrides.base_color.empty()) base_color = add_texture(scene, overrides.base_color, context);
    if (!overrides.normal.empty()) normal = add_texture(scene, overrides.normal, context);
    if (!overrides.height.empty()) height = add_texture(scene, overrides.height, context);
    for (Material& m : scene.materials) {
        if (base_color) m.base_color_texture = base_color;
        if (normal) m.normal_texture = normal;
        if (height) m.height_texture = height, m.height_scale = 1;
        if (overrides.normal_scale) m.normal_scale = float(*overrides.normal_scale);
        if (overrides.green_down) m.green_down = *overrides.green_down;
        if (overrides.centered_normals) m.centered_normals = *overrides.centered_normals;
        set_factors(m, overrides);
    }
    return scene;
}

}  // namespace rakelight
