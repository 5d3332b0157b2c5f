// SPDX-License-Identifier: Apache-2.0
// Projections and up vectors of cameras.
#include "math/default_up.h"
#include "math/functions.h"
#include "math/linear.h"

namespace rakelight {

dmat4 perspective(double vertical_fov_rad, double aspect, double near, double far) {
    const double half = vertical_fov_rad / 2;
    const double f = math::cos(half) / math::sin(half);
    // Uses near / far, so that an infinite far plane needs no special case: the ratio is 0.
    const double ratio = near / far;
    return {{{f / aspect, 0, 0, 0},
             {0, f, 0, 0},
             {0, 0, -(1 + ratio) / (1 - ratio), -1},
             {0, 0, -2 * near / (1 - ratio), 0}}};
}

bool is_along(dvec3 up, dvec3 view) {
    const dvec3 zero{0, 0, 0}, side = cross(normalize_or(up, zero), normalize_or(view, zero));
    return !(dot(side, side) > 1e-12);
}

NamedUp default_up(dvec3 view) {
    if (!is_along({0, 1, 0}, view)) return {{0, 1, 0}, "+Y"};
    if (view.y < 0) return {{0, 0, -1}, "-Z"};
    return {{0, 0, 1}, "+Z"};
}

}  // namespace rakelight
