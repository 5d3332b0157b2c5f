// SPDX-License-Identifier: Apache-2.0
// Pictures from the command line in the place of the materials' own.
#include <algorithm>

#include <rakelight/picture.h>

#include "io/file.h"
#include "io/image_io.h"

namespace rakelight {
namespace {

/// Adds a picture file as a repeating texture and returns its use.
TextureUse add_texture(Scene& scene, const std::string& path, Context& context) {
    try {  // what the caller asked for must not be left out silently; the engine decodes it again when it needs it
        const io::Bytes bytes = io::read_file(path, context);
        io::decode_image(*bytes, context);
        context.memory().release(bytes->size());
    } catch (const Error& error) {
        throw error.with_file(path);
    }
    scene.textures.push_back({path, io::image_from_file(path, path, path), {}});
    TextureUse use;
    use.texture = std::uint32_t(scene.textures.size() - 1);
    return use;
}

/// Meshes without a material get the one that stands for "no material", so that it can be changed.
void name_default_material(Scene& scene) {
    const auto has_none = [](const Mesh& m) { return m.material == none; };
    if (std::none_of(scene.meshes.begin(), scene.meshes.end(), has_none)) return;
    scene.materials.emplace_back().name = "default";
    for (Mesh& mesh : scene.meshes)
        if (has_none(mesh)) mesh.material = std::uint32_t(scene.materials.size() - 1);
}

}  // namespace

Scene override_textures(const Scene& scene, const TextureOverrides& overrides, Context& context) {
    if (overrides.is_empty()) return scene;
    Scene changed = scene;
    name_default_material(changed);
    TextureUse base_color, normal;
    if (!overrides.base_color.empty()) base_color = add_texture(changed, overrides.base_color, context);
    if (!overrides.normal.empty()) normal = add_texture(changed, overrides.normal, context);
    for (Material& m : changed.materials) {
        if (base_color) m.base_color_texture = base_color;
        if (normal) m.normal_texture = normal;
        if (overrides.normal_scale) m.normal_scale = float(*overrides.normal_scale);
    }
    return changed;
}

}  // namespace rakelight
