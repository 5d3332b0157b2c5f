// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/scene/mark_limits.h"

#include <algorithm>
#include <cmath>

#include "engines/raytrace/scene/mark_geometry.h"
#include "math/linear.h"

namespace rakelight::raytrace {
namespace {

constexpr double rounding = 4e-6;  ///< [1] of depths
constexpr double half_diagonal = 0.70711;

double reach_of(float size_px) { return 0.5 * double(size_px) + half_diagonal; }

}  // namespace

MarkLimits::MarkLimits(const shading::PictureCamera& view, const RenderSettings& settings)
    : view_(view),
      ahead_(-view.camera_to_world[2].xyz()),
      point_reach_(reach_of(settings.point_size)),
      line_reach_(reach_of(settings.line_width)),
      pixel_(2 / (view.scale_y * view.height)) {
    const shading::PixelRays rays = shading::pixel_rays(view, 0, 0);
    along_x_ = rays.along_x, along_y_ = rays.along_y;
}

/// In parallel views distances are linear on the screen, else 1 over them.
double MarkLimits::key(double away) const { return view_.orthographic ? away : 1 / std::max(away, view_.z_near); }

MarkLimits::Change MarkLimits::on_screen(const std::array<dvec3, 3>& corners, dvec3 normal, dvec3 origin,
                                         dvec3 direction) const {
    const double turn = std::fabs(dot(normal, along_x_)) + std::fabs(dot(normal, along_y_));
    const double per =
        view_.orthographic ? std::fabs(dot(normal, direction)) : std::fabs(dot(normal, corners[0] - origin));
    const auto [low, high] =
        std::minmax({key(dot(corners[0], ahead_)), key(dot(corners[1], ahead_)), key(dot(corners[2], ahead_))});
    return {turn / per, high - low};
}

/// There marks are round, as wide as pixels at their distance from the eye.
MarkLimits::Change MarkLimits::in_space(const std::array<dvec3, 3>& corners, dvec3 normal, double t, dvec3 origin,
                                        dvec3 direction) const {
    const double square = dot(direction, direction), meters = pixel_ * mark_scale(view_, origin + direction * t);
    const auto along = [&](dvec3 corner) { return dot(corner - origin, direction) / square; };
    const auto [low, high] = std::minmax({along(corners[0]), along(corners[1]), along(corners[2])});
    const double tangent = length(cross(normal, direction)) / std::fabs(dot(normal, direction));
    return {meters * tangent / std::sqrt(square), high - low};
}

MarkLimit MarkLimits::on_triangle(const std::array<dvec3, 3>& corners, float t, vec3 origin, vec3 direction,
                                  bool is_primary) const {
    const dvec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]), from = cast<double>(origin),
                along = cast<double>(direction);
    const Change change =
        is_primary ? on_screen(corners, normal, from, along) : in_space(corners, normal, double(t), from, along);
    const bool is_distance = !is_primary || view_.orthographic;
    const double own = is_distance ? double(t) : key(double(t));
    const auto limit = [&](double reach) {
        const double tolerance = std::min(change.whole, change.per_pixel * reach) + rounding * own;
        if (!(tolerance >= 0)) return float(double(t) * (1 + rounding));
        if (is_distance) return float(own + tolerance);
        return own > tolerance ? float(1 / (own - tolerance)) : float(view_.z_far);
    };
    return {limit(point_reach_), limit(line_reach_)};
}

}  // namespace rakelight::raytrace
