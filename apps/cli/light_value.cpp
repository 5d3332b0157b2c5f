// SPDX-License-Identifier: Apache-2.0
// --light and --background.
#include <algorithm>
#include <cmath>
#include <limits>

#include <rakelight/picture.h>

#include "values.h"

namespace rakelight::cli {
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

/// Three numbers that lights keep as floats.
dvec3 floats(const std::string& option, std::string_view text) {
    const dvec3 v = vector3(option, text);
    if (std::max({v.x, v.y, v.z}) > double(std::numeric_limits<float>::max()))
        throw Error(ErrorCode::usage, option + ": '" + one_line(std::string(text), 60) + "' is more than 3.4e38");
    return v;
}

vec3 color(const std::string& option, std::string_view text) {
    const dvec3 c = floats(option, text);
    if (c.x < 0 || c.y < 0 || c.z < 0) throw Error(ErrorCode::usage, option + ": a color must not be negative");
    return {float(c.x), float(c.y), float(c.z)};
}

dvec3 unit(const std::string& option, dvec3 d) {
    const double largest = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    if (largest == 0) throw Error(ErrorCode::usage, option + ": the direction must not be zero");
    d = {d.x / largest, d.y / largest, d.z / largest};  // first, so that the squares cannot overflow
    const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    return {d.x / length, d.y / length, d.z / length};
}

/// What may follow a kind of light, as advice.
const char* properties_of(LightType type) {
    switch (type) {
        case LightType::ambient: return "an ambient light has its color only: ambient:R,G,B";
        case LightType::directional: return "a directional light has color=, specular=";
        case LightType::point: return "a point light has color=, specular=, attenuation=";
        case LightType::spot: return "a spot light has color=, specular=, attenuation=, direction=, cutoff=, exponent=";
    }
    return "";
}

/// One "name=value" part of a light.
void set_property(const std::string& option, Light& light, std::string_view part) {
    const std::size_t equals = part.find('=');
    const std::string name(part.substr(0, equals));
    const std::string_view value = equals == std::string_view::npos ? std::string_view() : part.substr(equals + 1);
    const std::string what = option + " " + one_line(name, 20);
    const bool has_place = light.type == LightType::point || light.type == LightType::spot;
    if (name == "color" && light.type != LightType::ambient) {
        light.diffuse = light.specular = color(what, value);
    } else if (name == "specular" && light.type != LightType::ambient) {
        light.specular = color(what, value);
    } else if (name == "attenuation" && has_place) {
        const dvec3 a = floats(what, value);
        if (a.x < 0 || a.y < 0 || a.z < 0 || a == dvec3{0, 0, 0})
            throw Error(ErrorCode::usage, what + ": attenuation must be three numbers >= 0, not all 0");
        light.constant = float(a.x), light.linear = float(a.y), light.quadratic = float(a.z);
    } else if (name == "direction" && light.type == LightType::spot) {
        light.direction = vector3(what, value);
    } else if (name == "cutoff" && light.type == LightType::spot) {
        const double cutoff = number(what, value);
        if (!(cutoff > 0 && cutoff <= 90))
            throw Error(ErrorCode::usage, what + ": the half angle must be more than 0 and at most 90 degrees");
        light.cutoff_rad = float(radians(cutoff));
    } else if (name == "exponent" && light.type == LightType::spot) {
        const double exponent = number(what, value);
        if (!(exponent >= 0)) throw Error(ErrorCode::usage, what + ": must be >= 0");
        light.exponent = float(std::min(exponent, 1e9));
    } else {
        throw Error(ErrorCode::usage, option + ": this light has no '" + one_line(name, 40) + "'", {},
                    properties_of(light.type));
    }
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
        throw Error(ErrorCode::usage, option + ": '" + one_line(std::string(text), 40) + "' is not a color", {},
                    advice);
    }
    for (std::size_t i = 0; i < 3; ++i)
        if (display[i] < 0 || display[i] > 1)
            throw Error(ErrorCode::usage, option + ": the color's parts must be from 0 to 1");
    const vec3 c = linear_from_srgb(vec3{float(display.x), float(display.y), float(display.z)});
    return {c.x, c.y, c.z, 1};
}

Light light(const std::string& option, std::string_view text) {
    const std::vector<std::string_view> parts = split(text, ':');
    Light light;
    if (parts[0] == "default") throw Error(ErrorCode::usage, option + ": default stands alone, without numbers");
    light.type = word<LightType>(option, parts[0],
                                 {{"point", LightType::point},
                                  {"directional", LightType::directional},
                                  {"spot", LightType::spot},
                                  {"ambient", LightType::ambient},
                                  {"default", {}}});  // refused above: for the list in the message
    if (parts.size() < 2)
        throw Error(ErrorCode::usage, option + ": '" + one_line(std::string(text), 60) + "' lacks its numbers", {},
                    "for example point:0,2,3 or directional:0,-1,-1 or ambient:0.1,0.1,0.1");
    if (light.type == LightType::ambient) {
        light.ambient = color(option, parts[1]);
        light.diffuse = light.specular = {0, 0, 0};
    } else {
        (light.type == LightType::directional ? light.direction : light.position) = vector3(option, parts[1]);
    }
    for (std::size_t i = 2; i < parts.size(); ++i) set_property(option, light, parts[i]);
    light.direction = unit(option, light.direction);
    return light;
}

}  // namespace rakelight::cli
