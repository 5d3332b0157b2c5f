// SPDX-License-Identifier: Apache-2.0
// The vote of one triangle for its corners: its unit normal and tangent in world space, and the weight at each corner.
// Computed in double from differences of positions, which is accurate for edges of 1e-20 and 1e15 and for models far
// from the origin.
#pragma once
#include <cmath>
#include <cstdint>

#include "geometry/input/attribute_input.h"

namespace rakelight::geometry {

/// arctan(y / x) for y >= 0, in 0..pi, from + - * / alone. Abramowitz & Stegun 4.4.49: error at most 2e-8, relative for
/// small angles, which is sufficient for weights.
inline double corner_angle(double y, double x) {
    const double a = std::fabs(x);
    const bool steep = y > a;
    const double t = steep ? a / y : (a > 0 ? y / a : 0.0), s = t * t;
    const double p =
        t *
        (1 + s * (-0.3333314528 +
                  s * (0.1999355085 +
                       s * (-0.1420889944 +
                            s * (0.1065626393 +
                                 s * (-0.0752896400 + s * (0.0429096138 + s * (-0.0161657367 + s * 0.0028662257))))))));
    const double first = steep ? pi / 2 - p : p;
    return x < 0 ? pi - first : first;
}

/// Direction and length of a vector; {0, 0} for zero and non-finite ones.
struct Direction {
    dvec3 unit;
    double length = 0;
};
inline Direction direction_of(dvec3 v) {
    const double square = dot(v, v);
    if (square > 1e-280 && square < 1e280) {
        const double size = std::sqrt(square);
        return {v * (1 / size), size};
    }
    const dvec3 unit = normalize_or(v, dvec3{});
    return {unit, dot(unit, v) > 0 ? dot(unit, v) : 0.0};
}

/// The three corners of one triangle; edges are exact for positions of similar magnitude.
struct FaceCorners {
    dvec3 e1, e2;  ///< object space, from corner 0 to 1 and to 2
};
inline FaceCorners face_corners(const AttributeMesh& mesh, const std::uint32_t* index) {
    const dvec3 p = cast<double>(mesh.positions[index[0]]);
    return {cast<double>(mesh.positions[index[1]]) - p, cast<double>(mesh.positions[index[2]]) - p};
}

/// Unit normal in world space and twice the area. Outward for counter-clockwise faces, also under mirroring matrices.
/// {0, 0} (no vote) for zero area, evaluated in object space where collinear corners give exactly 0, or a non-finite
/// corner.
inline Direction face_normal(const Placement& placement, const FaceCorners& face) {
    return direction_of(placement.normal_to_world * cross(face.e1, face.e2));
}

/// The caller's normal, transformed from object to world space; zero for zero and non-finite ones.
inline dvec3 given_normal(const Placement& placement, vec3 normal) {
    return direction_of(placement.normal_to_world * cast<double>(normal)).unit;
}

/// Whether the vertex keeps its usable normal.
inline bool is_locked(const AttributeMesh& mesh, std::uint32_t vertex) {
    return !mesh.locked.empty() && mesh.locked[vertex] != 0 && is_finite(mesh.normals[vertex]) &&
           !(mesh.normals[vertex] == vec3{});
}

/// The value of AttributeMesh::locked of normals that authors made.
constexpr std::uint8_t authored_lock = 2;
/// Whether the vertex keeps its normal and gives it to the others of its corner group.
inline bool is_authored(const AttributeMesh& mesh, std::uint32_t vertex) {
    return is_locked(mesh, vertex) && mesh.locked[vertex] == authored_lock;
}

/// Max 1999: sine of the angle over the lengths of both edges, from the squares of the lengths.
/// @param a, b, c squares of the edges from corner 0 to 1, from 0 to 2 and from 1 to 2
inline dvec3 max_weights(double area2, double a, double b, double c) {
    const double all = a * b * c;
    if (all > 1e-280 && all < 1e280) {
        const double q = area2 / all;
        return {q * c, q * b, q * a};
    }
    constexpr double most = 1e100;
    const auto weight = [&](double one, double other) {
        const double w = area2 / one / other;
        return w < most ? w : most;
    };
    return {weight(a, b), weight(a, c), weight(b, c)};
}

/// Weights of the three corners of a face; `area2`: twice its area in world space.
template <CornerWeight weight>
inline dvec3 corner_weights(const Placement& placement, const FaceCorners& face, double area2) {
    if constexpr (weight == CornerWeight::uniform) return {1, 1, 1};
    if constexpr (weight == CornerWeight::area) return dvec3{1, 1, 1} * (0.5 * area2);
    const dvec3 a = placement.linear * face.e1, b = placement.linear * face.e2, c = b - a;
    if constexpr (weight == CornerWeight::max) return max_weights(area2, dot(a, a), dot(b, b), dot(c, c));
    const dvec3 angles{corner_angle(area2, dot(a, b)), corner_angle(area2, -dot(a, c)), corner_angle(area2, dot(b, c))};
    return weight == CornerWeight::angle ? angles : angles * (0.5 * area2);
}

/// How texture coordinates lie on a face.
struct TextureEdges {
    double du1, dv1, du2, dv2;
    double sign;  ///< of du1 dv2 - du2 dv1; 0: no area, or not finite
};
inline TextureEdges texture_edges(const AttributeMesh& mesh, const std::uint32_t* index) {
    const vec2 q0 = mesh.texcoords[index[0]], q1 = mesh.texcoords[index[1]], q2 = mesh.texcoords[index[2]];
    const double du1 = double(q1.x) - q0.x, dv1 = double(q1.y) - q0.y, du2 = double(q2.x) - q0.x,
                 dv2 = double(q2.y) - q0.y;
    const double det = du1 * dv2 - du2 * dv1;
    return {du1, dv1, du2, dv2, det > 0 ? 1.0 : det < 0 ? -1.0 : 0.0};
}

/// Unit tangent dP/du in the world, and the handedness there: +1 where (n, t) turn to -dP/dv, -1 where mirrored.
/// hand 0: the texture coordinates have no area, no vote.
struct FaceTangent {
    dvec3 unit;
    double hand = 0;
};
inline FaceTangent face_tangent(const AttributeMesh& mesh, const std::uint32_t* index, const Placement& placement,
                                const FaceCorners& face) {
    const TextureEdges edges = texture_edges(mesh, index);
    if (edges.sign == 0) return {};
    // dP/du = (dv2 e1 - dv1 e2) / det; only the sign of det is left after normalizing.
    const Direction t = direction_of(placement.linear * ((face.e1 * edges.dv2 - face.e2 * edges.dv1) * edges.sign));
    if (!(t.length > 0)) return {};
    // cross(n, t) . dP/dv has the sign of det; the bitangent is -dP/dv (v is stored downwards).
    return {t.unit, -edges.sign * placement.flip};
}

/// The handedness of a face, seen from a given normal that may point to the face's back.
inline double handedness_from(dvec3 given, const Direction& face, double hand) {
    return dot(given, face.unit) < 0 ? -hand : hand;
}

}  // namespace rakelight::geometry
