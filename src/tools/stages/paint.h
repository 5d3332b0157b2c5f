// SPDX-License-Identifier: Apache-2.0
// Pictures of the rendered one's size, and light as display codes.
#pragma once
#include <string>

#include "tools/material_names.h"
#include "tools/stages/stage.h"

namespace rakelight::stages {

inline constexpr Code backdrop{16, 18, 24};  ///< where nothing is

/// @param color  Code of a pixel's number, row by row
Canvas paint(const Sources& of, const auto& color) {
    Canvas canvas(of.engine.settings().width, of.engine.settings().height, backdrop);
    std::size_t p = 0;
    for (int y = 0; y < canvas.height(); ++y)
        for (int x = 0; x < canvas.width(); ++x) canvas.set(x, y, color(p++));
    return canvas;
}

/// "0 (point, lamp)".
inline std::string number_and_name(const Light& light, std::size_t i) {
    return std::to_string(i) + " (" + name_of(light.type) + (light.name.empty() ? "" : ", " + light.name) + ")";
}

/// The code of a pixel as in the picture: with exposure and tone curve, over the background.
inline Code displayed_code(const Sources& of, vec4 pixel) { return code_of_light(of.curve.displayed(pixel).xyz()); }
/// Light likewise.
inline Code displayed_code(const Sources& of, vec3 light) { return code_of_light(of.curve(light)); }
/// With the exposure only, clamped: such terms add up.
inline Code exposed(const Sources& of, vec3 light) { return code_of_light(of.exposure(light)); }

}  // namespace rakelight::stages
