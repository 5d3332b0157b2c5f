// SPDX-License-Identifier: Apache-2.0
// Repairs seams between meshes with authored normals. Needs no Scene: spans and matrices in, the changed vertices out.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/vector.h>

namespace rakelight {

/// Corners of one mesh at one place form one fan if their normals differ by at most this much [length of the difference
/// of two unit normals].
inline constexpr double authored_equality = 1e-3;
/// [degrees] A corner normal this close to the face normal counts as flat; faces this close to each other count as
/// coplanar.
inline constexpr double authored_flat_deg = 1;

/// Options of join_seams().
struct SeamOptions {
    double crease_angle_rad =
        radians(60);            ///< as AttributeOptions::crease_angle_rad; AttributeMesh::crease_angle_rad overrides it
    double weld_distance = -1;  ///< as AttributeOptions::weld_distance
};

/// Statistics over all meshes.
struct SeamReport {
    std::uint64_t normals = 0;         ///< normals used by faces
    std::uint64_t turned = 0;          ///< of these, changed
    double max_deg = 0, mean_deg = 0;  ///< angle of the change, in world space
    std::uint64_t flat_pairs = 0;      ///< pairs of faces at a common edge of two meshes that stay flat
    std::uint64_t unusable = 0;        ///< zero or non-finite normals, which are not changed
    bool operator==(const SeamReport&) const = default;
};

/// The changed vertices of one mesh.
struct MeshSeams {
    std::vector<std::uint32_t> vertices{};  ///< ascending
    std::vector<vec3> normals{};            ///< [vertices] unit, object space
    /// [vertices], or empty: rotate all tangents with their normals (turned_tangent()). w = 0: rotate this one.
    std::vector<vec4> tangents{};
};

/// Joins the given normals of meshes along their common edges, and only there. It repairs normals, while
/// compute_attributes() replaces them.
///
/// 1. *Fans.* Places are positions welded by AttributeOptions::weld_distance. At each place with corners of several
///    meshes, the corners of one mesh with equal normals (`authored_equality`) form one fan. If a mesh has more than 64
///    different normals at a place, only bit-equal ones do. Hard edges can be authored at any angle, so the normals of
///    a mesh take precedence over its angles: two fans of one mesh are never joined.
/// 2. *Joints.* Two fans of different meshes join if a face of each shares an edge that begins at the place, and the
///    face normals differ by at most the crease angle. They stay separate if both faces are authored flat (all three
///    corners have the face normal, within `authored_flat_deg`) and differ by more than that: a hard edge between two
///    parts. If joints would connect two fans of one mesh, pairs with the closest authored normals are joined first.
/// 3. *Normals.* Joined fans get one normal: the sum in world space of each fan's unit normal times the sum of its
///    corner angles (Thuermer & Wuethrich 1998, "Computing Vertex Normals from Polygonal Facets", with authored normals
///    in place of facet normals). Fans keep their normals if that sum vanishes, or if all are already within 0.01
///    degrees.
///
/// No vertex is split: a vertex has one authored normal, so all its corners are in one fan. Mirrored meshes are handled
/// in world space (cofactor matrix and sign of the determinant). Expected O(n); bit-identical for any number of
/// threads. The order of meshes, vertices and faces only affects the rounding of sums.
/// @param meshes each with `normals`; smoothing groups, hints, locks and texture coordinates are not read
/// @return one entry per mesh
/// @throws Error bad_file: as group()
RL_API std::vector<MeshSeams> join_seams(std::span<const AttributeMesh> meshes, const SeamOptions& options,
                                         SeamReport& report, Context& context);

/// A tangent [xyz unit, w] rotated with its normal: by the smallest rotation from `from` to `to` (unit), then
/// orthogonalized against `to`; w is kept. If the normals are opposite, or the tangent is parallel to the normal: an
/// arbitrary perpendicular.
RL_API vec4 turned_tangent(vec4 tangent, vec3 from, vec3 to);
/// A vector rotated in the same way.
RL_API vec3 turned_along(vec3 vector, vec3 from, vec3 to);

}  // namespace rakelight
