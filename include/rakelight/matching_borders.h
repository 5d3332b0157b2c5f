// SPDX-License-Identifier: Apache-2.0
// Seams between meshes whose borders run along each other without sharing vertices: T-junctions, gaps, parts that were
// remeshed one by one. Needs no scene: spans and matrices in, the few vertices that turn out.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <rakelight/attributes.h>
#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/seams.h>
#include <rakelight/vector.h>

namespace rakelight {

/// Which borders match.
struct MatchOptions {
    double distance = 0;                        ///< [m] in the world, > 0: how far borders may be from one another
    Scope scope = Scope::model;                 ///< `object`: only meshes of one object match; `face`: none
    double crease_angle_rad = radians(60);      ///< as AttributeOptions::crease_angle_rad, over the gap
    double weld_distance = -1;                  ///< as AttributeOptions::weld_distance
    CornerWeight weight = CornerWeight::angle;  ///< by which votes of both sides are summed
    /// Borders both of whose faces are authored flat and differ by more than `authored_flat_deg` stay apart: for normals
    /// that somebody authored.
    bool keep_flat = false;
    bool operator==(const MatchOptions&) const = default;
};

/// What became of all meshes. Lengths are of open edges (of one face in the whole model), those of both sides.
struct MatchReport {
    std::uint64_t leading = 0, following = 0;  ///< border vertices; those at one place with one normal count once
    std::uint64_t turned = 0;                  ///< vertices of the meshes
    double max_deg = 0, mean_deg = 0;          ///< by which they turned, in the world
    std::uint64_t vertices_not_searched = 0;   ///< border vertices, to the end: no model has these, an attack may
    bool operator==(const MatchReport&) const = default;
};

/// Which border vertices follow which edges: found once, used for any pose of the same meshes. Immutable; cheap to copy.
/// Its size is that of the borders.
class RL_API BorderMatch {
public:
    struct Impl;
    /// Of the library itself.
    explicit BorderMatch(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
    /// Of the library itself.
    const Impl& impl() const { return *impl_; }
    bool is_empty() const;  ///< no borders match

private:
    std::shared_ptr<const Impl> impl_;
};

/// Finds the open edges of different meshes that run along each other, after welding as everywhere
/// (AttributeOptions::weld_distance): edges that a weld joins are not open.
///
/// 1. *Matching.* A border vertex matches the nearest point within `distance` of an open edge of another mesh if the two
///    faces' normals differ by at most the crease angle; both edges, each as its own face goes round, run in opposite
///    directions within 60 degrees; and the two faces do not lie over one another by more than half of `distance`. So
///    plates that lie on each other, shells back to back and overlapping scales stay apart.
///    A stretch of matches that is shorter than ten times the distance is none: cards and leaves of that size meet
///    anywhere.
/// 2. *Leading.* Along each connected stretch on which two meshes match, the side with fewer border vertices leads (tie:
///    lower object, then lower mesh). Where several meshes could lead a vertex, the one with the fewest does. Links are
///    at most four long, so that no chain of near matches runs away.
///
/// Vertices at one place whose normals are equal (`authored_equality`) are one, across meshes: what is welded stays so.
/// Expected O(n) + O(b log b) for b border edges. The same bits for any number of threads.
/// @param meshes  each with `normals`; smoothing groups, hints, locks and texture coordinates are not read
/// @throws Error usage: options out of range; bad_file: as group()
RL_API BorderMatch match_borders(std::span<const AttributeMesh> meshes, const MatchOptions& options, Context& context);

/// The normals: a leading vertex gets the sum of its own votes (unit normal times the weights of its corners) and of
/// those of the vertices that follow its edges, shared out by hat weights along the edge; a following vertex gets the
/// normalized linear interpolation of the unit normals at the ends of the edge that it follows. Vertices that turn by no more
/// than 0.01 degrees keep their bits.
/// Tangents of vertices that turn go likewise where charts agree: of one handedness and within 45 degrees; else they turn
/// along with their normals.
///
/// Between the vertices of the leading side the following normals bend away from the leading straight interpolation by
/// at most h^2/8 times the second derivative of the field of normals along the border (h: the leading edge's length).
/// @param meshes    as they were matched; positions and normals may have moved
/// @param tangents  [meshes] [V] each or empty; or none at all
/// @return one entry a mesh
/// @throws Error bad_file: other counts than were matched
RL_API std::vector<MeshSeams> join_borders(const BorderMatch& match, std::span<const AttributeMesh> meshes,
                                           std::span<const std::span<const vec4>> tangents, MatchReport& report,
                                           Context& context);

/// An angle along borders, weighted by length; p95: 95 % of the length are at most this.
struct CurveAngles {
    double max_deg = 0, mean_deg = 0, p95_deg = 0;  ///< [degrees]
};

/// A piece of an open edge that runs along another mesh's.
struct BorderSample {
    dvec3 a{}, b{};       ///< [m] world: its ends
    double turn_deg = 0;  ///< by which normals turn along the edge, the other one and their neighbors, at most
    double deg = 0;       ///< between the interpolated normals of both sides in its middle
    double gap = 0;       ///< [m]
    std::uint32_t mesh = 0, other_mesh = 0;  ///< the edge's mesh; the other one: numbers of `meshes`
};

/// What measure_borders() found.
struct BorderMeasure {
    double open_length = 0;                ///< [m] of all open edges
    double matched_length = 0;             ///< of these
    CurveAngles seam{};                    ///< along what is matched
    double gap_max = 0, gap_mean = 0;      ///< [m] along what is matched
    std::vector<BorderSample> samples{};   ///< of what is matched; in the order of meshes and triangles
    std::uint64_t edges_not_searched = 0;  ///< open edges, to the end
};

/// Measures along the curve how far the normals of both sides are apart, at four places of every open edge, by the rule
/// of match_borders() for points of edges in place of vertices.
RL_API BorderMeasure measure_borders(std::span<const AttributeMesh> meshes, const MatchOptions& options,
                                     Context& context);

/// A distance for MatchOptions from the gaps that there are: open edges of different meshes that run along one other mesh from
/// end to end by the rule of match_borders(), no farther away than half of the edge, with gaps that differ by at most a
/// quarter of it. A little more than the gap that 98 % of their length keep to, in two digits. 0: no borders do. Of
/// more than 4096 open edges as many are asked, spread over all.
/// @param options  `distance` is not read
RL_API double proposed_border_distance(std::span<const AttributeMesh> meshes, const MatchOptions& options,
                                       Context& context);

}  // namespace rakelight
