// SPDX-License-Identifier: Apache-2.0
// Tolerances for authored normals: equality of two normals, flatness of a face, negligible rotation.
#pragma once
#include <rakelight/geometry/seams.h>

#include <algorithm>
#include <span>

#include "geometry/input/face_vote.h"
#include "math/functions.h"
#include "math/linear.h"

namespace rakelight::geometry {

constexpr double continuous_rad = radians(0.01);        // smaller angles are rounding, or 16-bit quantization
constexpr double cosine_of_flat = 0.99984769515639124;  // of authored_flat_deg
static_assert(authored_flat_deg == 1);

/// Equality of unit vectors of one mesh.
inline bool are_one_normal(dvec3 a, dvec3 b) { return dot(a - b, a - b) <= authored_equality * authored_equality; }

constexpr double cosine_of_square = 0.99619469809174555;  // 5 degrees: how exporters average two bent triangles

/// The normal of the square that a triangle makes with the triangle before or after it, as files have squares: by the
/// sum of their areas, unit, world space; zero: there is none.
/// @param authored  of the triangle, unit, world space: of two squares that of the nearer normal
inline dvec3 square_normal(const AttributeMesh& mesh, const Placement& placement, std::uint32_t triangle,
                           dvec3 authored) {
    const std::uint32_t* const own = mesh.indices.data() + 3 * std::size_t(triangle);
    const auto area = [&](const std::uint32_t* index) {
        const Direction n = face_normal(placement, face_corners(mesh, index));
        return n.unit * n.length;
    };
    dvec3 best{};
    for (const int step : {-3, 3}) {
        if ((step < 0 && triangle == 0) || (step > 0 && 3 * std::size_t(triangle) + 5 >= mesh.indices.size())) continue;
        const std::uint32_t* const other = own + step;
        const auto is_own = [&](std::uint32_t v) { return v == own[0] || v == own[1] || v == own[2]; };
        if (std::count_if(other, other + 3, is_own) != 2) continue;
        const dvec3 n = normalize_or(area(own) + area(other), {});
        if (best == dvec3{} || dot(n, authored) > dot(best, authored)) best = n;
    }
    return best;
}

/// Whether the normals of a triangle's corners make it flat: those of the triangle, or one, which is that of its square.
/// @param corners  unit, world space; zero: unusable
/// @param face     unit, world space
inline bool are_authored_flat(std::span<const dvec3> corners, dvec3 face, dvec3 square) {
    const auto all = [&](const auto& is) { return std::ranges::all_of(corners, is); };
    return face != dvec3{} && (all([&](dvec3 n) { return dot(n, face) >= cosine_of_flat; }) ||
                               (corners.size() > 1 && dot(corners[0], square) >= cosine_of_square &&
                                all([&](dvec3 n) { return are_one_normal(n, corners[0]); })));
}

/// [rad] 0..pi; accurate for small angles. 0 where one has no length: adding 0 makes a product of -0 positive.
inline double angle_between(dvec3 a, dvec3 b) { return math::atan2(length(cross(a, b)), dot(a, b) + 0.0); }

}  // namespace rakelight::geometry
