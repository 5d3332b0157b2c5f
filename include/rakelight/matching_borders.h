// SPDX-License-Identifier: Apache-2.0
// Repairs seams between meshes with adjacent borders that share no vertices: T-junctions, gaps, separately remeshed
// parts. Needs no Scene: spans and matrices in, the changed vertices out.
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

/// Options of match_borders().
struct MatchOptions {
    double distance = 0;                        ///< [m] in world space, > 0: largest gap between matching borders
    Scope scope = Scope::model;                 ///< `object`: only meshes of one object match; `face`: none
    double crease_angle_rad = radians(60);      ///< as AttributeOptions::crease_angle_rad, across the gap
    double weld_distance = -1;                  ///< as AttributeOptions::weld_distance
    CornerWeight weight = CornerWeight::angle;  ///< weight of the votes of both sides
    /// For authored normals: borders stay separate if both faces are authored flat and differ by more than
    /// `authored_flat_deg`.
    bool keep_flat = false;
    bool operator==(const MatchOptions&) const = default;
};

/// Statistics over all meshes.
struct MatchReport {
    std::uint64_t leading = 0, following = 0;  ///< border vertices; vertices at one place with equal normals count once
    std::uint64_t turned = 0;                  ///< changed vertices of the meshes
    double max_deg = 0, mean_deg = 0;          ///< angle of the change, in world space
    std::uint64_t vertices_not_searched = 0;   ///< border vertices whose search was cut off; only in hostile files
    bool operator==(const MatchReport&) const = default;
};

/// The matched border vertices and edges. Computed once, valid for any pose of the same meshes. Immutable; cheap to
/// copy. Its size is proportional to that of the borders.
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

/// Finds adjacent open edges of different meshes, after welding (AttributeOptions::weld_distance): welded edges are not
/// open.
///
/// 1. *Matching.* A border vertex matches the nearest point within `distance` of an open edge of another mesh if three
///    conditions hold. The normals of the two faces differ by at most the crease angle. The two edges, in the winding
///    of their faces, run in opposite directions within 60 degrees. The faces do not overlap by more than half of
///    `distance`. So stacked plates, back-to-back shells and overlapping scales stay separate. Matching stretches
///    shorter than ten times the distance are ignored: small cards and leaves touch anywhere.
/// 2. *Leading.* On each connected stretch where two meshes match, the side with fewer border vertices leads (tie:
///    lower object, then lower mesh). If several meshes could lead a vertex, the one with the fewest border vertices
///    does. Chains of links are at most four long.
///
/// Vertices at one place with equal normals (`authored_equality`) count as one, across meshes, so welded vertices stay
/// welded. Expected O(n) + O(b log b) for b border edges. Bit-identical for any number of threads.
/// @param meshes  each with `normals`; smoothing groups, hints, locks and texture coordinates are not read
/// @throws Error usage: options out of range; bad_file: as group()
RL_API BorderMatch match_borders(std::span<const AttributeMesh> meshes, const MatchOptions& options, Context& context);

/// Computes the normals. A leading vertex gets the sum of its own votes (unit normal times the weights of its corners)
/// and the votes of vertices that follow its edges, distributed by hat functions along the edge. A following vertex
/// gets the normalized linear interpolation of the normals at the ends of its edge. Changes of at most 0.01 degrees are
/// not applied. Tangents are treated in the same way where charts agree: equal handedness, within 45 degrees. Else they
/// rotate with their normals.
///
/// Between leading vertices the interpolated normals of both sides differ by at most h^2/8 times the second derivative
/// of the normal field along the border (h: length of the leading edge).
/// @param meshes as given to match_borders(); positions and normals may have changed
/// @param tangents [meshes] of [V] or empty each; or empty
/// @return one entry per mesh
/// @throws Error bad_file: other counts than were matched
RL_API std::vector<MeshSeams> join_borders(const BorderMatch& match, std::span<const AttributeMesh> meshes,
                                           std::span<const std::span<const vec4>> tangents, MatchReport& report,
                                           Context& context);

/// Statistics of an angle along borders, weighted by length; p95: 95th percentile.
struct CurveAngles {
    double max_deg = 0, mean_deg = 0, p95_deg = 0;  ///< [degrees]
};

/// A piece of an open edge that matches another mesh.
struct BorderSample {
    dvec3 a{}, b{};       ///< [m] world: end points
    double turn_deg = 0;  ///< largest change of the normals along the edge, the other edge and their neighbors
    double deg = 0;       ///< between the interpolated normals of both sides at the middle
    double gap = 0;       ///< [m]
    std::uint32_t mesh = 0, other_mesh = 0;  ///< meshes of the edge and of the other side, into `meshes`
};

/// Result of measure_borders().
struct BorderMeasure {
    double open_length = 0;                ///< [m] total length of open edges
    double matched_length = 0;             ///< of these
    CurveAngles seam{};                    ///< along matched edges
    double gap_max = 0, gap_mean = 0;      ///< [m] along matched edges
    std::vector<BorderSample> samples{};   ///< along matched edges; in the order of meshes and triangles
    std::uint64_t edges_not_searched = 0;  ///< open edges whose search was cut off
};

/// Measures the angle between the normals of both sides along matching borders, at four points of every open edge.
/// Points match by the rules of match_borders().
RL_API BorderMeasure measure_borders(std::span<const AttributeMesh> meshes, const MatchOptions& options,
                                     Context& context);

/// Proposes MatchOptions::distance from the gaps of a model. It uses open edges that match one other mesh over their
/// whole length. The gap must be at most half the edge's length, and vary by at most a quarter of it. The result is
/// slightly more than the 98th percentile of the gaps by length, rounded to two digits. 0: there are no such borders.
/// At most 4096 open edges are examined, evenly distributed.
/// @param options  `distance` is not read
RL_API double proposed_border_distance(std::span<const AttributeMesh> meshes, const MatchOptions& options,
                                       Context& context);

}  // namespace rakelight
