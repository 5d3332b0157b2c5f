// SPDX-License-Identifier: Apache-2.0
// Lights and cameras: each gets a node of its own under the file's node, turned so that -Z is its direction.
#include <algorithm>
#include <cmath>

#include "io/import/scene_from_import.h"
#include "math/color.h"
#include "math/functions.h"
#include "math/linear.h"

namespace rakelight::io {
namespace {

using import_stream::Lamp;
using import_stream::View;

vec3 light_color(vec3 c) {
    if (!is_finite(c)) return {0, 0, 0};
    const float peak = std::max({c.x, c.y, c.z, 1.0f});
    return linear_from_srgb(c / peak) * peak;
}

/// Under `parent`; a direction of zero leaves -Z.
std::uint32_t add_node(const std::string& name, std::uint32_t parent, dvec3 position, dvec3 direction, dvec3 up,
                       Scene& scene) {
    Node& node = scene.nodes.emplace_back();
    node.name = name;
    node.parent = parent;
    const dvec3 at = is_finite(position) ? position : dvec3{};
    const dvec3 way = normalize_or(direction, dvec3{0, 0, -1});
    node.local.matrix = look_at(at, at + way, up);
    return std::uint32_t(scene.nodes.size() - 1);
}

/// Meters for one unit of length of the file: that of the root, since a light's or camera's own scale does not stretch
/// its range.
double unit_of(const std::vector<dmat4>& world) {
    const double unit = length(world[0][2].xyz());
    return unit > 0 && std::isfinite(unit) ? unit : 1;
}

Light light_of(const Lamp& l, double unit_m) {
    Light light;
    light.name = l.name;
    light.type = LightType(l.type);
    light.ambient = light_color(l.ambient);
    light.diffuse = light_color(l.diffuse);
    light.specular = light_color(l.specular);
    const auto factor = [](float f, double scale) {
        return std::isfinite(f) && f > 0 ? float(double(f) / scale) : 0.0f;
    };
    light.constant = factor(l.constant, 1);
    light.linear = factor(l.linear, unit_m);  // the file counts in its own unit
    light.quadratic = factor(l.quadratic, unit_m * unit_m);
    // FBX: full strength up to a distance, then falling; Assimp's constant of 0 would make near surfaces infinitely bright.
    if (light.constant == 0 && light.linear + light.quadratic > 0) light.constant = 1;
    if (light.constant + light.linear + light.quadratic <= 0 || !std::isfinite(light.linear + light.quadratic)) {
        light.constant = 1;
        light.linear = light.quadratic = 0;
    }
    if (light.type == LightType::spot && l.cone_rad > 0 && l.cone_rad < float(pi))
        light.cutoff_rad = l.cone_rad / 2;  // the file has the full angle
    if (light.type == LightType::ambient) {
        light.ambient = max(light.ambient, light.diffuse);
        light.diffuse = light.specular = {0, 0, 0};
    }
    return light;
}

constexpr double narrowest_rad =
    0.02;  // Assimp 5.2 hands out 0.0137 for Collada cameras, whose angles it does not read

Camera camera_of(const View& v, double unit_m) {
    Camera camera;
    camera.name = v.name;
    const bool has_aspect = std::isfinite(v.aspect) && v.aspect > 0.01 && v.aspect < 100;
    if (has_aspect) camera.aspect = v.aspect;
    const double aspect = has_aspect ? v.aspect : 4.0 / 3.0;  // what these formats' programs assumed
    if (v.half_width > 0 && std::isfinite(v.half_width)) {
        camera.projection = Projection::orthographic;
        camera.half_height = v.half_width / aspect * unit_m;
    } else if (v.horizontal_fov_rad > narrowest_rad && v.horizontal_fov_rad < pi - 0.001) {
        const double half = v.horizontal_fov_rad / 2;
        camera.vertical_fov_rad = 2 * math::atan2(math::sin(half), math::cos(half) * aspect);
    }
    if (v.z_near > 0 && std::isfinite(v.z_near)) camera.z_near = v.z_near * unit_m;
    if (std::isfinite(v.z_far)) camera.z_far = v.z_far * unit_m;
    if (!(camera.z_far > camera.z_near)) camera.z_far = std::numeric_limits<double>::infinity();
    return camera;
}

}  // namespace

void detail::add_lights_and_cameras(const import_stream::Document& d, const std::vector<dmat4>& world,
                                    const std::string& path, Scene& scene, Context& context) {
    if (d.places.empty() || world.empty()) return;
    const double unit = unit_of(world);
    for (const Lamp& l : d.lamps) {
        const std::uint32_t parent = l.node == import_stream::nothing ? 0 : l.node;
        const Light light = light_of(l, unit);
        const vec3 sum = light.ambient + light.diffuse + light.specular;
        if (!(sum.x + sum.y + sum.z > 0)) {
            context.report().add(Remark::dropped, path, "light '" + one_line(l.name, 60) + "'",
                                 "a black light is left out");
            continue;
        }
        scene.lights.push_back(light);
        if (light.type != LightType::ambient)
            scene.lights.back().node = add_node(l.name, parent, l.position, l.direction, {0, 1, 0}, scene);
    }
    for (const View& v : d.views) {
        const std::uint32_t parent = v.node == import_stream::nothing ? 0 : v.node;
        if (!(v.half_width > 0) && !(v.horizontal_fov_rad > narrowest_rad))
            context.report().add(Remark::guessed, path, "camera '" + one_line(v.name, 60) + "'",
                                 "its field of view could not be read; 40 degrees are used");
        scene.cameras.push_back(camera_of(v, unit));
        scene.cameras.back().node = add_node(v.name, parent, v.position, v.direction, v.up, scene);
    }
}

}  // namespace rakelight::io
