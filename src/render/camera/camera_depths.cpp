// SPDX-License-Identifier: Apache-2.0
// Near and far of a camera, and what it can see of a box.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <rakelight/io/world.h>

#include "math/functions.h"
#include "math/linear.h"
#include "render/camera/camera_depths.h"

namespace rakelight {
namespace {

/// Planes of the frustum that all of a box is on the outer side of, a bit each, and how far off it is.
struct Outside {
    enum Plane : unsigned { left = 1, right = 2, below = 4, above = 8, near = 16, far = 32 };
    unsigned planes = left | right | below | above | near | far;
    double nearest = HUGE_VAL, farthest = -HUGE_VAL;  ///< [m] of the box, along the view axis
};

Outside outside_of(const Camera& camera, double aspect, const Bounds& bounds) {
    const bool perspective = camera.projection == Projection::perspective;
    const dvec2 half = half_extents(camera, aspect);
    const dvec3 eye = camera.to_world[3].xyz();
    Outside out;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 p = dvec3{corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                              corner & 4 ? bounds.high.z : bounds.low.z} -
                        eye;
        const double x = dot(p, camera.to_world[0].xyz()), y = dot(p, camera.to_world[1].xyz());
        const double distance = -dot(p, camera.to_world[2].xyz());
        const double at_one = perspective ? distance : 1, limit_x = half.x * at_one, limit_y = half.y * at_one;
        out.planes &= unsigned(x < -limit_x) * Outside::left | unsigned(x > limit_x) * Outside::right |
                      unsigned(y < -limit_y) * Outside::below | unsigned(y > limit_y) * Outside::above |
                      unsigned(distance < camera.z_near) * Outside::near |
                      unsigned(distance > camera.z_far) * Outside::far;
        out.nearest = std::min(out.nearest, distance);
        out.farthest = std::max(out.farthest, distance);
    }
    return out;
}

std::string meters(double length) {
    char text[40];
    std::snprintf(text, sizeof text, "%.6g m", length);
    return text;
}

}  // namespace

dvec2 half_extents(const Camera& camera, double aspect) {
    const bool perspective = camera.projection == Projection::perspective;
    const double half_height = perspective ? math::tan(0.5 * camera.vertical_fov_rad) : camera.half_height;
    double half_width = half_height * aspect;
    if (perspective && camera.horizontal_fov_rad) half_width = math::tan(0.5 * *camera.horizontal_fov_rad);
    if (!perspective && camera.half_width) half_width = *camera.half_width;
    return {half_width, half_height};
}

bool loses_by_near(Visibility visibility) {
    return visibility == Visibility::z_float || visibility == Visibility::z16 || visibility == Visibility::z24 ||
           visibility == Visibility::z32;
}

NearestSurface nearest_of(const NearSurfaces& surfaces, double aspect, Visibility visibility) {
    if (loses_by_near(visibility)) return [](const Camera&, double limit) { return limit; };
    return [&surfaces, aspect](const Camera& camera, double limit) {
        dmat4 to_camera;
        if (!inverse_affine(camera.to_world, to_camera)) return limit;
        return surfaces.nearest(to_camera, half_extents(camera, aspect), limit);
    };
}

bool has_default_depths(const Scene& scene, const Camera& camera) {
    const Camera otherwise;
    return is_world_file(scene.source) && camera.projection == Projection::perspective &&
           camera.z_near == otherwise.z_near && camera.z_far == otherwise.z_far;
}

bool may_see(const Camera& camera, double aspect, const Bounds& bounds) {
    return outside_of(camera, aspect, bounds).planes == 0;
}

std::string why_blind(const Camera& camera, double aspect, const Bounds& bounds) {
    const Outside o = outside_of(camera, aspect, bounds);
    if (o.planes == 0) return {};
    if (o.farthest <= 0 && camera.z_near >= 0) return "all of it is behind the camera";
    constexpr std::array<const char*, 4> sides = {"to the left of", "to the right of", "below", "above"};
    for (std::size_t k = 0; k < sides.size(); ++k)
        if (o.planes & 1u << k) return std::string("all of it is ") + sides[k] + " the picture";
    if (o.planes & Outside::far)
        return "all of it is " + meters(o.nearest) + " away or more, but the far plane is at " + meters(camera.z_far);
    return "all of it is " + meters(o.farthest) + " away or less, but the near plane is at " + meters(camera.z_near);
}

void warn_if_blind(const Camera& camera, double aspect, const Bounds& bounds, const std::string& file, Report& report) {
    const std::string why = why_blind(camera, aspect, bounds);
    if (!why.empty()) report.add(Remark::warning, file, "", "the requested camera sees nothing of the model: " + why);
}

void set_asked_depths(Camera& camera, const ViewRequest& view) {
    if (view.z_near) camera.z_near = *view.z_near;
    if (view.z_far) camera.z_far = *view.z_far;
    if ((!view.z_near && !view.z_far) || camera.z_near < camera.z_far) return;
    if (view.z_near)  // both were compared before
        throw Error(ErrorCode::usage,
                    "near, " + meters(camera.z_near) + ", is not less than this camera's far, " + meters(camera.z_far),
                    {}, "give a far too");
    throw Error(ErrorCode::usage,
                "far, " + meters(camera.z_far) + ", is not more than this camera's near, " + meters(camera.z_near), {},
                "give a near too");
}

}  // namespace rakelight
