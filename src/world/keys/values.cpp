// SPDX-License-Identifier: Apache-2.0

#include <rakelight/world/values.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "base/format_text.h"
#include "base/from_chars.h"
#include "math/color.h"
#include "math/color_names.h"
#include "world/light_properties.h"

namespace rakelight::values {
namespace {

[[noreturn]] void refuse(const std::string& option, std::string_view text, const std::string& expected) {
    throw wrong(option, "'" + one_line(std::string(text), 60) + "' is not " + expected);
}

template <class T>
bool parse(std::string_view text, T& value) {
    if (text.starts_with('+')) text.remove_prefix(1);  // from_chars takes none
    const auto [end, fault] = from_chars(text.data(), text.data() + text.size(), value);
    return fault == std::errc() && end == text.data() + text.size();
}

/// By name or code; the '#' of a code is optional.
std::optional<std::array<std::uint8_t, 3>> color_codes(std::string_view text) {
    if (const auto codes = color_by_text(text)) return codes;
    return text.starts_with('#') ? std::nullopt : color_by_text("#" + std::string(text));
}

struct LightKind {
    LightType type;
    LightUnits units;
};

LightKind light_kind(const std::string& option, std::string_view text) {
    for (const char* const alone : {"default", "studio", "none"})
        if (same_word(text, alone)) throw wrong(option, std::string(alone) + " stands alone, without numbers");
    constexpr LightUnits classical = LightUnits::classical, photometric = LightUnits::photometric;
    return word<LightKind>(option, text,
                           {{"point", {LightType::point, classical}},
                            {"directional", {LightType::directional, classical}},
                            {"spot", {LightType::spot, classical}},
                            {"ambient", {LightType::ambient, classical}},
                            {"photometric-point", {LightType::point, photometric}},
                            {"photometric-directional", {LightType::directional, photometric}},
                            {"photometric-spot", {LightType::spot, photometric}},
                            {"default", {}},
                            {"studio", {}},
                            {"none", {}}});  // rejected above; here for the list in the message
}

}  // namespace

std::size_t word_number(const std::string& setting, std::string_view text, std::span<const char* const> names) {
    std::string all;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (same_word(text, names[i])) return i;
        all += (i > 0 ? ", " : "") + std::string(names[i]);
    }
    if (is_number(text)) throw wrong(setting, "'" + one_line(std::string(text), 40) + "' is not one of " + all);
    const std::string nearest = nearest_word(text, {names.begin(), names.end()});
    throw wrong(setting, "unknown word '" + one_line(std::string(text), 40) + "'",
                (nearest.empty() ? "" : "did you mean '" + nearest + "'? ") + "use one of: " + all);
}

Error wrong(const std::string& setting, std::string reason, std::string advice) {
    return Error(ErrorCode::usage, std::move(reason), {}, std::move(advice)).about(setting);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (;;) {
        const std::size_t at = text.find(separator);
        parts.push_back(text.substr(0, at));
        if (at == std::string_view::npos) return parts;
        text.remove_prefix(at + 1);
    }
}

std::vector<double> numbers(const std::string& option, std::string_view text, std::size_t count) {
    const std::string expected = count == 1 ? "a number" : format_text("{} numbers separated by commas", count);
    const std::vector<std::string_view> parts = split(text, ',');
    if (parts.size() != count) refuse(option, text, expected);
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
        if (!parse(parts[i], values[i]) || !std::isfinite(values[i])) refuse(option, text, expected);
    return values;
}

bool is_number(std::string_view text) {
    double value = 0;
    return parse(text, value);
}

double number(const std::string& option, std::string_view text) { return numbers(option, text, 1)[0]; }

double number(const std::string& option, std::string_view text, double low, double high) {
    const double value = number(option, text);
    if (value >= low && value <= high) return value;
    char limits[80];
    std::snprintf(limits, sizeof limits, "must be %.9g to %.9g", low, high);
    throw wrong(option, limits);
}

bool on_off(const std::string& option, std::string_view text) {
    for (const char* const word : {"on", "true", "1"})
        if (same_word(text, word)) return true;
    for (const char* const word : {"off", "false", "0"})
        if (same_word(text, word)) return false;
    throw wrong(option, "must be on or off, not '" + one_line(std::string(text), 40) + "'");
}

dvec3 vector3(const std::string& option, std::string_view text) {
    const std::vector<double> v = numbers(option, text, 3);
    return {v[0], v[1], v[2]};
}

int integer(const std::string& option, std::string_view text, int low, int high) {
    int value = 0;
    if (!parse(text, value) || value < low || value > high)
        refuse(option, text, format_text("a whole number from {} to {}", low, high));
    return value;
}

std::vector<int> integers(const std::string& option, std::string_view text, std::size_t count) {
    const char separator = count == 2 && text.find(',') == std::string_view::npos ? 'x' : ',';
    const std::vector<std::string_view> parts = split(text, separator);
    const std::string expected =
        format_text("{} whole numbers separated by {}", count, count == 2 ? "a comma or x" : "commas");
    if (parts.size() != count) refuse(option, text, expected);
    std::vector<int> values(count);
    for (std::size_t i = 0; i < count; ++i)
        if (!parse(parts[i], values[i])) refuse(option, text, expected);
    return values;
}

std::uint64_t byte_size(const std::string& option, std::string_view text) {
    constexpr std::string_view units = "KMGT";
    const char* const expected = "a size such as 500M or 4G";
    std::string_view digits = text;
    int shift = 0;
    if (digits.ends_with("iB"))
        digits.remove_suffix(2);
    else if (digits.ends_with('B'))
        digits.remove_suffix(1);
    if (!digits.empty()) {
        const char last = digits.back() >= 'a' ? char(digits.back() - 'a' + 'A') : digits.back();
        if (const std::size_t unit = units.find(last); unit != std::string_view::npos) {
            shift = 10 * int(unit + 1);
            digits.remove_suffix(1);
        }
    }
    std::uint64_t whole = 0;
    if (parse(digits, whole)) {
        if (whole == 0 || whole > (~0ull >> shift)) refuse(option, text, expected);
        return whole << shift;
    }
    double value = 0;
    const double bytes = parse(digits, value) ? value * double(std::uint64_t{1} << shift) : 0;
    if (!(bytes >= 1 && bytes < 18446744073709551616.0)) refuse(option, text, expected);
    return std::uint64_t(bytes);
}

vec4 background(const std::string& option, std::string_view text) {
    if (same_word(text, "transparent")) return {0, 0, 0, 0};
    return display_color(option, text, "write r,g,b from 0 to 1, '#rrggbb', a name such as white, or transparent");
}

vec4 display_color(const std::string& option, std::string_view text, const char* advice) {
    dvec3 display;
    if (const auto codes = color_codes(text)) {
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

dvec3 unit(const std::string& option, dvec3 d) {
    const double largest = std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)});
    if (largest == 0) throw wrong(option, "the direction must not be zero");
    d = {d.x / largest, d.y / largest, d.z / largest};  // first, so that the squares cannot overflow
    const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    return {d.x / length, d.y / length, d.z / length};
}

Light light(const std::string& option, std::string_view text) {
    const std::vector<std::string_view> parts = split(text, ':');
    Light light;
    const LightKind what = light_kind(option, parts[0]);
    light.type = what.type, light.units = what.units;
    if (parts.size() < 2)
        throw wrong(option, "'" + one_line(std::string(text), 60) + "' lacks its numbers",
                    "for example point:0,2,3 or directional:0,-1,-1 or ambient:0.1,0.1,0.1");
    if (light.type == LightType::ambient) {
        light.ambient = light_color(option, parts[1]);
        light.diffuse = light.specular = {0, 0, 0};
    } else if (light.type == LightType::directional) {
        light.direction = unit(option, vector3(option, parts[1]));
    } else {
        light.position = vector3(option, parts[1]);
    }
    bool has_specular = false;
    for (std::size_t i = 2; i < parts.size(); ++i) {
        const std::size_t equals = parts[i].find('=');
        if (equals == parts[i].npos)
            throw wrong(option, "'" + one_line(std::string(parts[i]), 40) + "' is not of the form name=value");
        set_light_property(option, light, parts[i].substr(0, equals), parts[i].substr(equals + 1));
        has_specular |= parts[i].substr(0, equals) == "specular";
    }
    if (!has_specular) light.specular = light.diffuse;
    if (light.inner_cone_rad > light.outer_cone_rad) throw wrong(option, "inner must not be more than outer");
    return light;
}

}  // namespace rakelight::values
