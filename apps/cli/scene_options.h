// SPDX-License-Identifier: Apache-2.0
// Options that change what is drawn: materials, lights, fog, environment; and how light becomes display values.
#pragma once
#include <string>
#include <vector>

#include <rakelight/world.h>

namespace CLI {
class App;
}

namespace rakelight::cli {

/// The words as given; empty where not given.
struct SceneWords {
    std::string texture_base_color, texture_normal, height_map, normal_scale, normal_map_green, normal_map_zero;
    std::string color, opacity, roughness, metallic;
    std::string light_intensity, light_cutoff, fog, hdri_file, hdri_ambient, hdri_skybox, hdri_intensity, hdri_rotation,
        tone_mapping, exposure;
    std::vector<std::string> lights, material_keys;
};

/// Declares the options with their help. `words` must live until the command line is read.
void add_scene_options(CLI::App& app, SceneWords& words);

/// What was given, by keys of [render].
void add_values(const SceneWords& words, std::vector<WorldValue>& values);

}  // namespace rakelight::cli
