// SPDX-License-Identifier: Apache-2.0
#include <rakelight/world/values.h>

#include "world/light_properties.h"

#include <algorithm>
#include <cmath>

#include <rakelight/scene/light_limits.h>

namespace rakelight::values {
namespace {

/// Kinds of light, as bits.
enum : unsigned { directional = 1, point = 2, spot = 4, photometric = 8, placed = point | spot, any = 7 };

unsigned kind_of(const Light& light) {
    return light.type == LightType::directional ? directional : light.type == LightType::point ? point : spot;
}

void set_attenuation(const std::string& what, Light& light, std::string_view value) {
    const dvec3 given = vector3(what, value);
    if (given == dvec3{0, 0, 0} || given.x < 0 || given.y < 0 || given.z < 0)
        throw wrong(what, "attenuation must be three numbers >= 0, not all 0");
    const vec3 a = light_color(what, value);  // within the float range
    light.constant = a.x, light.linear = a.y, light.quadratic = a.z;
}

void set_cone(const std::string& what, float& cone_rad, std::string_view value, bool may_be_zero) {
    const double degrees = number(what, value);
    if (!(degrees >= (may_be_zero ? 0 : min_cone_deg) && degrees <= 90))
        throw wrong(what, std::string("the half angle must be ") + (may_be_zero ? "0" : "0.001") + " to 90 degrees");
    cone_rad = float(radians(degrees));
}

struct Property {
    const char* name;
    unsigned kinds;  ///< kinds with the property
    bool classical, photometric;
    void (*set)(const std::string& what, Light& light, std::string_view value);
};

constexpr Property properties[] = {
    {"color", any, true, true,
     [](const std::string& what, Light& light, std::string_view value) {
         (light.units == LightUnits::photometric ? light.color : light.diffuse) = light_color(what, value);
     }},
    {"specular", any, true, false,
     [](const std::string& what, Light& l, std::string_view value) { l.specular = light_color(what, value); }},
    {"ambient", any, true, false,
     [](const std::string& what, Light& l, std::string_view value) { l.ambient = light_color(what, value); }},
    {"attenuation", placed, true, false, set_attenuation},
    {"direction", spot, true, true,
     [](const std::string& what, Light& l, std::string_view value) { l.direction = unit(what, vector3(what, value)); }},
    {"cutoff", spot, true, false,
     [](const std::string& what, Light& l, std::string_view value) { set_cone(what, l.cutoff_rad, value, false); }},
    {"exponent", spot, true, false,
     [](const std::string& what, Light& light, std::string_view value) {
         const double exponent = number(what, value);
         if (!(exponent >= 0)) throw wrong(what, "must be >= 0");
         light.exponent = float(std::min(exponent, 1e9));
     }},
    {"intensity", any, false, true,
     [](const std::string& what, Light& l, std::string_view value) {
         l.intensity = float(number(what, value, 0, 1e30));
     }},
    {"inner", spot, false, true,
     [](const std::string& what, Light& l, std::string_view value) { set_cone(what, l.inner_cone_rad, value, true); }},
    {"outer", spot, false, true,
     [](const std::string& what, Light& l, std::string_view value) { set_cone(what, l.outer_cone_rad, value, false); }},
    {"range", placed, true, true,
     [](const std::string& what, Light& light, std::string_view value) {
         const double range = number(what, value);
         if (!(range >= min_light_range && range <= 1e30)) throw wrong(what, "must be 1e-6 to 1e30 m");
         light.range = float(range);
     }},
    {"shadow", any, true, true,
     [](const std::string& what, Light& l, std::string_view value) { l.casts_shadow = on_off(what, value); }},
};

bool has(const Light& light, const Property& p) {
    if (light.type == LightType::ambient || !(kind_of(light) & p.kinds)) return false;
    return light.units == LightUnits::photometric ? p.photometric : p.classical;
}

/// The properties of a kind of light, as advice.
std::string properties_of(const Light& light) {
    if (light.type == LightType::ambient) return "an ambient light has its color only: ambient:R,G,B";
    std::string all;
    for (const Property& p : properties)
        if (has(light, p)) all += (all.empty() ? "" : ", ") + std::string(p.name) + "=";
    return "it has " + all;
}

}  // namespace

void set_light_property(const std::string& option, Light& light, std::string_view name, std::string_view value) {
    for (const Property& p : properties)
        if (name == p.name && has(light, p)) return p.set(option + " " + one_line(std::string(name), 20), light, value);
    throw wrong(option, "this light has no '" + one_line(std::string(name), 40) + "'", properties_of(light));
}

}  // namespace rakelight::values
