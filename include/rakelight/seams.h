// SPDX-License-Identifier: Apache-2.0
// Seams between meshes closed where they are, in normals that somebody authored. Needs no scene: spans and matrices in,
// the few vertices that turn out.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/vector.h>

namespace rakelight {

/// Corners of one mesh at one place whose normals differ by at most this much are one fan [length of the difference of two
/// unit normals].
inline constexpr double authored_equality = 1e-3;
/// A corner's normal this near to its face's is that face's own, and faces this near to one another do not differ [degrees].
inline constexpr double authored_flat_deg = 1;

/// Where meshes are joined.
struct SeamOptions {
    double crease_angle_rad = radians(60);  ///< as AttributeOptions::crease_angle_rad; that of a mesh goes before it
    double weld_distance = -1;              ///< as AttributeOptions::weld_distance
};

/// What became of all meshes.
struct SeamReport {
    std::uint64_t normals = 0;         ///< that faces use
    std::uint64_t turned = 0;          ///< of these
    double max_deg = 0, mean_deg = 0;  ///< by which they turned, in the world
    std::uint64_t flat_pairs = 0;      ///< pairs of faces at an edge of two meshes that stay flat
    std::uint64_t unusable = 0;        ///< normals that are zero or not finite: they stay as they are
    bool operator==(const SeamReport&) const = default;
};

/// The vertices of one mesh that turn.
struct MeshSeams {
    std::vector<std::uint32_t> vertices{};  ///< ascending
    std::vector<vec3> normals{};            ///< [vertices] unit, object space
    /// [vertices], or empty: all turn along with their normals. w = 0: this one does.
    std::vector<vec4> tangents{};
};

/// Joins the given normals of meshes along the edges that they share, and only there: a repair, where compute_attributes()
/// is a rewrite.
///
/// 1. *Fans.* At each place that corners of several meshes share (which places are one: AttributeOptions::weld_distance),
///    the corners of one mesh whose normals are equal within `authored_equality` are one fan; where one mesh has more than
///    64 different normals at a place, those that are equal to the bit. Authors draw hard edges below any crease angle, so
///    what the normals of a mesh say goes before its angles: no two fans of one mesh are ever joined.
/// 2. *Joints.* Two fans of different meshes join if a face of each meets the other at an edge that begins at the place and
///    the faces' normals differ by at most the crease angle. They stay apart where both faces are authored flat (all three
///    corners have the face's own normal, within `authored_flat_deg`) and differ by more than that: a hard edge between
///    two parts. Where joints would bring two fans of one mesh together, those whose authored normals are nearest go first.
/// 3. *Normals.* Joined fans get one normal: the sum in the world of each fan's unit normal times the sum of its corners'
///    angles (Thuermer & Wuethrich 1998, "Computing Vertex Normals from Polygonal Facets", with the authored normal in
///    place of the facets'). Each keeps its own where that sum vanishes, and where all are within 0.01 degrees already.
///
/// No vertex is split: one vertex has one authored normal, so all its corners are in one fan. Meshes that mirror are
/// seen in the world as everywhere (cofactor matrix and the sign of the determinant). Expected O(n), the same bits for any
/// number of threads; the order of meshes, vertices and faces has no influence but on the rounding of sums.
/// @param meshes  each with `normals`; smoothing groups, hints, locks and texture coordinates are not read
/// @return one entry a mesh
/// @throws Error bad_file: as group()
RL_API std::vector<MeshSeams> join_seams(std::span<const AttributeMesh> meshes, const SeamOptions& options,
                                         SeamReport& report, Context& context);

/// A tangent [xyz unit, w] that turns with its normal: by the smallest rotation from `from` to `to` (unit), then made
/// perpendicular to `to`; w stays. Where the normal turns to its opposite, or the tangent lies along it: some
/// perpendicular.
RL_API vec4 turned_tangent(vec4 tangent, vec3 from, vec3 to);
/// A vector by the same rotation.
RL_API vec3 turned_along(vec3 vector, vec3 from, vec3 to);

}  // namespace rakelight
