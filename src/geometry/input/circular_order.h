// SPDX-License-Identifier: Apache-2.0
// Sorts coplanar unit vectors by angle. If vectors within an angle are joined transitively, only neighbors on the
// circle must be compared: O(k log k) instead of O(k^2), exact for angles below pi.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "math/linear.h"

namespace rakelight::geometry {

/// Monotonic in the angle of (x, y), 0 to 4, without a trigonometric function.
inline double pseudo_angle(double x, double y) {
    const double sum = std::fabs(x) + std::fabs(y);
    if (!(sum > 0)) return 0;
    const double p = x / sum;
    return y >= 0 ? 1 - p : 3 + p;
}

/// Angular order of the directions, starting at directions[0]. The sense of rotation is arbitrary; ties by index.
inline std::vector<std::uint32_t> circular_order(const std::vector<dvec3>& directions) {
    std::vector<std::uint32_t> order(directions.size());
    std::iota(order.begin(), order.end(), 0u);
    if (directions.size() < 3) return order;
    const dvec3 u = directions[0];
    dvec3 v;  // second axis: from the direction with the largest component perpendicular to u
    for (const dvec3& d : directions) {
        const dvec3 across = d - u * dot(d, u);
        if (dot(across, across) > dot(v, v)) v = across;
    }
    v = normalize_or(v, dvec3{});
    std::vector<double> angle(directions.size());
    for (std::size_t i = 0; i < angle.size(); ++i)
        angle[i] = pseudo_angle(dot(directions[i], u), dot(directions[i], v));
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return angle[a] != angle[b] ? angle[a] < angle[b] : a < b; });
    return order;
}

}  // namespace rakelight::geometry
