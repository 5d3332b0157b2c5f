// SPDX-License-Identifier: Apache-2.0
// Tangent frames of normal maps, as in src/lighting/relief/normal_map.glsl, in double.
#pragma once
#include <cmath>

#include "math/linear.h"

namespace rakelight::bake {

struct TangentFrame {
    dvec3 tangent, bitangent, normal;
};

/// As interpolated: bitangent = cross(normal, tangent) * handedness (Mikkelsen 2008, "Simulation of Wrinkled Surfaces
/// Revisited", as its users rebuild it in each pixel).
inline TangentFrame interpolated_frame(dvec3 normal, dvec3 tangent, double handedness) {
    return {tangent, cross(normal, tangent) * handedness, normal};
}

/// Unit, and the tangent made perpendicular first: orthogonal_tangent() of normal_map.glsl.
inline TangentFrame unit_frame(dvec3 normal, dvec3 tangent, double handedness) {
    const dvec3 n = normalize_or(normal, dvec3{0, 0, 1});
    const double along = dot(n, tangent);
    dvec3 across = tangent - n * along;
    const dvec3 axis = std::fabs(n.x) > 0.7 ? dvec3{0, 1, 0} : dvec3{1, 0, 0};
    if (!(dot(across, across) > 1e-12 * along * along)) across = axis - n * dot(n, axis);
    const dvec3 t = normalize_or(across, axis);
    return {t, cross(n, t) * handedness, n};
}

/// Coordinates of `v` in the frame, up to a positive factor, by the inverse matrix (cross products of its columns over
/// the determinant). False for singular frames.
inline bool in_frame(const TangentFrame& f, dvec3 v, dvec3& out) {
    const dvec3 rows[3] = {cross(f.bitangent, f.normal), cross(f.normal, f.tangent), cross(f.tangent, f.bitangent)};
    const double determinant = dot(f.tangent, rows[0]);
    if (!(std::fabs(determinant) > 1e-12)) return false;
    out = dvec3{dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)} / determinant;
    return true;
}

}  // namespace rakelight::bake
