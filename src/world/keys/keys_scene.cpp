// SPDX-License-Identifier: Apache-2.0
// Keys of materials, lights, environment and tone.
#include <algorithm>

#include <rakelight/io/world_words.h>

#include "world/keys/key_fields.h"

namespace rakelight::keys {
namespace {

void read_lights(PictureRequest& r, Words w) {
    const auto has = [&](const char* word) {
        return std::ranges::any_of(w, [&](const std::string& text) { return same_word(text, word); });
    };
    r.default_lights = w.size() == 1 && has("default");
    r.studio_lights = w.size() == 1 && has("studio");
    r.lights.reset();
    if (r.default_lights || r.studio_lights) return;
    for (const char* const word : {"none", "default", "studio"})
        if (has(word) && w.size() > 1) throw values::wrong("light", std::string(word) + " stands alone");
    r.lights.emplace();
    if (has("none")) return;
    for (const std::string& text : w) r.lights->push_back(values::light("light", text));
}

Written write_lights(const PictureRequest& r) {
    if (r.default_lights) return {"default"};
    if (r.studio_lights) return {"studio"};
    if (r.lights && r.lights->empty()) return {"none"};
    Written all;
    if (r.lights)
        for (const Light& light : *r.lights) all.push_back(text_of(light));
    return all;
}

void read_material(PictureRequest& r, Words w) {
    try {
        r.materials.values = material_values(w);
    } catch (const Error& error) {
        throw error.about("material");
    }
}

Written write_material(const PictureRequest& r) {
    Written all;
    for (const WorldValue& value : r.materials.values) {
        std::string text = value.key + "=";
        for (std::size_t i = 0; i < value.words.size(); ++i) text += (i > 0 ? "," : "") + value.words[i];
        all.push_back(text);
    }
    return all;
}

constexpr Word<Look> look_words[] = {{"plain", Look::plain}, {"default", Look::standard}};

constexpr RenderKey table_of_scene[] = {
    RL_WORD_KEY("look", r.look, look_words),
    RL_KEY("color", value, r.materials.color, values::display_color("color", w[0]).xyz(),
           {color_of(*r.materials.color)}),
    RL_KEY("opacity", value, r.materials.opacity, values::number("opacity", w[0], 0, 1),
           {text_of(*r.materials.opacity)}),
    RL_KEY("roughness", value, r.materials.roughness, values::number("roughness", w[0], 0, 1),
           {text_of(*r.materials.roughness)}),
    RL_KEY("metallic", value, r.materials.metallic, values::number("metallic", w[0], 0, 1),
           {text_of(*r.materials.metallic)}),
    RL_KEY("texture-base-color", file, r.materials.base_color, w[0], {r.materials.base_color}),
    RL_KEY("texture-normal", file, r.materials.normal, w[0], {r.materials.normal}),
    RL_KEY("height-map", file, r.materials.height, w[0], {r.materials.height}),
    RL_KEY("normal-scale", value, r.materials.normal_scale, values::number("normal-scale", w[0], -100, 100),
           {text_of(*r.materials.normal_scale)}),
    RL_KEY("normal-map-green", value, r.materials.green_down, values::word("normal-map-green", w[0], green_words),
           (name_in(green_words, *r.materials.green_down))),
    RL_KEY("normal-map-zero", value, r.materials.centered_normals, values::word("normal-map-zero", w[0], zero_words),
           (name_in(zero_words, *r.materials.centered_normals))),
    {"material", Kind::list, read_material, write_material},
    RL_NUMBER_KEY("light-intensity", r.light_intensity, 0, 1'000'000),
    RL_NUMBER_KEY("light-cutoff", r.light_cutoff, 0, 1),
    {"light", Kind::list, read_lights, write_lights},
    RL_KEY("fog", value, r.fog, values::fog("fog", w[0]), {text_of(*r.fog)}),
    RL_KEY("hdri-file", file, r.hdri_file, w[0], {r.hdri_file}),
    RL_KEY("hdri-ambient", on_off, r.hdri_ambient, values::on_off("hdri-ambient", w[0]), (on_or_off(*r.hdri_ambient))),
    RL_KEY("hdri-skybox", on_off, r.hdri_skybox, values::on_off("hdri-skybox", w[0]), (on_or_off(*r.hdri_skybox))),
    RL_KEY("hdri-intensity", value, r.hdri_intensity, values::number("hdri-intensity", w[0], 0, 1e6),
           {text_of(*r.hdri_intensity)}),
    RL_KEY("hdri-rotation", value, r.hdri_rotation_rad, radians(values::number("hdri-rotation", w[0], -360, 360)),
           {degrees_of(*r.hdri_rotation_rad)}),
    RL_WORD_KEY("tone-mapping", r.tone.mapping, tone_mapping_words),
    RL_KEY("exposure", value, r.tone.exposure_ev, values::number("exposure", w[0], -30, 30),
           {text_of(double(r.tone.exposure_ev))}),
};

}  // namespace

constinit const KeyTable scene_keys = table_of_scene;

}  // namespace rakelight::keys
