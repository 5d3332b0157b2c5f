// SPDX-License-Identifier: Apache-2.0
#include "radiosity/form_factor.h"

#include <algorithm>
#include <cmath>

#include "geometry/input/face_vote.h"

namespace rakelight::radiosity {
namespace {

/// A triangle cut by one plane has at most four corners.
struct CutTriangle {
    std::array<dvec3, 4> corner;
    std::size_t count = 0;
    void add(dvec3 p) { corner[count++] = p; }
};

/// The part with dot(normal, p) > 0 (Sutherland & Hodgman 1974), about the origin.
CutTriangle above_horizon(const std::array<dvec3, 3>& p, dvec3 normal) {
    std::array<double, 3> height;
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        height[k] = dot(normal, p[k]);
        largest = std::max(largest, dot(p[k], p[k]));
    }
    const double least = 1e-9 * std::sqrt(largest);  // lower ones lie in the plane but for rounding
    CutTriangle out;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const bool is_above = height[k] > least;
        if (is_above) out.add(p[k]);
        if (is_above != (height[next] > least)) {
            const double share = std::clamp(height[k] / (height[k] - height[next]), 0.0, 1.0);
            out.add(p[k] + (p[next] - p[k]) * share);
        }
    }
    return out;
}

}  // namespace

double form_factor_of_triangle(dvec3 at, dvec3 normal, const std::array<dvec3, 3>& triangle) {
    const CutTriangle seen = above_horizon({triangle[0] - at, triangle[1] - at, triangle[2] - at}, normal);
    double sum = 0;
    for (std::size_t k = 0; k < seen.count; ++k) {
        const dvec3 a = seen.corner[k], b = seen.corner[(k + 1) % seen.count];
        const dvec3 side = cross(a, b);
        const double sine = length(side);
        if (sine > 0) sum += geometry::corner_angle(sine, dot(a, b)) * dot(side, normal) / sine;
    }
    return std::min(std::fabs(sum) * (0.5 / pi), 1.0);
}

}  // namespace rakelight::radiosity
