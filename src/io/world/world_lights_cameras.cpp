// SPDX-License-Identifier: Apache-2.0
#include "io/world/world_lights_cameras.h"

#include <algorithm>
#include <cmath>

#include "math/default_up.h"
#include "math/linear.h"

namespace rakelight::io::world {
namespace {

struct LightWord {
    LightType type;
    LightUnits units;
};
constexpr Word<LightWord> types[] = {
    {"ambient", {LightType::ambient, LightUnits::classical}},
    {"directional", {LightType::directional, LightUnits::classical}},
    {"point", {LightType::point, LightUnits::classical}},
    {"spot", {LightType::spot, LightUnits::classical}},
    {"photometric-directional", {LightType::directional, LightUnits::photometric}},
    {"photometric-point", {LightType::point, LightUnits::photometric}},
    {"photometric-spot", {LightType::spot, LightUnits::photometric}},
};

/// @param of  the light itself, or one of its keys
void check_known(const SectionValues& of, const SectionValues& v, const std::vector<const char*>& keys) {
    for (const WorldValue& value : of.all())
        if (std::none_of(keys.begin(), keys.end(), [&](std::string_view k) { return value.key == k; })) {
            std::string all;
            for (const char* key : keys) all += (all.empty() ? "" : ", ") + std::string(key);
            fail(value.place, "a light of type '" + v.text("type") + "' has no '" + value.key + "'", "it has " + all);
        }
}

void check_keys(const SectionValues& v, const Light& light) {
    std::vector<const char*> keys = keys_of(light);
    keys.insert(keys.end(), {"keys", "interpolation"});
    check_known(v, v, keys);
    keys.insert(keys.begin(), "time");
    for (const SectionValues& key : v.tables()) check_known(key, v, keys);
    const auto require = [&](const char* key) {
        if (!v.has(key)) fail(v.place(), "a light of type '" + v.text("type") + "' lacks the key '" + key + "'");
    };
    if (light.type == LightType::ambient) require("ambient");
    if (light.type == LightType::point || light.type == LightType::spot) require("position");
    if (light.type == LightType::directional || light.type == LightType::spot) require("direction");
}

void read_classical(const SectionValues& v, Light& light) {
    light.ambient = v.color("ambient", light.ambient);
    light.diffuse = v.color("diffuse", light.type == LightType::ambient ? vec3{0, 0, 0} : light.diffuse);
    light.specular = v.color("specular", light.diffuse);
    const vec3 a = cast<float>(v.vector("attenuation", {1, 0, 0}));
    if (a == vec3{0, 0, 0}) fail(v.place_of("attenuation"), "'attenuation' must not be all 0");
    light.constant = a.x, light.linear = a.y, light.quadratic = a.z;
    light.cutoff_rad = float(radians(v.number("cutoff_deg", 90)));
    light.exponent = float(v.number("exponent", 0));
}

/// Another where it is along the view, which is remarked: a warning only where the file names that up.
dvec3 read_up(const SectionValues& v, dvec3 view, WorldFile& world) {
    const dvec3 up = v.direction("up", {0, 1, 0});
    if (!is_along(up, view)) return up;
    const NamedUp other = default_up(view);
    world.remarks.push_back(
        {v.has("up") ? Remark::warning : Remark::note, v.place_of("up"),
         "the camera's up direction is parallel to its view direction, " + other.name + " is up instead"});
    return other.up;
}

}  // namespace

std::vector<const char*> keys_of(const Light& light) {
    const bool classical = light.units == LightUnits::classical;
    const bool is_spot = light.type == LightType::spot, is_placed = is_spot || light.type == LightType::point;
    std::vector<const char*> keys = {"type", "name", "ambient"};
    if (light.type == LightType::ambient) return keys;
    keys.push_back("casts_shadow");
    if (is_placed) keys.insert(keys.end(), {"position", "range"});
    if (!is_placed || is_spot) keys.push_back("direction");
    if (classical) keys.insert(keys.end(), {"diffuse", "specular"});
    if (!classical) std::erase_if(keys, [](std::string_view k) { return k == "ambient"; });
    if (classical && is_placed) keys.push_back("attenuation");
    if (classical && is_spot) keys.insert(keys.end(), {"cutoff_deg", "exponent"});
    if (!classical) keys.insert(keys.end(), {"color", is_placed ? "intensity_cd" : "intensity_lux"});
    if (!classical && is_spot) keys.insert(keys.end(), {"inner_cone_deg", "outer_cone_deg"});
    return keys;
}

Light read_light(const SectionValues& v) {
    Light light;
    const LightWord kind = value_of(types, v.text("type"));
    light.type = kind.type, light.units = kind.units;
    check_keys(v, light);
    light.name = v.text("name");
    light.position = v.vector("position", light.position);
    light.direction = v.direction("direction", light.direction);
    light.range = float(v.number("range", double(light.range)));
    light.casts_shadow = v.flag("casts_shadow", true);
    if (light.units == LightUnits::classical) {
        read_classical(v, light);
        return light;
    }
    light.color = v.color("color", light.color);
    light.intensity = float(v.number("intensity_cd", v.number("intensity_lux", 1)));
    light.inner_cone_rad = float(radians(v.number("inner_cone_deg", 0)));
    light.outer_cone_rad = float(radians(v.number("outer_cone_deg", std::max(45.0, v.number("inner_cone_deg", 0)))));
    if (light.inner_cone_rad > light.outer_cone_rad)
        fail(v.place_of("inner_cone_deg"), "'inner_cone_deg' must not be more than 'outer_cone_deg'");
    return light;
}

Camera read_camera(const SectionValues& v, WorldFile& world) {
    Camera camera;
    camera.name = v.text("name");
    const dvec3 position = v.vector("position", {0, 0, 0}), target = v.vector("target", {0, 0, 0});
    if (position == target) fail(v.place_of("position"), "'position' and 'target' must not be the same");
    camera.to_world = look_at(position, target, read_up(v, target - position, world));
    camera.vertical_fov_rad = radians(v.number("vertical_fov_deg", 40));
    if (v.has("horizontal_fov_deg")) {
        if (!v.has("vertical_fov_deg")) camera.vertical_fov_rad = 0;  // as the picture's aspect makes it
        camera.horizontal_fov_rad = radians(v.number("horizontal_fov_deg", 0));
    }
    if (v.has("orthographic_height")) {
        for (const char* key : {"vertical_fov_deg", "horizontal_fov_deg"})
            if (v.has(key))
                fail(v.place_of(key), "'" + std::string(key) + "' and 'orthographic_height' exclude each other");
        camera.projection = Projection::orthographic;
        camera.half_height = v.number("orthographic_height", 2) / 2;
    }
    const Camera otherwise;  // as it is, where the file gives neither: has_default_depths()
    camera.z_near = v.number("near", camera.z_near);
    camera.z_far = v.number("far", std::max(camera.z_far, 2 * camera.z_near));
    const bool is_given = v.has("near") || v.has("far");
    if (is_given && camera.z_near == otherwise.z_near && camera.z_far == otherwise.z_far)
        camera.z_far = std::nextafter(camera.z_far, HUGE_VAL);
    if (camera.projection == Projection::perspective && !(camera.z_near > 0))
        fail(v.place_of("near"), "'near' must be more than 0");
    if (!(camera.z_far > camera.z_near))
        fail(v.place_of(v.has("far") ? "far" : "near"), "'far' must be more than 'near'");
    return camera;
}

}  // namespace rakelight::io::world
