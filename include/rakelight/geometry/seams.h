// SPDX-License-Identifier: Apache-2.0
// Repairs seams between meshes with authored normals. Needs no Scene: spans and matrices in, the changed vertices out.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/geometry/attributes.h>
#include <rakelight/math/vector.h>

namespace rakelight {

/// Two unit normals count as equal if the length of their difference is at most this.
inline constexpr double authored_equality = 1e-3;
/// [degrees] A corner normal counts as flat if its angle to the face normal is at most this. Two faces count as
/// coplanar if the angle between their face normals is at most this. Two normals at an edge count as smooth across it if
/// the angle between them is at most this.
inline constexpr double authored_flat_deg = 1;
/// An edge between two surfaces is an authored crease if, across the edge, the normals of both differ from their faces by
/// at most this share of the angle between the faces. Where a surface of equal bends is smooth, the share is a half.
inline constexpr double authored_crease_share = 0.23;
/// [degrees] Where no normal elsewhere shows how a surface bends, only an edge that bends by more than this is a crease.
/// It is less than a 30-degree chamfer of a cylinder of 6 columns bends (26.6).
inline constexpr double silent_crease_deg = 25;

/// Treatment of the normals of a file. `seams`: the normals are kept, but joined where meshes meet (join_seams());
/// tangents rotate with their normals. `replaced`: all normals are computed anew.
enum class AuthoredNormals : std::uint8_t { seams, replaced };

/// Options of join_seams().
struct SeamOptions {
    /// As AttributeOptions::crease_angle_rad. AttributeMesh::crease_angle_rad overrides it.
    double crease_angle_rad = radians(60);
    Creasing creases = Creasing::angle;  ///< as AttributeOptions::creases; the rule sees the faces of all these meshes
    double weld_distance = -1;           ///< as AttributeOptions::weld_distance
};

/// Statistics over all meshes.
struct SeamReport {
    std::uint64_t normals = 0;         ///< number of normals that faces use
    std::uint64_t turned = 0;          ///< number of changed normals
    double max_deg = 0, mean_deg = 0;  ///< [degrees] angle of the changes, in world space
    std::uint64_t flat_pairs = 0;      ///< pairs of faces of two meshes that stay flat at their common edge
    std::uint64_t crease_pairs = 0;  ///< pairs of faces of two meshes that keep an authored crease; without flat_pairs
    std::uint64_t unusable = 0;      ///< zero or non-finite normals, which are not changed
    bool operator==(const SeamReport&) const = default;
};

/// The changed vertices of one mesh.
struct MeshSeams {
    std::vector<std::uint32_t> vertices{};  ///< ascending
    std::vector<vec3> normals{};            ///< [vertices] unit, object space
    /// [vertices] new tangents; if w is 0, rotate the old tangent with its normal (turned_tangent()). Empty: rotate all
    /// tangents.
    std::vector<vec4> tangents{};
};

/// Joins the given normals of meshes along their common edges. All other normals stay. compute_attributes(), in
/// contrast, replaces all normals.
///
/// 1. *Fans.* Positions are welded as by compute_attributes(). At each position with corners of several meshes, the
///    corners of one mesh with equal normals (`authored_equality`) form one fan. If a mesh has more than 64 different
///    normals at a position, only corners with bit-equal normals form a fan. Two fans of one mesh are never joined,
///    because an author may place a hard edge at any angle.
/// 2. *Joints.* Two fans of different meshes are joined if two conditions hold. A face of each fan uses the same edge
///    at the position, and this edge is soft. An edge is soft if the normals of these faces differ by at most the crease
///    angle. With Creasing::automatic, it is soft by the rule of find_creases(), or if its normals at the position were
///    authored so: those of both sides differ by at most `authored_flat_deg`. Two kinds of soft edges are hard
///    nevertheless, because their normals were authored so:
///    - Both faces are authored flat, but not coplanar, or their corner normals differ by over 3 degrees. A face is
///      authored flat if its corners have the face normal, within `authored_flat_deg`, or all one normal
///      (`authored_equality`), which is, within 5 degrees, that of a square: of the face and the one before or after it.
///    - Both fans end in an authored crease: neither bends across the edges that they share. The *lean* of a fan is the
///      largest angle between a face of the fan and the normals of the face's corners, in the plane perpendicular to
///      that one of these edges that gives the smaller angle. Both leans are at most `authored_crease_share` of the
///      angle between the faces at the edge. If all other corners of a fan's faces are at positions of several meshes,
///      these faces do not show how the surface bends. Then the edge must bend by more than `silent_crease_deg`, and
///      the whole angles at the position count.
///
///    Of a face's corners, the corner at the position counts, and those at positions of only one mesh. Fans of more than
///    64 corners are measured at the edges only. If joints would connect two fans of one mesh, the fans with the closest
///    authored normals are joined first. The steps are repeated with the new normals until nothing turns, so that a
///    second call changes nothing. This takes fewer rounds than fans meet at the position; it ends after 64.
/// 3. *Normals.* Joined fans get one normal. It is a weighted sum of the unit normals of the fans, in world space. The
///    weight of a fan is the sum of its corner angles (Thuermer & Wuethrich 1998, "Computing Vertex Normals from
///    Polygonal Facets", with authored normals in place of facet normals). The fans keep their normals if the sum is
///    zero, or if their normals already agree within 0.01 degrees.
///
/// No vertex is split: a vertex has one authored normal, so all its corners are in one fan. Mirrored meshes are handled
/// in world space (cofactor matrix and sign of the determinant). Expected O(n); bit-identical for any number of
/// threads. The order of meshes, vertices and faces only affects the rounding of sums. Creasing::automatic takes the
/// time and memory of find_creases() more, if any edge between two meshes with different normals bends by over 6 degrees.
/// @param meshes each with `normals`; smoothing groups, hints, locks and texture coordinates are not read
/// @return one entry per mesh
/// @throws Error bad_file: as group()
RL_API std::vector<MeshSeams> join_seams(std::span<const AttributeMesh> meshes, const SeamOptions& options,
                                         SeamReport& report, Context& context);

/// A tangent [xyz unit, w] rotated with its normal. The rotation is the smallest one from `from` to `to`, the unit
/// normals before and after. The result is orthogonalized against `to`; w is kept. If the normals are opposite, or the
/// tangent is parallel to the normal, the result is an arbitrary vector perpendicular to `to`.
RL_API vec4 turned_tangent(vec4 tangent, vec3 from, vec3 to);
/// A vector rotated by the same rotation.
RL_API vec3 turned_along(vec3 vector, vec3 from, vec3 to);

}  // namespace rakelight
