// SPDX-License-Identifier: Apache-2.0
// Parses colors and fog.
#include <rakelight/world/values.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "math/color.h"
#include "math/color_names.h"

namespace rakelight::values {
namespace {

/// By name or code; the '#' of a code is optional.
std::optional<std::array<std::uint8_t, 3>> codes_of(std::string_view text) {
    if (const auto codes = color_by_text(text)) return codes;
    return text.starts_with('#') ? std::nullopt : color_by_text("#" + std::string(text));
}

}  // namespace

vec4 background(const std::string& option, std::string_view text) {
    if (same_word(text, "transparent")) return {0, 0, 0, 0};
    return display_color(option, text, "write r,g,b from 0 to 1, '#rrggbb', a name such as white, or transparent");
}

vec4 display_color(const std::string& option, std::string_view text, const char* advice) {
    dvec3 display;
    if (const auto codes = codes_of(text)) {
        for (std::size_t i = 0; i < 3; ++i) display[i] = (*codes)[i] / 255.0;
    } else if (text.find(',') != std::string_view::npos) {
        display = vector3(option, text);
    } else {
        const std::string nearest = nearest_word(text, color_names());
        throw wrong(option, "'" + one_line(std::string(text), 40) + "' is not a color",
                    (nearest.empty() ? "" : "did you mean " + nearest + "? ") + advice);
    }
    for (std::size_t i = 0; i < 3; ++i)
        if (display[i] < 0 || display[i] > 1) throw wrong(option, "the color's parts must be from 0 to 1");
    const vec3 c = linear_from_srgb(vec3{float(display.x), float(display.y), float(display.z)});
    return {c.x, c.y, c.z, 1};
}

vec3 light_color(const std::string& option, std::string_view text) {
    if (text.find(',') == text.npos && !is_number(text)) return display_color(option, text).xyz();
    const dvec3 c = vector3(option, text);
    if (c.x < 0 || c.y < 0 || c.z < 0) throw wrong(option, "a color must not be negative");
    if (std::max({c.x, c.y, c.z}) > double(std::numeric_limits<float>::max()))
        throw wrong(option, "'" + one_line(std::string(text), 60) + "' is more than 3.4e38");
    return {float(c.x), float(c.y), float(c.z)};
}

Fog fog(const std::string& option, std::string_view text) {
    const std::vector<std::string_view> parts = split(text, ':');
    Fog fog;
    fog.kind = word<FogKind>(option, parts[0],
                             {{"none", FogKind::none},
                              {"linear", FogKind::linear},
                              {"exp", FogKind::exponential},
                              {"exp2", FogKind::exponential_squared}});
    const bool is_none = fog.kind == FogKind::none;
    if (is_none != (parts.size() == 1) || parts.size() > 3 || (parts.size() == 3 && !parts[2].starts_with("color=")))
        throw wrong(option, "'" + one_line(std::string(text), 60) + "' is not a fog",
                    "write for example linear:2,30 or exp:0.1:color=#c0c8d0 or none");
    if (is_none) return fog;
    if (fog.kind == FogKind::linear) {
        const std::vector<double> ends = numbers(option, parts[1], 2);
        if (!(ends[0] >= 0 && ends[1] > ends[0] && ends[1] <= 1e30))
            throw wrong(option, "the start must be 0 or more, and the end behind it");
        fog.start = float(ends[0]), fog.end = float(ends[1]);
    } else {
        fog.density = float(number(option, parts[1], 0, 1e6));
    }
    if (parts.size() == 3) fog.color = display_color(option, parts[2].substr(6)).xyz();
    return fog;
}

}  // namespace rakelight::values
