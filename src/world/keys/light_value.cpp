// SPDX-License-Identifier: Apache-2.0
// Parses lights.
#include <rakelight/world/values.h>

#include <algorithm>
#include <cmath>

#include "world/light_properties.h"

namespace rakelight::values {
namespace {

struct Kind {
    LightType type;
    LightUnits units;
};

Kind kind(const std::string& option, std::string_view text) {
    for (const char* const alone : {"default", "studio", "none"})
        if (same_word(text, alone)) throw wrong(option, std::string(alone) + " stands alone, without numbers");
    constexpr LightUnits classical = LightUnits::classical, photometric = LightUnits::photometric;
    return word<Kind>(option, text,
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
    const Kind what = kind(option, parts[0]);
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
