// SPDX-License-Identifier: Apache-2.0
// Pictures of the rendered one's size, and light as it is shown.
#pragma once
#include <string>

#include "tools/stages/stage.h"
#include "tools/texture_uses.h"

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

/// A pixel as the picture has it: with its exposure and tone curve, before what lies behind.
inline Code shown(const Sources& of, vec4 pixel) { return code_of_light(of.curve.displayed(pixel).xyz()); }
/// Light likewise.
inline Code shown(const Sources& of, vec3 light) { return code_of_light(of.curve(light)); }
/// With the exposure alone, clamped: terms that are shown so add up.
inline Code exposed(const Sources& of, vec3 light) { return code_of_light(of.exposure(light)); }

}  // namespace rakelight::stages
