// SPDX-License-Identifier: Apache-2.0
#include "engines/raster/marks/point_blocks.h"

#include <cmath>

namespace rakelight::raster {
namespace {

constexpr double rounding = 1e-9;  ///< far more than that of the depths compared

}  // namespace

PointBlocks::Mask PointBlocks::shown(const Mark& m, double reach) const {
    Mask out = 0;
    show({0, 0, across}, m, reach, out);
    return out;
}

void PointBlocks::show(const Square& square, const Mark& m, double reach, Mask& out) const {
    const dvec2 at = center(square), off{at.x - double(m.x[0]), at.y - double(m.y[0])};
    const double half = 0.5 * side * square.side, radius = 1.41421357 * half;
    const double least = m.shape == Mark::Shape::disc ? std::sqrt(dot(off, off)) - radius
                                                      : std::max(std::fabs(off.x), std::fabs(off.y)) - half;
    const std::optional<Mark>& known = nearest_[std::size_t(square.index())];
    if (least > reach || (known && hides(*known, m, at, radius))) return;
    if (square.side == 1)
        out |= Mask(1) << square.index();
    else
        for (const Square& quarter : square.quarters()) show(quarter, m, reach, out);
}

void PointBlocks::add_to(const Square& square, const Mark& m) {
    std::optional<Mark>& known = nearest_[std::size_t(square.index())];
    if (!known || hides(m, *known, center(square), 0)) known = m;
}

void PointBlocks::add_below(const Square& square, const Mark& m, const MarkShape& shape) {
    const int left = ox_ + side * square.column, top = oy_ + side * square.row, right = left + side * square.side - 1,
              bottom = top + side * square.side - 1;
    if (shape.fills(shape.nearest(left, top)) && shape.fills(shape.nearest(right, top)) &&
        shape.fills(shape.nearest(left, bottom)) && shape.fills(shape.nearest(right, bottom)))
        add_to(square, m);
    if (square.side > 1)
        for (const Square& quarter : square.quarters()) add_below(quarter, m, shape);
}

/// PointParaboloid::key() of both, multiplied by what they are divided by: their difference is a quadratic function of the
/// place, which is bounded by its value, gradient and curvature at the center.
bool PointBlocks::hides(const Mark& nearer, const Mark& m, dvec2 center, double distance) const {
    if (nearer.x[0] == m.x[0] && nearer.y[0] == m.y[0] && nearer.key[0] == m.key[0]) return true;
    const double key_a = double(nearer.key[0]), key_b = double(m.key[0]);
    const double depth = paraboloid_.depth() / (half_ * half_);
    const double of_a = paraboloid_.is_parallel() ? 1 : key_a, of_b = paraboloid_.is_parallel() ? 1 : key_b;
    const dvec2 a{center.x - double(nearer.x[0]), center.y - double(nearer.y[0])},
        b{center.x - double(m.x[0]), center.y - double(m.y[0])};
    const double sunk_a = depth * of_b * dot(a, a), sunk_b = depth * of_a * dot(b, b);
    const dvec2 slope = (b * of_a - a * of_b) * (2 * depth);
    const double least = key_a - key_b + sunk_b - sunk_a - std::sqrt(dot(slope, slope)) * distance -
                         std::max(0.0, depth * (of_b - of_a)) * distance * distance;
    return least > rounding * (std::fabs(key_a) + std::fabs(key_b) + sunk_a + sunk_b);
}

}  // namespace rakelight::raster
