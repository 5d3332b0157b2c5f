// SPDX-License-Identifier: Apache-2.0
// Tolerances for authored normals: equality of two normals, flatness of a face, negligible rotation.
#pragma once
#include <rakelight/seams.h>

#include "math/angles.h"
#include "math/linear.h"

namespace rakelight::geometry {

constexpr double continuous_rad = radians(0.01);        // smaller angles are rounding, or 16-bit quantization
constexpr double cosine_of_flat = 0.99984769515639124;  // of authored_flat_deg
static_assert(authored_flat_deg == 1);

/// Equality of unit vectors of one mesh.
inline bool are_one_normal(dvec3 a, dvec3 b) { return dot(a - b, a - b) <= authored_equality * authored_equality; }

/// [rad] 0..pi; accurate for small angles.
inline double angle_between(dvec3 a, dvec3 b) { return math::arc_tangent(length(cross(a, b)), dot(a, b)); }

}  // namespace rakelight::geometry
