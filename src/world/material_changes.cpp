// SPDX-License-Identifier: Apache-2.0
// Overrides pictures and factors of materials.
#include <algorithm>
#include <functional>
#include <map>

#include <rakelight/io/world_words.h>
#include <rakelight/scene/validate.h>
#include <rakelight/world/material_changes.h>
#include <rakelight/world/request.h>

#include "base/format_text.h"
#include "io/files/file.h"
#include "io/pictures/image_io.h"
#include "io/world/material_keys.h"
#include "scene/charge_arrays.h"
#include "scene/materials/texture_uses.h"
#include "scene/validate.h"
#include "world/change_material.h"
#include "world/own_materials.h"
#include "world/scene_of_request.h"

namespace rakelight {
namespace {

/// Adds a picture file as a repeating texture and returns its use.
TextureUse add_texture(Scene& scene, const std::string& path, Context& context) {
    try {  // requested pictures must not be ignored silently; the engine decodes them again
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

/// The factors of metallic-roughness materials, and those of every kind.
void set_factors(Material& m, const MaterialOverrides& o) {
    if (o.roughness || o.metallic) m = as_metallic_roughness(m);
    if (o.roughness) m.metallic_roughness.roughness = float(*o.roughness);
    if (o.metallic) m.metallic_roughness.metallic = float(*o.metallic);
    if (o.color) {
        m.base_color = {o.color->x, o.color->y, o.color->z, m.base_color.w};
        m.classical.ambient = *o.color;  // as loaders do for files without k_a
    }
    if (!o.opacity) return;
    m.base_color.w = float(*o.opacity);
    if (*o.opacity < 1) m.alpha_mode = AlphaMode::blend;
}

/// Re-parses the words of values, because a caller may have created inconsistent ones.
std::vector<WorldValue> checked(const std::vector<WorldValue>& values) {
    std::vector<std::string> words;
    for (const WorldValue& value : values) {
        std::string& text = words.emplace_back(value.key + "=");
        for (std::size_t i = 0; i < value.words.size(); ++i) text += (i ? "," : "") + value.words[i];
    }
    return material_values(words);
}

/// Textures by picture name, each created once.
class Pictures {
public:
    Pictures(Scene& scene, Context& context) : scene_(scene), context_(context) {}
    TextureUse operator()(const WorldValue& value) {
        const auto known = uses_.find(value.words[0]);
        if (known != uses_.end()) return known->second;
        return uses_.emplace(value.words[0], add_texture(scene_, value.words[0], context_)).first->second;
    }

private:
    Scene& scene_;
    Context& context_;
    std::map<std::string, TextureUse> uses_;
};

/// The keys of a world file's [[material]].
void set_values(Scene& scene, const std::vector<WorldValue>& values, Context& context) {
    if (values.empty()) return;
    Pictures pictures(scene, context);
    for (Material& m : scene.materials) change_material(m, values, std::ref(pictures));
}

}  // namespace

Scene override_materials(const Scene& scene, const MaterialOverrides& overrides, Context& context) {
    validate(scene);
    Scene changed = valid::override_materials(scene, overrides, context);
    validate_changes(changed, scene);  // a factor may be no number
    return changed;
}

Scene with_material_changes(Scene scene, std::span<const MaterialChanges> changes, Context& context) {
    validate(scene);
    const Scene before = charged_copy(scene, context);
    name_default_material(scene);
    Pictures pictures(scene, context);
    for (const MaterialChanges& change : changes) {
        if (change.target.node != no_index) continue;
        const std::vector<WorldValue> values = checked(change.values);
        for (Material& m : scene.materials)
            if (change.target.name == "*" || m.name == change.target.name)
                change_material(m, values, std::ref(pictures));
    }
    OwnMaterials own(scene, context);
    for (const MaterialChanges& change : changes) {
        if (change.target.node == no_index) continue;
        if (change.target.node >= scene.nodes.size())
            throw Error(ErrorCode::usage, format_text("there is no node {}", change.target.node));
        const std::vector<WorldValue> values = checked(change.values);
        for (const std::uint32_t m : own.of(change.target.node, change.target.name))
            change_material(scene.materials[m], values, std::ref(pictures));
    }
    own.finish();
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
