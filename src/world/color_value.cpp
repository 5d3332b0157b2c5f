// SPDX-License-Identifier: Apache-2.0
// Colors, and fog that has one.
#include <rakelight/tools/values.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/color.h"

namespace rakelight::values {
namespace {

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

bool is_hex(std::string_view text) {
    return (text.size() == 3 || text.size() == 6) &&
           std::all_of(text.begin(), text.end(), [](char c) { return hex_digit(c) >= 0; });
}

}  // namespace

vec4 background(const std::string& option, std::string_view text) {
    if (text == "transparent") return {0, 0, 0, 0};
    return display_color(option, text, "write r,g,b from 0 to 1, '#rrggbb', or transparent");
}

vec4 display_color(const std::string& option, std::string_view text, const char* advice) {
    const std::string_view hex = text.starts_with('#') ? text.substr(1) : text;
    dvec3 display;
    if (is_hex(hex)) {
        const std::size_t digits = hex.size() / 3;
        for (std::size_t i = 0; i < 3; ++i)
            display[i] = (hex_digit(hex[i * digits]) * 16 + hex_digit(hex[i * digits + digits - 1])) / 255.0;
    } else if (text.find(',') != std::string_view::npos) {
        display = vector3(option, text);
    } else {
        throw wrong(option, "'" + one_line(std::string(text), 40) + "' is not a color", advice);
    }
    for (std::size_t i = 0; i < 3; ++i)
        if (display[i] < 0 || display[i] > 1) throw wrong(option, "the color's parts must be from 0 to 1");
    const vec3 c = linear_from_srgb(vec3{float(display.x), float(display.y), float(display.z)});
    return {c.x, c.y, c.z, 1};
}

vec3 light_color(const std::string& option, std::string_view text) {
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
