// SPDX-License-Identifier: Apache-2.0
#include "eye.h"

#include <algorithm>
#include <cmath>

#include <rakelight/math/linear.h>

namespace rakelight::viewer {
namespace {

constexpr double steepest_rad = radians(89.5);  // of the turntable: straight up and down the view has no side
constexpr double farthest = 1e14;               // [m] choose_camera() refuses more than 1e15

double radius_of(const Bounds& bounds) {
    const double radius = bounds.empty() ? 0 : 0.5 * bounds.diagonal();
    return radius > 0 && std::isfinite(radius) ? radius : 1;
}

/// Perpendicular to the view and unit; any such direction where `up` lies along it.
dvec3 upright(dvec3 up, dvec3 along) {
    const dvec3 other = std::fabs(along.y) < 0.9 ? dvec3{0, 1, 0} : dvec3{0, 0, 1};
    const dvec3 side = cross(along, up);
    const dvec3 fallback = normalize_or(cross(along, other), dvec3{1, 0, 0});
    const dvec3 right = dot(side, side) > 1e-18 * dot(up, up) ? normalize_or(side, fallback) : fallback;
    return normalize_or(cross(right, along), dvec3{0, 1, 0});
}

/// [rad] -pi/2..pi/2 above the plane that world_up is perpendicular to.
double elevation_of(dvec3 direction, dvec3 world_up) {
    return std::asin(std::clamp(dot(direction, world_up), -1.0, 1.0));
}

/// Turns a direction up and then about world_up, not beyond the steepest. @param side  cross(direction, up)
dvec3 turned(dvec3 direction, dvec3 side, double right_rad, double up_rad, dvec3 world_up) {
    const double now = elevation_of(direction, world_up);
    const double low = std::min(-steepest_rad, now), high = std::max(steepest_rad, now);
    const double by = std::clamp(now + up_rad, low, high) - now;
    return rotated(rotated(direction, side, by), world_up, right_rad);
}

dvec3 on_ball(dvec2 p) {
    const double d = p.x * p.x + p.y * p.y;
    if (d < 0.5) return {p.x, p.y, std::sqrt(1 - d)};
    return normalize_or(dvec3{p.x, p.y, 0.5 / std::sqrt(d)}, dvec3{0, 0, 1});  // Bell's hyperbola: no edge of the ball
}

}  // namespace

dvec3 rotated(dvec3 v, dvec3 axis, double angle_rad) {
    const double c = std::cos(angle_rad), s = std::sin(angle_rad);  // Rodrigues
    return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

dvec3 forward_of(const Eye& eye) { return normalize_or(eye.focal - eye.position, dvec3{0, 0, -1}); }
dvec3 right_of(const Eye& eye) { return normalize_or(cross(forward_of(eye), eye.up), dvec3{1, 0, 0}); }
double distance_of(const Eye& eye) { return length(eye.focal - eye.position); }

Eye eye_of(const Camera& camera, const Bounds& bounds) {
    const dvec3 back = camera.to_world[2].xyz(), at = camera.to_world[3].xyz();
    Eye eye{.position = at, .up = camera.to_world[1].xyz()};
    double distance = bounds.empty() ? 1 : dot(at - bounds.center(), back);
    if (!(distance > 0)) distance = radius_of(bounds);
    eye.is_orthographic = camera.projection == Projection::orthographic;
    if (eye.is_orthographic) {
        distance = camera.half_height / std::tan(radians(0.5 * eye.fov_deg));
        eye.focal = at - back * dot(at - bounds.center(), back);
        eye.position = eye.focal + back * distance;
        return eye;
    }
    eye.fov_deg = degrees(camera.vertical_fov_rad);
    if (camera.horizontal_fov_rad) eye.horizontal_fov_deg = degrees(*camera.horizontal_fov_rad);
    eye.focal = at - back * distance;
    return eye;
}

void place(ViewRequest& view, const Eye& eye, dvec3 world_up) {
    const dvec3 ahead = forward_of(eye), side = cross(ahead, world_up), off = upright(world_up, ahead) - eye.up;
    const bool is_upright = dot(side, side) > 1e-6 && dot(off, off) < 1e-24;
    std::optional<double> horizontal_fov_rad;
    if (eye.horizontal_fov_deg) horizontal_fov_rad = radians(*eye.horizontal_fov_deg);
    view = {.position = eye.position,
            .focal_point = eye.focal,
            .up = is_upright ? world_up : eye.up,
            .world_up = view.world_up,
            .vertical_fov_rad = radians(eye.fov_deg),
            .horizontal_fov_rad = horizontal_fov_rad,
            .z_near = view.z_near,
            .z_far = view.z_far,
            .orthographic = eye.is_orthographic};
}

void turn_table(Eye& eye, double right_rad, double up_rad, dvec3 world_up) {
    const double distance = distance_of(eye);
    const dvec3 right = right_of(eye);
    // The model follows the pointer: the eye goes the other way round, and up as the pointer goes down.
    const dvec3 to_eye = turned(-forward_of(eye), -right, -right_rad, up_rad, world_up);
    eye.position = eye.focal + to_eye * distance;
    const bool is_steep = std::fabs(elevation_of(to_eye, world_up)) > radians(89.9);
    eye.up = upright(is_steep ? rotated(eye.up, world_up, -right_rad) : world_up, -to_eye);
}

void turn_ball(Eye& eye, dvec2 from, dvec2 to) {
    const dvec3 a = on_ball(from), b = on_ball(to);
    const dvec3 normal = cross(a, b);
    if (dot(normal, normal) < 1e-20) return;
    const double angle = std::atan2(length(normal), dot(a, b));
    const dvec3 right = right_of(eye), ahead = forward_of(eye);
    const dvec3 n = normalize_or(normal, dvec3{0, 0, 1});
    const dvec3 axis = normalize_or(right * n.x + eye.up * n.y - ahead * n.z, eye.up);
    const double distance = distance_of(eye);
    const dvec3 to_eye = rotated(-ahead, axis, -angle);
    eye.up = upright(rotated(eye.up, axis, -angle), -to_eye);
    eye.position = eye.focal + to_eye * distance;
}

void pan(Eye& eye, double dx_px, double dy_px, double height_px) {
    if (!(height_px > 0)) return;
    const double meters = 2 * distance_of(eye) * std::tan(radians(0.5 * eye.fov_deg)) / height_px;
    const dvec3 by = right_of(eye) * (-dx_px * meters) + eye.up * (dy_px * meters);
    center_on(eye, eye.focal + by);
}

void dolly(Eye& eye, double factor) {
    const double distance = distance_of(eye);
    const double smallest = std::max(1e-9, 1e-9 * length(eye.focal));  // [m] a double still tells the two apart
    eye.position = eye.focal - forward_of(eye) * std::clamp(distance * factor, smallest, farthest);
}

void go_around(Eye& eye, double angle_rad, dvec3 world_up) {
    eye.position = eye.focal + rotated(eye.position - eye.focal, world_up, -angle_rad);
    eye.up = rotated(eye.up, world_up, -angle_rad);
}

void roll(Eye& eye, double angle_rad) {
    eye.up = upright(rotated(eye.up, forward_of(eye), angle_rad), forward_of(eye));
}

void center_on(Eye& eye, dvec3 target) {
    if (!is_finite(target) || length(target) > farthest) return;
    eye.position += target - eye.focal;
    eye.focal = target;
}

void look(Eye& eye, double right_rad, double up_rad, dvec3 world_up) {
    const double distance = distance_of(eye);
    const dvec3 ahead = turned(forward_of(eye), right_of(eye), -right_rad, up_rad, world_up);
    eye.focal = eye.position + ahead * distance;
    eye.up = upright(world_up, ahead);
}

void walk(Eye& eye, double ahead, double right, double up, dvec3 world_up) {
    const dvec3 by = forward_of(eye) * ahead + right_of(eye) * right + world_up * up;
    center_on(eye, eye.focal + by);
}

}  // namespace rakelight::viewer
