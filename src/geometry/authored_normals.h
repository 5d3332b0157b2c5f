// SPDX-License-Identifier: Apache-2.0
// Tolerances for authored normals: equality of two normals, flatness of a face, negligible rotation.
#pragma once
#include <rakelight/seams.h>

#include <algorithm>
#include <span>

#include "math/angles.h"
#include "math/linear.h"

namespace rakelight::geometry {

constexpr double continuous_rad = radians(0.01);        // smaller angles are rounding, or 16-bit quantization
constexpr double cosine_of_flat = 0.99984769515639124;  // of authored_flat_deg
static_assert(authored_flat_deg == 1);

/// Equality of unit vectors of one mesh.
inline bool are_one_normal(dvec3 a, dvec3 b) { return dot(a - b, a - b) <= authored_equality * authored_equality; }

/// Whether normals of a face's corners make it flat: those of the face, or one that a bent polygon shares.
/// @param corners  unit, world space; zero: unusable
/// @param face     unit, world space
inline bool are_authored_flat(std::span<const dvec3> corners, dvec3 face) {
    constexpr double least_of_polygon = 0.70710678118654752;  // a polygon that bends by less
    const auto all = [&](const auto& is) { return std::ranges::all_of(corners, is); };
    return !corners.empty() && face != dvec3{} &&
           (all([&](dvec3 n) { return dot(n, face) >= cosine_of_flat; }) ||
            (corners.size() > 1 && dot(corners[0], face) >= least_of_polygon &&
             all([&](dvec3 n) { return are_one_normal(n, corners[0]); })));
}

/// [rad] 0..pi; accurate for small angles.
inline double angle_between(dvec3 a, dvec3 b) { return math::arc_tangent(length(cross(a, b)), dot(a, b)); }

}  // namespace rakelight::geometry
