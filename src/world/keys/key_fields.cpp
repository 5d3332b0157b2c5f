// SPDX-License-Identifier: Apache-2.0
// Writes values as text that parses to the same values.
#include <charconv>
#include <cmath>
#include <cstdio>

#include "base/from_chars.h"
#include "math/color.h"
#include "world/keys/fixed_function.h"
#include "world/keys/key_fields.h"

namespace rakelight::keys {
namespace {

template <class T>
std::string shortest(T number) {
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

/// The shortest text for which is_same() holds.
template <class IsSame>
std::string rounded(double number, const IsSame& is_same) {
    for (int digits = 1; digits < 17; ++digits) {
        char text[40];
        const char* const end = std::to_chars(text, text + sizeof text, number, std::chars_format::general, digits).ptr;
        double back = 0;
        from_chars(text, end, back);
        if (is_same(back)) return shortest(back);
    }
    return shortest(number);
}

/// 0..1, of linear light.
std::string display_of(float linear) {
    return rounded(double(srgb_from_linear(linear)),
                   [linear](double display) { return linear_from_srgb(float(display)) == linear; });
}

std::string text_of_three(vec3 v) { return shortest(v.x) + "," + shortest(v.y) + "," + shortest(v.z); }

void add(std::string& text, const char* name, const std::string& value) {
    text += std::string(":") + name + "=" + value;
}

void add_classical(const Light& l, std::string& text) {
    const Light plain;
    if (l.diffuse != plain.diffuse) add(text, "color", text_of_three(l.diffuse));
    if (l.specular != l.diffuse) add(text, "specular", text_of_three(l.specular));
    if (l.ambient != plain.ambient) add(text, "ambient", text_of_three(l.ambient));
    if (l.type == LightType::directional) return;
    if (l.constant != 1 || l.linear != 0 || l.quadratic != 0)
        add(text, "attenuation", text_of_three(vec3{l.constant, l.linear, l.quadratic}));
    if (l.type != LightType::spot) return;
    if (l.cutoff_rad != plain.cutoff_rad) add(text, "cutoff", degrees_of_float(l.cutoff_rad));
    if (l.exponent != 0) add(text, "exponent", shortest(l.exponent));
}

void add_photometric(const Light& l, std::string& text) {
    const Light plain;
    if (l.color != plain.color) add(text, "color", text_of_three(l.color));
    if (l.intensity != plain.intensity) add(text, "intensity", shortest(l.intensity));
    if (l.type != LightType::spot) return;
    if (l.inner_cone_rad != plain.inner_cone_rad) add(text, "inner", degrees_of_float(l.inner_cone_rad));
    if (l.outer_cone_rad != plain.outer_cone_rad) add(text, "outer", degrees_of_float(l.outer_cone_rad));
}

}  // namespace

const char* name_of(const Light& light) {
    if (light.type == LightType::ambient) return "ambient";
    const bool is_classical = light.units == LightUnits::classical;
    if (light.type == LightType::directional) return is_classical ? "directional" : "photometric-directional";
    if (light.type == LightType::spot) return is_classical ? "spot" : "photometric-spot";
    return is_classical ? "point" : "photometric-point";
}

const PictureRequest& defaults() {
    static const PictureRequest plain;
    return plain;
}

const PictureRequest& defaults_beside(const PictureRequest& of) {
    static const PictureRequest fixed = [] {
        PictureRequest request;
        set_preset(Preset::fixed_function, request);
        return request;
    }();
    return of.preset == Preset::none ? defaults() : fixed;
}

std::string text_of(double number) { return shortest(number); }
std::string text_of_float(float number) { return shortest(number); }
std::string text_of(dvec3 v) { return shortest(v.x) + "," + shortest(v.y) + "," + shortest(v.z); }

std::string degrees_of(double angle_rad) {
    if (angle_rad == pi) return "180";
    return rounded(angle_rad * 180 / pi, [angle_rad](double deg) { return radians(deg) == angle_rad; });
}

std::string degrees_of_float(float angle_rad) {
    return rounded(double(angle_rad) * 180 / pi, [angle_rad](double deg) { return float(radians(deg)) == angle_rad; });
}

std::string color_of(vec3 linear) {
    const auto code = [](float c) { return int(std::lround(double(srgb_from_linear(c)) * 255)); };
    char hex[8];
    std::snprintf(hex, sizeof hex, "#%02x%02x%02x", code(linear.x), code(linear.y), code(linear.z));
    if (values::display_color("color", hex).xyz() == linear) return hex;
    return display_of(linear.x) + "," + display_of(linear.y) + "," + display_of(linear.z);
}

std::string text_of(const Light& l) {
    std::string text = name_of(l);
    if (l.type == LightType::ambient) return text + ":" + text_of_three(l.ambient);
    text += ":" + text_of(l.type == LightType::directional ? l.direction : l.position);
    if (l.type == LightType::spot && l.direction != Light{}.direction) add(text, "direction", text_of(l.direction));
    l.units == LightUnits::classical ? add_classical(l, text) : add_photometric(l, text);
    if (l.type != LightType::directional && std::isfinite(l.range)) add(text, "range", shortest(l.range));
    if (!l.casts_shadow) add(text, "shadow", "off");
    return text;
}

std::string text_of(const Fog& fog) {
    if (fog.kind == FogKind::none) return "none";
    std::string text = fog.kind == FogKind::linear        ? "linear:" + shortest(fog.start) + "," + shortest(fog.end)
                       : fog.kind == FogKind::exponential ? "exp:" + shortest(fog.density)
                                                          : "exp2:" + shortest(fog.density);
    if (fog.color != Fog{}.color) add(text, "color", color_of(fog.color));
    return text;
}

}  // namespace rakelight::keys
