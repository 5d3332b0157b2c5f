// SPDX-License-Identifier: Apache-2.0
#include "scene_options.h"

#include "option_table.h"

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

void add_values(const SceneWords& words, std::vector<WorldValue>& values) {
    add_values<W>(table, words, values);
    if (!words.lights.empty()) values.push_back({.key = "light", .words = words.lights});
    if (!words.material_keys.empty()) values.push_back({.key = "material", .words = words.material_keys});
}

}  // namespace rakelight::cli
