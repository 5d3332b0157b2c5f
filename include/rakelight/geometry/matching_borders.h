// SPDX-License-Identifier: Apache-2.0
// Repairs seams between meshes with adjacent borders that share no vertices: T-junctions, gaps, separately remeshed
// parts. Needs no Scene: spans and matrices in, the changed vertices out.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/geometry/attributes.h>
#include <rakelight/geometry/seams.h>
#include <rakelight/math/vector.h>

namespace rakelight {

/// Options of match_borders().
struct MatchOptions {
    double distance = 0;                    ///< [m] in world space, > 0: maximum gap between matching borders
    Scope scope = Scope::model;             ///< `object`: meshes match only within one object; `face`: no meshes match
    double crease_angle_rad = radians(60);  ///< as AttributeOptions::crease_angle_rad, for the faces at the gap
    double weld_distance = -1;              ///< as AttributeOptions::weld_distance
    /// Weight of normals in the sums of join_borders(). With `fit` and `automatic`, normals of leading vertices are
    /// fitted to the positions of both sides, unless `keep_flat` says that some normals are authored.
    CornerWeight weight = CornerWeight::angle;
    /// For authored normals: borders stay separate if the faces of both sides are authored flat and their normals
    /// differ by more than `authored_flat_deg` (seams.h).
    bool keep_flat = false;
    bool operator==(const MatchOptions&) const = default;
};

/// Statistics over all meshes.
struct MatchReport {
    /// Border vertices that lead and that follow, see match_borders(). Vertices with equal position and normal count
    /// once.
    std::uint64_t leading = 0, following = 0;
    std::uint64_t turned = 0;          ///< changed vertices of the meshes
    double max_deg = 0, mean_deg = 0;  ///< [degrees] angle of the changes, in world space
    /// Border vertices with so many open edges nearby that not all were compared. This happens only in hostile files.
    std::uint64_t vertices_not_searched = 0;
    bool operator==(const MatchReport&) const = default;
};

/// The matched border vertices and edges. Computed once, valid for any pose of the same meshes. Immutable; cheap to
/// copy. Its memory is proportional to the number of border edges.
class RL_API BorderMatch {
public:
    struct Impl;
    /// For use by the library only.
    explicit BorderMatch(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
    /// For use by the library only.
    const Impl& impl() const { return *impl_; }
    bool is_empty() const;  ///< no borders match

private:
    std::shared_ptr<const Impl> impl_;
};

/// Finds adjacent open edges of different meshes. An open edge has one face after welding
/// (AttributeOptions::weld_distance). A border vertex is a vertex of an open edge.
///
/// 1. *Matching.* A border vertex looks for the nearest point on an open edge of another mesh, within `distance`. It
///    matches this point if three conditions hold. The normals of the two faces differ by at most the crease angle. The
///    two edges, in the winding of their faces, run in opposite directions, within 60 degrees. The two faces overlap by
///    at most half of `distance`. So stacked plates, back-to-back shells and overlapping scales stay separate. A
///    matching stretch shorter than ten times the distance is ignored, because small cards and leaves touch by chance.
/// 2. *Leading.* On each connected stretch where two meshes match, the side with fewer border vertices leads, and the
///    other side follows. In a tie the lower object leads, then the lower mesh. If several meshes could lead a vertex,
///    the mesh with the fewest border vertices leads it. A leader may itself follow another vertex; such a chain has at
///    most four links.
///
/// Vertices with equal position and equal normal (`authored_equality`) count as one vertex, also across meshes. So
/// welded vertices stay welded. Expected O(n) + O(b log b) for b border edges. Bit-identical for any number of threads.
/// @param meshes  each with `normals`; smoothing groups, hints, locks and texture coordinates are not read
/// @throws Error usage: options out of range; bad_file: as group()
RL_API BorderMatch match_borders(std::span<const AttributeMesh> meshes, const MatchOptions& options, Context& context);

/// Computes the normals of matched borders. The contribution of a vertex is its unit normal times the sum of the
/// weights of its corners. A leading vertex gets the normalized sum of its own contribution and those of the vertices
/// that follow its edges. A following vertex divides its contribution between the two ends of the leading edge, by hat
/// functions. The following vertex itself gets the normalized linear interpolation of the normals at these two ends.
/// Changes of at most 0.01 degrees are not applied.
///
/// With CornerWeight::fit and CornerWeight::automatic, a leading vertex whose followers do not agree yet gets the normal
/// of a height function fitted to two rings of neighbors on both sides, as far as it is trusted. Where it is not, the
/// sums above: with the weights of `max` beyond gaps, of `angle` where positions are noisy. The rings are found by
/// match_borders(), and hold for all poses.
///
/// Tangents are computed in the same way if both sides have the same handedness and their tangents differ by at most 45
/// degrees. Otherwise each tangent rotates with its normal.
///
/// Between leading vertices the interpolated normals of both sides differ by at most h^2/8 times the second derivative
/// of the normal field along the border (h: length of the leading edge).
/// @param meshes as given to match_borders(); positions and normals may have changed
/// @param tangents [meshes] each [V] or empty; or empty as a whole
/// @return one entry per mesh
/// @throws Error bad_file: counts that differ from those of match_borders()
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
    double turn_deg = 0;  ///< [degrees] largest change of the normals along the two edges and their neighbors
    double deg = 0;       ///< [degrees] angle between the interpolated normals of both sides, at the middle
    double gap = 0;       ///< [m] distance of both sides
    std::uint32_t mesh = 0, other_mesh = 0;  ///< meshes of this edge and of the other edge, into `meshes`
};

/// Result of measure_borders().
struct BorderMeasure {
    double open_length = 0;                ///< [m] total length of open edges
    double matched_length = 0;             ///< [m] total length of matched open edges
    CurveAngles seam{};                    ///< angles between the normals of both sides along matched edges
    double gap_max = 0, gap_mean = 0;      ///< [m] distance of both sides along matched edges
    std::vector<BorderSample> samples{};   ///< pieces of matched edges, in the order of meshes and triangles
    std::uint64_t edges_not_searched = 0;  ///< open edges that were not compared with all edges nearby
};

/// Measures the angle between the normals of both sides along matching borders, at four points of every open edge.
/// Points match by the rules of match_borders().
RL_API BorderMeasure measure_borders(std::span<const AttributeMesh> meshes, const MatchOptions& options,
                                     Context& context);

}  // namespace rakelight
