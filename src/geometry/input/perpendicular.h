// SPDX-License-Identifier: Apache-2.0
// The default for undetermined tangents.
#pragma once
#include <cmath>

#include "math/linear.h"

namespace rakelight::geometry {

/// The coordinate axis farthest from a unit normal (x before y before z), orthogonalized against it.
inline dvec3 perpendicular(dvec3 n) {
    const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
    const dvec3 axis = x <= y && x <= z ? dvec3{1, 0, 0} : y <= z ? dvec3{0, 1, 0} : dvec3{0, 0, 1};
    return normalize_or(axis - n * dot(n, axis), dvec3{1, 0, 0});
}

}  // namespace rakelight::geometry
