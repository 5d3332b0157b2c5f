// SPDX-License-Identifier: Apache-2.0
// Fits a camera to a model from a named side.
#include <algorithm>
#include <array>
#include <cmath>

#include <rakelight/base/error.h>
#include <rakelight/scene/scene_queries.h>

#include "math/default_up.h"
#include "math/functions.h"
#include "math/linear.h"
#include "scene/drawn_vertices.h"
#include "scene/fitted_camera.h"

namespace rakelight {
namespace {

/// Radius of the sphere about the box. A box without extent (a point, nothing) gets a radius that is significant in
/// double: 1, or a millionth of the distance from the origin.
double sphere_radius(const Bounds& bounds) {
    const dvec3 c = bounds.center();
    const double far_out = std::max({std::fabs(c.x), std::fabs(c.y), std::fabs(c.z)});
    const double half_diagonal = 0.5 * bounds.diagonal();
    if (!(half_diagonal > 1e-100)) return std::max(1.0, far_out * 1e-6);
    return std::clamp(std::max(half_diagonal, far_out * 1e-12), 1e-100, 1e150);
}

/// The planes through the model's silhouette that bound it to the left and right, or below and above, for eyes at any distance.
/// An eye at (e, z), across and toward the viewer, sees all points p with |p - e| <= slope * (z - p_z), which is
/// z + e / slope >= high and z - e / slope >= low for the farthest points along (1 / slope, 1) and (-1 / slope, 1).
struct Wedge {
    double slope, high, low;                                      ///< all [m] but slope
    double nearest() const { return 0.5 * (high + low); }         ///< z of the eye on both planes
    double middle() const { return 0.5 * slope * (high - low); }  ///< e of that eye
    /// `e` clamped to the valid interval of an eye farther away.
    double seen_from(double e, double z) const { return std::max(slope * (high - z), std::min(slope * (z - low), e)); }
};

/// Extents of the model along `axes`, relative to the center of its box.
class Extent {
public:
    Extent(const DrawnVertices& drawn, const dmat4& axes)
        : drawn_(drawn), center_(drawn.bounds().center()), x_(axes[0].xyz()), y_(axes[1].xyz()), z_(axes[2].xyz()) {}

    struct Seen {
        Wedge across, up;
        double front, back;  ///< [m] along z: the farthest points toward the viewer and away from him
    };
    Seen seen(double slope_x, double slope_y) const {
        const dvec3 x = x_ * (1 / slope_x), y = y_ * (1 / slope_y);
        const std::array<dvec3, 6> ways{z_ + x, z_ - x, z_ + y, z_ - y, z_, -z_};
        std::array<double, 6> s{};
        drawn_.farthest_along(center_, ways, s);
        return {{slope_x, s[0], s[1]}, {slope_y, s[2], s[3]}, s[4], s[5]};
    }
    struct Rectangle {
        double left, right, below, above;  ///< [m] from the middle, outward
    };
    Rectangle rectangle() const {
        std::array<double, 4> s{};
        drawn_.farthest_along(center_, std::array<dvec3, 4>{-x_, x_, -y_, y_}, s);
        return {s[0], s[1], s[2], s[3]};
    }

private:
    const DrawnVertices& drawn_;
    dvec3 center_, x_, y_, z_;
};

/// Half extent to fill at a distance of 1 m.
struct Slopes {
    double x, y;
};

/// [m] position of the eye relative to the center of the box along the axes: as near as both wedges allow, with the
/// model centered.
dvec3 place_eye(const Extent& extent, Slopes tight, double radius, Extent::Seen& seen) {
    seen = extent.seen(tight.x, tight.y);
    const double z = std::max({seen.across.nearest(), seen.up.nearest(), seen.front + 0.25 * radius});
    // Centers the axis with free space: the model's wedge from the eye is centered. Two iterations are sufficient.
    Slopes own = tight;
    Extent::Seen narrow = seen;
    for (int step = 0; step < 2; ++step) {
        own.x *= std::clamp(narrow.across.nearest() / z, 1e-3, 1.0);
        own.y *= std::clamp(narrow.up.nearest() / z, 1e-3, 1.0);
        narrow = extent.seen(own.x, own.y);
    }
    return {seen.across.seen_from(narrow.across.middle(), z), seen.up.seen_from(narrow.up.middle(), z), z};
}

/// An orthographic camera at the eye's depth, centered on the model's rectangle.
/// @param smallest  [m] half the height of a point, or of a line seen from its end
void make_parallel(Camera& camera, const Extent& extent, double aspect, double smallest, double fill,
                   const dvec3& center, double z) {
    const Extent::Rectangle r = extent.rectangle();
    const double half_width = 0.5 * (r.left + r.right), half_height = 0.5 * (r.below + r.above);
    camera.half_height = std::max({half_height, half_width / aspect, smallest}) / fill;
    if (camera.horizontal_fov_rad) camera.half_width = camera.half_height * aspect;
    camera.projection = Projection::orthographic;
    const dvec3 eye = center + camera.to_world[0].xyz() * (0.5 * (r.right - r.left)) +
                      camera.to_world[1].xyz() * (0.5 * (r.above - r.below)) + camera.to_world[2].xyz() * z;
    camera.to_world[3] = {eye.x, eye.y, eye.z, 1};
}

/// The nearest camera along `axes` that sees the whole model.
Camera fit(const DrawnVertices& drawn, double aspect, const dmat4& axes, const FitOptions& options) {
    Camera camera;
    const Bounds& bounds = drawn.bounds();
    camera.vertical_fov_rad = options.vertical_fov_rad.value_or(camera.vertical_fov_rad);
    camera.horizontal_fov_rad = options.horizontal_fov_rad;
    const double a = aspect > 0 && std::isfinite(aspect) ? std::clamp(aspect, 1e-4, 1e4) : 1.0;
    const double radius = sphere_radius(bounds), tangent = math::tan(0.5 * camera.vertical_fov_rad);
    camera.to_world = axes;
    const dvec3 center = bounds.center();
    const Extent extent(drawn, camera.to_world);
    dvec3 eye{0, 0, radius / std::min(tangent * a, tangent)};
    Extent::Seen seen{};
    if (bounds.diagonal() > 1e-100)
        eye = place_eye(extent, {tangent * a * options.fill, tangent * options.fill}, radius, seen);
    const dvec3 place = center + (camera.to_world[0].xyz() * eye.x + camera.to_world[1].xyz() * eye.y +
                                  camera.to_world[2].xyz() * eye.z);
    camera.to_world[3] = {place.x, place.y, place.z, 1};
    camera.z_near = std::max(eye.z - 1.05 * radius, 0.5 * (eye.z - seen.front));
    camera.z_far = eye.z + 1.05 * radius;
    if (options.orthographic) make_parallel(camera, extent, a, 1e-3 * radius, options.fill, center, eye.z);
    return camera;
}

struct Side {
    const char* name;
    dvec3 toward_eye, up;
};
constexpr Side sides[] = {{"default", {0.45, 0.35, 1}, {0, 1, 0}}, {"front", {0, 0, 1}, {0, 1, 0}},
                          {"back", {0, 0, -1}, {0, 1, 0}},         {"left", {-1, 0, 0}, {0, 1, 0}},
                          {"right", {1, 0, 0}, {0, 1, 0}},         {"top", {0, 1, 0}, {0, 0, -1}},
                          {"bottom", {0, -1, 0}, {0, 0, 1}},       {"isometric", {1, 1, 1}, {0, 1, 0}}};

/// Orientation of a camera at a side; its eye is 1 m from the origin.
dmat4 axes_of(const Side& side, const FitOptions& options) {
    const dvec3 y{0, 1, 0}, none{0, 0, 0};
    const dvec3 axis = normalize_or(options.world_up.value_or(options.up.value_or(y)), y);
    dvec3 toward_eye = turn_with_up(side.toward_eye, axis), up = turn_with_up(side.up, axis);
    if (options.direction) {
        toward_eye = -normalize_or(*options.direction, dvec3{0, 0, -1});
        up = is_along(axis, toward_eye) ? default_up(-toward_eye).up : axis;
    }
    if ((options.world_up || options.direction) && options.up && !is_along(*options.up, toward_eye)) up = *options.up;
    const dmat4 axes = look_at(toward_eye, none, up);
    if (options.azimuth_rad == 0 && options.elevation_rad == 0) return axes;
    return orbited(axes, none, axis, options.azimuth_rad, options.elevation_rad);
}

}  // namespace

dvec3 turn_with_up(dvec3 v, dvec3 up) {
    if (up.y < -1 + 1e-12) return {-v.x, -v.y, v.z};
    const dvec3 axis = cross(dvec3{0, 1, 0}, up);  // its length is the sine, up.y the cosine
    return v * up.y + cross(axis, v) + axis * (dot(axis, v) / (1 + up.y));
}

dmat4 orbited(const dmat4& to_world, dvec3 focal, dvec3 axis, double azimuth_rad, double elevation_rad) {
    const auto turned = [](dvec3 v, dvec3 about, double angle) {  // Rodrigues
        const double c = math::cos(angle), s = math::sin(angle);
        return v * c + cross(about, v) * s + about * (dot(about, v) * (1 - c));
    };
    const dvec3 right = turned(to_world[0].xyz(), axis, azimuth_rad);
    dmat4 out;
    for (int k = 0; k < 4; ++k) {
        const dvec3 v = k == 3 ? to_world[k].xyz() - focal : to_world[k].xyz();
        dvec3 w = turned(turned(v, axis, azimuth_rad), right, -elevation_rad);
        if (k == 3) w += focal;
        out[k] = {w.x, w.y, w.z, k == 3 ? 1.0 : 0.0};
    }
    return out;
}

Camera view_camera(const DrawnVertices& drawn, double aspect, const std::string& side, const FitOptions& options) {
    for (const Side& s : sides) {
        if (side != s.name) continue;
        Camera camera = fit(drawn, aspect, axes_of(s, options), options);
        camera.name = side;
        return camera;
    }
    throw Error(ErrorCode::usage, "unknown view '" + one_line(side, 40) + "'", {},
                "use front, back, left, right, top, bottom, isometric or default");
}

Camera default_camera(const DrawnVertices& drawn, double aspect, const FitOptions& options) {
    return view_camera(drawn, aspect, "default", options);
}

}  // namespace rakelight
