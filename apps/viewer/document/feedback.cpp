// SPDX-License-Identifier: Apache-2.0
#include "feedback.h"

#include <cstdio>

#include <rakelight/scene/words.h>

namespace rakelight::viewer {
namespace {

template <class T, std::size_t n>
std::string word_of(const Word<T> (&words)[n], T value) {
    for (const Word<T>& word : words)
        if (word.value == value) return word.name;
    return "auto";
}

std::string on_off(const char* what, bool is_on) { return std::string(what) + (is_on ? ": on" : ": off"); }

std::string effect_on_view(Command command, const Look& look, const Model& model) {
    if (command == Command::up_axis)
        return "up axis: " + std::string(look.world_up.x == 1 ? "+X" : look.world_up.y == 1 ? "+Y" : "+Z");
    if (command == Command::orthographic)
        return look.eye && look.eye->is_orthographic ? "orthographic projection" : "perspective projection";
    if (command != Command::next_camera) return {};
    const std::optional<std::size_t> camera = current_camera(look, model);
    return camera ? "camera: " + model.box.cameras()[*camera] : "the file has no cameras";
}

std::string environment_effect(Command command, const PictureRequest& r) {
    return command == Command::environment_light ? on_off("light from the environment", r.hdri_ambient.value_or(false))
                                                 : on_off("environment as background", r.hdri_skybox.value_or(false));
}

}  // namespace

std::string effect_of(Command command, const Look& look, const Model& model) {
    const PictureRequest& r = look.request;
    const RenderSettings& s = r.settings;
    switch (command) {
        case Command::shading:
            return "shading: " + word_of(shading_words, s.shading);
        case Command::lighting:
            return "lighting: " + word_of(lighting_words, s.lighting);
        case Command::bump:
            return "bump: " + word_of(bump_words, s.bump);
        case Command::tone:
            return "tone mapping: " + word_of(tone_mapping_words, r.tone.mapping);
        case Command::samples:
            return "samples: " + std::to_string(s.samples);
        case Command::engine:
            return "engine: " + r.engine +
                   (s.method == RayMethod::path        ? ", paths"
                    : s.method == RayMethod::radiosity ? ", radiosity"
                                                       : "");
        case Command::shadows:
            return on_off("shadows", s.shadows);
        case Command::edges:
            return on_off("edges", s.edges);
        case Command::wireframe:
            return on_off("wireframe", !s.surfaces);
        case Command::points:
            return on_off("vertices", s.points != PointShape::none);
        case Command::environment_light:
        case Command::environment_background:
            return environment_effect(command, r);
        case Command::brighter:
        case Command::darker: {
            char text[40];
            std::snprintf(text, sizeof text, "lights times %.2f", r.light_intensity);
            return text;
        }
        default:
            return effect_on_view(command, look, model);
    }
}

}  // namespace rakelight::viewer
