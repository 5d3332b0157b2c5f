// SPDX-License-Identifier: Apache-2.0
#include "math/default_up.h"

#include "math/linear.h"

namespace rakelight {

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
