// SPDX-License-Identifier: Apache-2.0
#include "render/output/ground_grid.h"

#include <algorithm>
#include <cmath>

#include "math/linear.h"

namespace rakelight {
namespace {

constexpr double steps_across = 8;         ///< at least so many steps under the model
constexpr double faded = 1.5, full = 0.6;  ///< diagonals of what the model covers of the ground, from its middle
constexpr double line_px = 1.2, minor_alpha = 0.28, major_alpha = 0.55, axis_alpha = 0.75;
constexpr vec3 axis_colors[3] = {{0.75f, 0.05f, 0.05f}, {0.05f, 0.45f, 0.05f}, {0.05f, 0.15f, 0.8f}};

/// The world's axis that a direction is nearest to.
std::size_t axis_of(dvec3 v) {
    const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
    return y >= x && y >= z ? 1 : z >= x ? 2 : 0;
}

/// Powers that are not whole are rounded: what is as large except for that counts.
bool is_reached(double by, double step) { return step <= by * (1 + 1e-12); }

double power_of_ten(double least) {
    double power = 1;
    while (is_reached(least, power * 10)) power *= 10;
    while (!is_reached(least, power)) power /= 10;
    return power;
}

}  // namespace

double step_of_scale(double least) {
    const double power = power_of_ten(least);
    return is_reached(least, 5 * power) ? 5 * power : is_reached(least, 2 * power) ? 2 * power : power;
}

GroundGrid::GroundGrid(const shading::PictureCamera& view, dvec3 up, const Bounds& bounds, bool dark)
    : rays_(shading::pixel_rays(view, 0, 0)),
      eye_(view.camera_to_world[3].xyz()),
      forward_(-view.camera_to_world[2].xyz()),
      up_(up),
      middle_(bounds.center()),
      is_parallel_(view.orthographic),
      near_(view.z_near) {
    const std::size_t main = axis_of(up);
    for (std::size_t i = 0, axis = 0; axis < 3; ++axis) {
        if (axis == main) continue;
        dvec3 along;
        along[axis] = 1;
        along = along - up * dot(along, up);
        if (i == 1) along = along - across_[0] * dot(along, across_[0]);
        across_[i] = normalize_or(along, dvec3{1, 0, 0});
        axis_color_[i++] = axis_colors[axis];
    }
    dvec2 low{1e300, 1e300}, high{-1e300, -1e300};
    height_ = 1e300;
    double top = -1e300;
    for (int i = 0; i < 8; ++i) {
        const dvec3 corner = bounds.corner(i);
        height_ = std::min(height_, dot(corner, up)), top = std::max(top, dot(corner, up));
        for (std::size_t c = 0; c < 2; ++c) {
            low[c] = std::min(low[c], dot(corner, across_[c]));
            high[c] = std::max(high[c], dot(corner, across_[c]));
        }
    }
    const double width = high.x - low.x, length = high.y - low.y;
    const double size = std::max({std::sqrt(width * width + length * length), 0.5 * (top - height_), 1e-12});
    step_ = step_of_scale(size / steps_across);
    major_ = 10 * power_of_ten(step_);
    reach_ = faded * size;
    height_ -= 1e-4 * size;  // surfaces on the ground hide it
    tolerance_ = 1e-5;
    color_ = dark ? vec3{0.02f, 0.02f, 0.02f} : vec3{0.9f, 0.9f, 0.9f};
}

GroundGrid::Lines GroundGrid::lines(double at, double change) const {
    const auto cover = [&](double spacing) {
        const double place = at / spacing, per_pixel = change / spacing;
        const double off = std::fabs(place - std::floor(place + 0.5));
        const double line = std::clamp(0.5 * line_px + 0.5 - off / std::max(per_pixel, 1e-300), 0.0, 1.0);
        return line * std::clamp(1.5 - 4 * per_pixel, 0.0, 1.0);  // lines that are nearer than pixels are left out
    };
    const double origin = std::clamp(0.5 * line_px + 0.5 - std::fabs(at) / std::max(change, 1e-300), 0.0, 1.0);
    return {cover(step_), cover(major_), origin};
}

vec4 GroundGrid::at(int x, int y, double depth) const {
    const dvec3 ray = rays_.at(x, y), move_x = rays_.along_x, move_y = rays_.along_y;
    const dvec3 toward = is_parallel_ ? forward_ : ray, start = is_parallel_ ? eye_ + ray : eye_;
    const double slope = dot(up_, toward);
    if (std::fabs(slope) < 1e-9) return {};
    const double distance = (height_ - dot(up_, start)) / slope;  // along the view axis
    if (!(distance > near_) || !(distance <= depth * (1 + tolerance_))) return {};
    const dvec3 place = start + toward * distance, from_middle = place - middle_;
    const dvec3 flat = from_middle - up_ * dot(from_middle, up_);
    const double off = std::sqrt(dot(flat, flat));
    const double fade = std::clamp((reach_ - off) / (reach_ * (1 - full / faded)), 0.0, 1.0);
    if (fade <= 0) return {};
    // How the place moves from pixel to pixel: on the plane.
    const auto moved = [&](dvec3 by) {
        const dvec3 free = is_parallel_ ? by : by * distance;
        return free - toward * (dot(up_, free) / slope);
    };
    const dvec3 dx = moved(move_x), dy = moved(move_y);
    vec3 color = color_;
    double alpha = 0;
    for (std::size_t c = 0; c < 2; ++c) {
        const double gx = dot(dx, across_[c]), gy = dot(dy, across_[c]);
        const Lines l = lines(dot(place, across_[c]), std::sqrt(gx * gx + gy * gy));
        alpha = std::max({alpha, minor_alpha * l.cover, major_alpha * l.major});
        if (axis_alpha * l.axis > alpha) alpha = axis_alpha * l.axis, color = axis_color_[1 - c];
    }
    return {color.x, color.y, color.z, float(alpha * fade)};
}

}  // namespace rakelight
