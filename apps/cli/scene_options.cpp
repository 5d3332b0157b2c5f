// SPDX-License-Identifier: Apache-2.0
#include "scene_options.h"

#include <algorithm>

#include "option_table.h"
#include "values.h"

namespace rakelight::cli {
namespace {

using W = SceneWords;
constexpr const char *materials = "Materials", *light_group = "Light", *output = "Output";

constexpr OptionEntry<W> table[] = {
    {materials, "--color", &W::color, "COLOR",
     "Color of all materials, r,g,b or '#rrggbb' as seen; textures are multiplied by it"},
    {materials, "--opacity", &W::opacity, "A", "Opacity of all materials, 0 to 1; below 1 they are blended"},
    {materials, "--roughness", &W::roughness, "R", "Roughness of all materials, 0 to 1"},
    {materials, "--metallic", &W::metallic, "M", "How metallic all materials are, 0 to 1"},
    {materials, "--texture-base-color", &W::texture_base_color, "FILE", "Picture for the color of all materials"},
    {materials, "--texture-normal", &W::texture_normal, "FILE", "Normal map for all materials"},
    {materials, "--height-map", &W::height_map, "FILE", "Gray height map for all materials, see --bump"},
    {materials, "--normal-scale", &W::normal_scale, "S", "How strongly normal maps bump (default: the material's, 1)"},
    {materials, "--normal-map-green", &W::normal_map_green, "up|down",
     "Where the green of normal maps points (default: the material's, up)"},
    {materials, "--normal-map-zero", &W::normal_map_zero, "127.5|128",
     "The byte of normal maps that means 0 (default: the material's, 127.5)"},
    {light_group, "--light-intensity", &W::light_intensity, "F", "Multiplies every light (default 1)"},
    {light_group, "--light-cutoff", &W::light_cutoff, "VALUE",
     "Lights without a range end where less is left of them, 0 to 1 (default 0: nowhere)"},
    {light_group, "--fog", &W::fog, "SPEC",
     "none, linear:START,END, exp:DENSITY or exp2:DENSITY; then :color=COLOR, as seen on a display"},
    {light_group, "--hdri-file", &W::hdri_file, "FILE",
     "Picture of the surroundings, equirectangular (default: a built-in studio)"},
    {light_group, "--hdri-ambient", &W::hdri_ambient, switch_type, "The surroundings give light"},
    {light_group, "--hdri-skybox", &W::hdri_skybox, switch_type, "The surroundings are the background"},
    {light_group, "--hdri-intensity", &W::hdri_intensity, "F", "Multiplies the light of the surroundings (default 1)"},
    {light_group, "--hdri-rotation", &W::hdri_rotation, "DEG", "Turns the surroundings about +Y (default 0)"},
    {output, "--tone-mapping", &W::tone_mapping, "CURVE",
     "Of 8-bit pictures: none (default: cut off at 1), reinhard, neutral, aces, agx"},
    {output, "--exposure", &W::exposure, "EV", "Light is multiplied by 2^EV first, -30 to 30 (default 0)"},
};

void apply_materials(const W& w, MaterialOverrides& m) {
    m.base_color = w.texture_base_color;
    m.normal = w.texture_normal;
    m.height = w.height_map;
    if (!w.normal_scale.empty()) m.normal_scale = number("--normal-scale", w.normal_scale, -100, 100);
    if (!w.normal_map_green.empty()) m.green_down = word("--normal-map-green", w.normal_map_green, green_words);
    if (!w.normal_map_zero.empty()) m.centered_normals = word("--normal-map-zero", w.normal_map_zero, zero_words);
    if (!w.color.empty()) m.color = display_color("--color", w.color).xyz();
    if (!w.opacity.empty()) m.opacity = number("--opacity", w.opacity, 0, 1);
    if (!w.roughness.empty()) m.roughness = number("--roughness", w.roughness, 0, 1);
    if (!w.metallic.empty()) m.metallic = number("--metallic", w.metallic, 0, 1);
}

void apply_keys(const W& w, MaterialOverrides& m) {
    try {
        m.values = material_values(w.material_keys);
    } catch (const Error& error) {
        throw Error(error.code(), "--material: " + error.reason(), {}, error.advice());
    }
}

void apply_lights(const W& w, PictureRequest& request) {
    if (!w.light_intensity.empty())
        request.light_intensity = number("--light-intensity", w.light_intensity, 0, 1'000'000);
    if (!w.light_cutoff.empty()) request.light_cutoff = number("--light-cutoff", w.light_cutoff, 0, 1);
    if (w.lights.empty()) return;
    if (w.lights.size() == 1 && w.lights[0] == "default") {
        request.default_lights = true;
        return;
    }
    if (std::find(w.lights.begin(), w.lights.end(), "default") != w.lights.end())
        throw Error(ErrorCode::usage, "--light default stands alone");
    request.lights.emplace();
    for (const std::string& text : w.lights) request.lights->push_back(light("--light", text));
}

void apply_surroundings(const W& w, PictureRequest& request) {
    if (!w.fog.empty()) request.fog = fog("--fog", w.fog);
    request.hdri_file = w.hdri_file;
    if (!w.hdri_ambient.empty()) request.hdri_ambient = switched("--hdri-ambient", w.hdri_ambient);
    if (!w.hdri_skybox.empty()) request.hdri_skybox = switched("--hdri-skybox", w.hdri_skybox);
    if (!w.hdri_intensity.empty()) request.hdri_intensity = number("--hdri-intensity", w.hdri_intensity, 0, 1e6);
    if (!w.hdri_rotation.empty())
        request.hdri_rotation_rad = radians(number("--hdri-rotation", w.hdri_rotation, -360, 360));
    if (!w.tone_mapping.empty()) request.tone.mapping = word("--tone-mapping", w.tone_mapping, tone_mapping_words);
    if (!w.exposure.empty()) request.tone.exposure_ev = number("--exposure", w.exposure, -30, 30);
}

}  // namespace

void add_scene_options(CLI::App& app, SceneWords& words) {
    add_table<W>(app, table, words);
    app.add_option("--light", words.lights, "A light instead of the model's; may be repeated, see below")
        ->type_name("SPEC")
        ->group(light_group)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--material", words.material_keys,
                   "A key of [[material]] in world files for all materials, as clearcoat=1; may be repeated")
        ->type_name("KEY=VALUE")
        ->group(materials)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void apply(const SceneWords& words, PictureRequest& request) {
    apply_materials(words, request.materials);
    apply_keys(words, request.materials);
    apply_lights(words, request);
    apply_surroundings(words, request);
}

}  // namespace rakelight::cli
