// SPDX-License-Identifier: Apache-2.0
// A camera that the caller moves, turns or zooms.
#include <algorithm>
#include <cmath>

#include "math/default_up.h"
#include "math/functions.h"
#include "math/linear.h"
#include "render/camera/place_camera.h"
#include "scene/fitted_camera.h"

namespace rakelight {

void check_placement(const ViewRequest& view) {
    constexpr double farthest = 1e15;  // [m] a double still tells a quarter of a meter there
    const auto near_enough = [](const std::optional<dvec3>& v) {
        return !v || (std::fabs(v->x) <= farthest && std::fabs(v->y) <= farthest && std::fabs(v->z) <= farthest);
    };
    const auto finite = [](const std::optional<dvec3>& v) { return !v || is_finite(*v); };
    if (!finite(view.position) || !finite(view.focal_point) || !finite(view.up) || !finite(view.world_up) ||
        !finite(view.direction))
        throw Error(ErrorCode::usage, "the camera's position, focal point, direction and up must be finite");
    if (!near_enough(view.position)) throw Error(ErrorCode::usage, "the camera's position is more than 1e15 m away");
    if (!near_enough(view.focal_point))
        throw Error(ErrorCode::usage, "the camera's focal point is more than 1e15 m away");
    if (view.vertical_fov_rad && !(*view.vertical_fov_rad > 0 && *view.vertical_fov_rad < pi))
        throw Error(ErrorCode::usage, "the camera's view angle must be more than 0 and less than 180 degrees");
    if (view.horizontal_fov_rad && !(*view.horizontal_fov_rad > 0 && *view.horizontal_fov_rad < pi))
        throw Error(ErrorCode::usage, "the camera's horizontal angle must be more than 0 and less than 180 degrees");
    if ((view.z_near && !(*view.z_near > 0)) || (view.z_far && !(*view.z_far > 0)))
        throw Error(ErrorCode::usage, "the camera's near and far must be more than 0 m");
    if (view.z_near && view.z_far && !(*view.z_near < *view.z_far))
        throw Error(ErrorCode::usage, "the camera's near must be less than its far");
    const dvec3 zero{0, 0, 0};
    if (view.up == zero || view.world_up == zero) throw Error(ErrorCode::usage, "the camera's up must not be zero");
    if (view.direction == zero) throw Error(ErrorCode::usage, "the camera's direction must not be zero");
    const auto is_number = [](const std::optional<double>& v) { return !v || std::isfinite(*v); };
    if (!is_number(view.azimuth_rad) || !is_number(view.elevation_rad))
        throw Error(ErrorCode::usage, "the camera's azimuth and elevation must be finite");
    if (view.zoom_factor && !(*view.zoom_factor >= 1e-3 && *view.zoom_factor <= 1e3))
        throw Error(ErrorCode::usage, "the camera's zoom factor must be 0.001 to 1000");
}

namespace {

/// Radius of the sphere about the box, never 0.
double radius_of(const Bounds& bounds) {
    const dvec3 c = bounds.center();
    const double half = 0.5 * bounds.diagonal();
    return half > 0 ? half : std::max(1.0, 1e-6 * std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)}));
}

/// The up direction of a view along `along`, with a remark if the requested or usual one is parallel to it: a warning
/// only if it was requested.
dvec3 choose_up(const ViewRequest& view, dvec3 base_up, dvec3 along, const std::string& file, Report& report) {
    const dvec3 up = view.up.value_or(view.position ? view.world_up.value_or(dvec3{0, 1, 0}) : base_up);
    if (!is_along(up, along)) return up;
    const NamedUp other = default_up(along);
    report.add(view.up ? Remark::warning : Remark::note, file, "",
               "the camera's up direction is parallel to its view direction, " + other.name + " is up instead");
    return other.up;
}

}  // namespace

void set_depths(Camera& camera, const Bounds& bounds, const NearestSurface& nearest) {
    const double radius = 1.05 * radius_of(bounds);
    const double distance = dot(camera.to_world[3].xyz() - bounds.center(), camera.to_world[2].xyz());
    camera.z_near = distance - radius;
    camera.z_far = distance + radius;
    if (camera.projection == Projection::orthographic) return;
    camera.z_far = std::max(camera.z_far, radius);
    const double usual = 1e-4 * camera.z_far, least = 1e-8 * camera.z_far;
    if (camera.z_near >= usual) return;
    camera.z_near = usual;
    const double distance_of_surface = nearest(camera, 2 * usual);
    if (distance_of_surface < 2 * usual) camera.z_near = std::max(0.5 * distance_of_surface, least);
}

dvec3 axis_of_turns(const ViewRequest& view) {
    const dvec3 y{0, 1, 0};
    return normalize_or(view.world_up.value_or(view.up.value_or(y)), y);
}

void warn_if_up_is_along(dvec3 up, const Camera& camera, const std::string& file, Report& report) {
    const dvec3 along = -camera.to_world[2].xyz();
    if (is_along(up, along))
        report.add(Remark::warning, file, "",
                   "the camera's up direction is parallel to its view direction, the side's own is up instead");
}

Camera place_camera(const Camera& base, bool is_fitted, const ViewRequest& view, double aspect, const Bounds& bounds,
                    const NearestSurface& nearest, const std::string& file, Context& context) {
    Camera camera = base;
    if (view.vertical_fov_rad) {
        camera.vertical_fov_rad = *view.vertical_fov_rad;
        camera.horizontal_fov_rad = view.horizontal_fov_rad;
    }
    const dvec3 base_eye = base.to_world[3].xyz(), base_z = base.to_world[2].xyz();

    // 1. The focal point of the base camera: the model's center, or the point on a file camera's axis that is nearest
    // to it.
    double distance = dot(base_eye - bounds.center(), base_z);
    if (!(distance > 0)) distance = radius_of(bounds);
    const dvec3 base_focal = is_fitted ? bounds.center() : base_eye - base_z * distance;

    // 2. Eye and focal point: what is not given keeps its place relative to the other.
    const dvec3 focal = view.focal_point.value_or(base_focal);
    const dvec3 eye = view.position.value_or(focal + base_z * distance);
    if (eye == focal) throw Error(ErrorCode::usage, "the camera's position and focal point are the same");
    const dvec3 up = choose_up(view, base.to_world[1].xyz(), focal - eye, file, context.report());
    camera.to_world = look_at(eye, focal, up);
    if (view.is_orbited())
        camera.to_world = orbited(camera.to_world, focal, axis_of_turns(view), view.azimuth_rad.value_or(0),
                                  view.elevation_rad.value_or(0));

    // 3. Projection and depths.
    if (camera.projection == Projection::perspective ? view.orthographic : view.vertical_fov_rad.has_value()) {
        camera.half_height = math::tan(0.5 * camera.vertical_fov_rad) * length(eye - focal);
        camera.half_width.reset();
        if (camera.horizontal_fov_rad)
            camera.half_width = math::tan(0.5 * *camera.horizontal_fov_rad) * length(eye - focal);
        camera.projection = Projection::orthographic;
    }
    camera.node = no_index;
    set_depths(camera, bounds, nearest);
    set_asked_depths(camera, view);
    warn_if_blind(camera, aspect, bounds, file, context.report());
    return camera;
}

}  // namespace rakelight
