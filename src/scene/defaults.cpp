// SPDX-License-Identifier: Apache-2.0
// The view and the light of a model that brings none.
#include <algorithm>
#include <cmath>

#include <rakelight/error.h>

#include "math/functions.h"
#include "math/linear.h"
#include "scene/scene_tools.h"

namespace rakelight {
namespace {

/// Radius of the sphere about the box. A box without extent (a point, nothing) gets a radius that can still be told
/// from its center in double: 1, or a millionth of the distance from the origin.
double sphere_radius(const Bounds& bounds) {
    const dvec3 c = bounds.center();
    const double far_out = std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)});
    const double half_diagonal = 0.5 * bounds.diagonal();
    if (!(half_diagonal > 1e-100)) return std::max(1.0, far_out * 1e-6);
    return std::clamp(std::max(half_diagonal, far_out * 1e-12), 1e-100, 1e150);
}

constexpr double margin = 0.92;  ///< share of the picture's half width and height that the box may fill

/// How far along its own axis a camera stands from the middle of the box so that all eight corners are in the picture; at
/// least a quarter of the radius in front of the nearest one.
struct Fit {
    double distance,
        nearest;  ///< [m] from the eye to the middle; from the middle to the nearest corner, along the axis
};
Fit fit_corners(const Bounds& bounds, const dmat4& axes, double tangent_x, double tangent_y, double radius) {
    const dvec3 half = (bounds.high - bounds.low) * 0.5;
    Fit fit{0, 0};
    for (int k = 0; k < 8; ++k) {
        const dvec3 corner = {k & 1 ? half.x : -half.x, k & 2 ? half.y : -half.y, k & 4 ? half.z : -half.z};
        const double x = dot(corner, axes[0].xyz()), y = dot(corner, axes[1].xyz()), z = dot(corner, axes[2].xyz());
        fit.nearest = std::max(fit.nearest, z);
        fit.distance =
            std::max(fit.distance, z + std::max(std::fabs(x) / tangent_x, std::fabs(y) / tangent_y) / margin);
    }
    if (!(bounds.diagonal() > 1e-100)) return {radius / std::min(tangent_x, tangent_y), 0};
    fit.distance = std::max(fit.distance, fit.nearest + 0.25 * radius);
    return fit;
}

/// A perspective camera that looks from `toward_eye` (any length) at the middle of the box, as near as lets all of it be seen.
Camera fit(const Bounds& bounds, double aspect, dvec3 toward_eye, dvec3 side_up, const FitWishes& wishes) {
    Camera camera;
    const dvec3 up = wishes.up.value_or(side_up);
    camera.vertical_fov_rad = wishes.vertical_fov_rad.value_or(camera.vertical_fov_rad);
    const double a = aspect > 0 && std::isfinite(aspect) ? std::clamp(aspect, 1e-4, 1e4) : 1.0;
    const double radius = sphere_radius(bounds);
    const double tangent = math::tan(0.5 * camera.vertical_fov_rad);
    camera.to_world = look_at(toward_eye, dvec3{0, 0, 0}, up);  // about the origin first: no digits are lost far out
    const Fit corners = fit_corners(bounds, camera.to_world, tangent * a, tangent, radius);
    const dvec3 eye = bounds.center() + camera.to_world[2].xyz() * corners.distance;
    camera.to_world[3] = {eye.x, eye.y, eye.z, 1};
    camera.z_near = std::max(corners.distance - 1.05 * radius, 0.5 * (corners.distance - corners.nearest));
    camera.z_far = corners.distance + 1.05 * radius;
    return camera;
}

/// `v` turned by the shortest turn that takes +Y to `up` (of length 1); half a turn about Z where up is -Y.
dvec3 turn_with_up(dvec3 v, dvec3 up) {
    if (up.y < -1 + 1e-12) return {-v.x, -v.y, v.z};
    const dvec3 axis = cross(dvec3{0, 1, 0}, up);  // its length is the sine, up.y the cosine
    return v * up.y + cross(axis, v) + axis * (dot(axis, v) / (1 + up.y));
}

struct Side {
    const char* name;
    dvec3 toward_eye, up;
};
constexpr Side sides[] = {{"front", {0, 0, 1}, {0, 1, 0}},    {"back", {0, 0, -1}, {0, 1, 0}},
                          {"left", {-1, 0, 0}, {0, 1, 0}},    {"right", {1, 0, 0}, {0, 1, 0}},
                          {"top", {0, 1, 0}, {0, 0, -1}},     {"bottom", {0, -1, 0}, {0, 0, 1}},
                          {"isometric", {1, 1, 1}, {0, 1, 0}}};

Light directional(const char* name, float strength, const dmat4& camera_to_world, dvec3 toward_light_camera) {
    Light light;
    light.name = name;
    light.type = LightType::directional;
    light.diffuse = light.specular = {strength, strength, strength};
    light.direction = normalize_or(-transform_direction(camera_to_world, toward_light_camera), dvec3{0, 0, -1});
    return light;
}

}  // namespace

Camera default_camera(const Bounds& bounds, double aspect, const FitWishes& wishes) {
    const dvec3 y{0, 1, 0}, up = normalize_or(wishes.up.value_or(y), y);
    Camera camera = fit(bounds, aspect, up == y ? dvec3{0.45, 0.35, 1} : turn_with_up({0.45, 0.35, 1}, up), y, wishes);
    camera.name = "default";
    return camera;
}

Camera view_camera(const Bounds& bounds, double aspect, const std::string& side, const FitWishes& wishes) {
    if (side == "default") return default_camera(bounds, aspect, wishes);
    for (const Side& s : sides) {
        if (side != s.name) continue;
        Camera camera = fit(bounds, aspect, s.toward_eye, s.up, wishes);
        camera.name = side;
        return camera;
    }
    throw Error(ErrorCode::usage, "unknown view '" + one_line(side, 40) + "'", {},
                "use front, back, left, right, top, bottom, isometric or default");
}

std::vector<Light> default_lights(const dmat4& camera_to_world) {
    Light ambient;
    ambient.name = "default ambient";
    ambient.type = LightType::ambient;
    ambient.ambient = {0.12f, 0.12f, 0.12f};
    ambient.diffuse = ambient.specular = {0, 0, 0};
    return {ambient, directional("default key", 0.68f, camera_to_world, {-0.5, 0.7, 0.8}),
            directional("default fill", 0.2f, camera_to_world, {0.8, 0.1, 0.6})};
}

}  // namespace rakelight
