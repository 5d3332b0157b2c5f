// SPDX-License-Identifier: Apache-2.0
// Whether a triangle's edges and vertices are drawn.
#pragma once
#include "shading/draw_choices.h"

namespace rakelight::shading {

/// By the sign of the triangle's area before the division: right also where it passes through the eye plane.
/// @param v  corners in clip space: x, y (up), w
inline bool is_culled(const Culling& culling, const dvec3 (&v)[3]) {
    if (!culling.back && !culling.front) return false;
    const double area = v[0].x * (v[1].y * v[2].z - v[2].y * v[1].z) - v[1].x * (v[0].y * v[2].z - v[2].y * v[0].z) +
                        v[2].x * (v[0].y * v[1].z - v[1].y * v[0].z);
    const bool is_back = (area > 0) != culling.front_is_negative;  // y up here
    return area == 0 || (is_back ? culling.back : culling.front);
}

}  // namespace rakelight::shading
