// SPDX-License-Identifier: Apache-2.0
// Inspection of a model: objects, materials, textures (not decoded), lights, cameras, surface faults, and seams between
// meshes.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/base/export.h>
#include <rakelight/geometry/creases.h>
#include <rakelight/geometry/matching_borders.h>
#include <rakelight/geometry/seams.h>
#include <rakelight/prepare/prepare.h>
#include <rakelight/render/picture.h>
#include <rakelight/scene/scene.h>
#include <rakelight/tools/draw_seams.h>
#include <rakelight/tools/inspect_check.h>
#include <rakelight/tools/report_row.h>

namespace rakelight {

/// A node with meshes.
struct ObjectSummary {
    /// Name of the node. In world files it is "PART/NODE". It is only "NODE" if the name of the node already begins
    /// with the name of the part.
    std::string name{};
    std::uint32_t node = no_index;                                                 ///< into Scene::nodes
    std::uint64_t meshes = 0, triangles = 0, vertices = 0, lines = 0, points = 0;  ///< sums over the node's meshes
    /// Whether no mesh, some meshes or all meshes have an attribute.
    enum class Has : std::uint8_t { no, some, yes };
    Has normals = Has::no, tangents = Has::no, texcoords = Has::no, colors = Has::no, smoothing_groups = Has::no,
        skin = Has::no, morph_targets = Has::no;
    std::vector<std::string> materials{};  ///< unique names, in the order of the meshes
};

/// Topology and normals of one object's surface. Positions are welded with the automatic distance
/// (AttributeOptions::weld_distance < 0).
struct SurfaceSummary {
    std::uint64_t edges = 0;               ///< edges of the welded triangles
    std::uint64_t open_edges = 0;          ///< edges with one face
    std::uint64_t inconsistent_edges = 0;  ///< edges with two faces of opposite orientation: one is inside out
    std::uint64_t non_manifold_edges = 0;  ///< edges with three or more faces
    bool closed = false;                   ///< the object has edges, but no open edge
    std::uint64_t t_junctions = 0;         ///< vertices of any object in the interior of this object's open edges
    std::uint64_t degenerate_faces = 0;    ///< faces with zero area or a non-finite corner
    /// Normals of the file at used vertices. The length of a non-unit normal differs from 1 by more than 0.01.
    std::uint64_t zero_normals = 0, non_finite_normals = 0, non_unit_normals = 0;
    std::uint64_t mirrored_positions = 0;  ///< positions where mirrored and unmirrored texture charts meet
    /// Vertices that belong to a mirrored and to an unmirrored chart. Computing tangents splits them.
    std::uint64_t mirror_split_vertices = 0;
};

/// A T-junction: a vertex in the interior of an open edge (an edge with one face in the whole model).
struct TJunctionPlace {
    dvec3 position{};  ///< [m] world
    /// `object`: object of the vertex. `edge_object`: object of the edge. Both are indices into Inspection::objects.
    std::uint32_t object = 0, edge_object = 0;
};

/// Statistics of angles over positions. p95: 95th percentile (nearest rank).
struct AngleSummary {
    double max_deg = 0, mean_deg = 0, p95_deg = 0;  ///< [degrees]
};

/// [degrees] Normals at most this far apart count as continuous. The value is larger than the rounding of transforms,
/// and too small to be visible.
inline constexpr double continuous_deg = 0.01;

/// The borders between the meshes of two objects, or between the meshes of one object: the positions that two of these
/// meshes share. The angle at a shared position is the angle between the two closest normals of both meshes. The angle
/// `before` is that of the current normals. The angle `after` is that of the normals that smooth_file() would write
/// (InspectOptions::authored). If smoothing joins faces of both meshes, the position is joined, and the angle `before`
/// of the joined corners is a *seam*. Otherwise the edge between the meshes is a crease. If several pairs of meshes
/// meet at a position, the pair with the largest seam counts, or without a seam the pair with the smallest angle.
struct BorderSummary {
    /// Into Inspection::objects, a <= b. If a == b, the borders are those between the meshes of one object.
    std::uint32_t object_a = 0, object_b = 0;
    /// Into Scene::meshes: the two meshes of the largest seam, of objects a and b.
    std::uint32_t mesh_a = no_index, mesh_b = no_index;
    /// Into Scene::materials: the materials of these two meshes. no_index: no material.
    std::uint32_t material_a = no_index, material_b = no_index;
    std::uint64_t positions = 0;   ///< number of shared positions
    std::uint64_t continuous = 0;  ///< shared positions where `before` is at most continuous_deg
    std::uint64_t joined = 0;      ///< shared positions where `after` is at most continuous_deg; the others are creases
    AngleSummary before{}, after{};
    double seam_deg = 0;                     ///< largest seam: the largest angle `before` at joined positions
    dvec3 seam_position{};                   ///< [m] world: position of seam_deg
    double median_deg = 0, largest_deg = 0;  ///< of the angles `before`; largest_deg == before.max_deg
    std::uint64_t inconsistent_edges = 0;    ///< common edges with faces of opposite orientation
};

/// Two objects with opposite orientation at common edges.
struct InconsistentPair {
    std::uint32_t object_a = 0, object_b = 0;  ///< into Inspection::objects, a < b
    std::uint64_t edges = 0;                   ///< common edges with faces of opposite orientation
};

/// Totals over all shared positions. At a position with several pairs of objects (BorderSummary), the pair with the
/// largest angle counts.
struct SeamTotals {
    std::uint64_t positions = 0, continuous = 0, joined = 0;  ///< as in BorderSummary, each position once
    AngleSummary before{}, after{};
    double seam_deg = 0;  ///< largest seam
    /// Zero and non-finite normals of the file at vertices of triangles. They count as missing, so they are computed for
    /// the angles `before`. 0 if the normals of the file are not used.
    std::uint64_t missing_normals = 0;
    std::uint64_t pairs = 0;  ///< number of BorderSummary
    /// Positions that more than 8 meshes share. Only 8 of these meshes are paired: the 7 with the normals farthest
    /// from the mean normal, and the one with the nearest normal.
    std::uint64_t crowded_positions = 0;
    std::uint64_t pairings_left_out = 0;   ///< pairs at crowded positions that were not examined
    std::uint64_t inconsistent_edges = 0;  ///< common edges of two objects with faces of opposite orientation
    std::string normals_before{};          ///< source of the normals of `before`, for people
    std::string normals_after{};           ///< source of the normals of `after`, for people
    /// Smallest and largest crease angle of `after`. They differ if parts of the model have crease angles of their own.
    double crease_angle_deg = 0, crease_angle_max_deg = 0;
    bool creases_are_automatic = false;  ///< `after` has its creases by the rule, not by these angles
};

/// Two objects with adjacent open borders. Means are weighted by length.
struct MatchedPair {
    /// Into Inspection::objects, a <= b. If a == b, the borders belong to two meshes of one object.
    std::uint32_t object_a = 0, object_b = 0;
    double length = 0;                 ///< [m] matched length of both sides
    double gap_max = 0, gap_mean = 0;  ///< [m] distance of both sides
    CurveAngles before{}, after{};
    double seam_deg = 0;    ///< largest seam, see MatchedSeams
    dvec3 seam_position{};  ///< [m] world: position of the largest seam; without a seam, of the largest angle `before`
};

/// Adjacent open borders of different meshes, see match_borders(). The angle `before` is the angle between the current
/// normals of both sides along the curve. The angle `after` is the angle after smoothing over the whole model and
/// join_borders(). An angle `before` is a *seam* if it is larger than a quarter of the change of the normals along one
/// edge. A smaller angle may be the error of linear interpolation between joined normals.
struct RL_API MatchedSeams {
    double distance = 0;                         ///< [m] InspectOptions::border_distance; 0: not requested
    double open_length = 0, matched_length = 0;  ///< [m] length of all open borders, and of the matched ones
    double unmatched_length() const;             ///< [m] open_length - matched_length
    double seam_deg = 0;                         ///< largest seam of the pairs
    double gap_max = 0, gap_mean = 0;            ///< [m] along matched borders
    CurveAngles before{}, after{};
    std::vector<MatchedPair> pairs{};      ///< at most 10,000, by falling seam_deg, then by the largest angle `before`
    std::uint64_t pairs_left_out = 0;      ///< pairs beyond the first 10,000
    std::uint64_t edges_not_searched = 0;  ///< BorderMeasure::edges_not_searched
};

/// A proposed border distance if none was given: MatchOptions::distance.
struct BorderProposal {
    double distance = 0;        ///< [m] 0: no adjacent borders, or their normals agree within 1 degree
    double open_length = 0;     ///< [m] length of all open borders
    double matched_length = 0;  ///< [m] approximate matched length at the proposed distance
    double gap_max = 0;         ///< [m] largest distance of matched borders
    double seam_deg = 0;        ///< MatchedSeams::seam_deg at the proposed distance
};

/// A line segment of a seam. If meshes share a position but no edge, a and b are equal.
struct SeamLine {
    dvec3 a{}, b{};              ///< [m] world: end points
    float deg_a = 0, deg_b = 0;  ///< [degrees] angles between the normals at the end points a and b
};

/// A closed body of one or several objects with all faces oriented inwards.
struct InsideOutBody {
    std::uint64_t triangles = 0;           ///< of the body
    std::vector<std::uint32_t> objects{};  ///< its objects, into Inspection::objects
};

/// A custom vertex attribute (Mesh::arrays).
struct ArraySummary {
    std::string name{};            ///< as in the file
    std::uint32_t components = 1;  ///< numbers per vertex
    double low = 0, high = 0;      ///< range of the finite numbers of all components; 0 if there are none
    std::uint64_t vertices = 0;    ///< number of vertices with the attribute
    std::uint64_t not_finite = 0;  ///< count of non-finite numbers
};

/// Result of inspect().
struct Inspection {
    /// Scene::source
    std::string file{};
    /// Unit of all lengths: "m", or "units" for formats without units (OBJ, STL, PLY, 3DS, ASE, OFF, X).
    std::string unit = "m";
    std::uint64_t triangles = 0;  ///< each instance counts
    std::vector<ObjectSummary> objects{};
    std::vector<std::uint32_t> material_objects{};    ///< [scene.materials] number of objects that use each material
    std::vector<ArraySummary> arrays{};               ///< in the order of the meshes, one per name
    std::vector<SurfaceSummary> surfaces{};           ///< [objects], or empty if not requested
    std::uint64_t t_junctions = 0;                    ///< positions of T-junctions; each position counts once
    std::vector<TJunctionPlace> t_junction_places{};  ///< at most 1000
    std::vector<InsideOutBody> inside_out{};          ///< at most 1000
    std::uint64_t edges_not_searched = 0;             ///< open edges that were not searched completely for T-junctions
    dvec3 low{}, high{};  ///< [m] world: bounding box of the pose; valid if anything is drawn
    /// true: the scene has skins, morph targets or clips. The bounding box is that of the pose, but seams are those of
    /// the bind pose.
    bool is_posed = false;
    /// Where normals are made (some are missing in the file, or the file's do not count): how creases are found if
    /// InspectOptions::prepare.creases is `automatic`, and what decides normals if `weight` is.
    std::optional<CreaseReport> creases{};
    std::optional<NormalChoices> choices{};
    std::uint64_t shared_positions = 0;  ///< world positions that two or more meshes share; each instance counts
    SeamTotals seams{};
    std::vector<BorderSummary> borders{};  ///< at most 10,000, by falling seam_deg, then by the largest angle
    std::uint64_t borders_left_out = 0;    ///< pairs beyond the first 10,000
    std::vector<InconsistentPair> inconsistent_pairs{};  ///< at most 10,000, by falling number of edges
    MatchedSeams matched{};                              ///< if InspectOptions::border_distance > 0
    BorderProposal proposal{};           ///< if border_distance is 0, and surfaces and borders were examined
    std::vector<SeamLine> seam_lines{};  ///< if InspectOptions::seam_lines
    Scene scene{};  ///< the loaded scene without nodes and meshes: materials, textures, lights, cameras, animations
};

/// Options of inspect().
struct InspectOptions {
    bool borders = true;        ///< find shared positions and measure seams
    bool surfaces = true;       ///< examine edges, faces and normals of each object
    bool seam_lines = false;    ///< store the positions of seams, for draw_seams()
    double weld_distance = -1;  ///< [m] as AttributeOptions::weld_distance
    /// [m] in world space, >= 0, finite. If `borders` is true, also measure seams along adjacent open borders that are
    /// at most this far apart. 0: off.
    double border_distance = 0;
    /// Smoothing for the angles `after`, as SmoothFileOptions::authored. `replaced`: normals smoothed over the whole
    /// model. `seams`: where prepare.normals keeps normals of the file, they are joined where meshes meet
    /// (<rakelight/geometry/seams.h>), and other normals are smoothed over the model. If no normals are kept, all are smoothed.
    AuthoredNormals authored = AuthoredNormals::seams;
    /// prepare.normals gives the normals for the angles `before`. If it is `automatic`, these are the normals of the
    /// file, or normals smoothed per object. Crease angle and weight apply to the normals of `before` and of `after`.
    /// With prepare.measure_orthogonality the report says how far the tangents computed by these options are from
    /// orthogonal.
    PrepareOptions prepare{};
};

/// Inspects a loaded scene. Skinned models are in bind pose. Textures are not decoded. Expected O(n log n) at borders,
/// O(n) elsewhere.
/// @throws Error bad_file: too large for the memory budget, or more than 2^32 vertices and corners
RL_API Inspection inspect(const Scene& scene, const InspectOptions& options, Context& context);

/// A line of text that proposes a border distance. Empty: no proposal.
RL_API std::string proposal_text(const Inspection& inspection);

/// A readable table. Lines end with line feeds. Long lists end with "... N more".
RL_API std::string to_text(const Inspection& inspection);

/// A row of `inspect --json`.
struct InspectionRow : ReportRow {
    std::string file{};  ///< as it was named
    std::optional<Inspection> inspection{};
    std::optional<std::vector<CheckFailure>> check{};  ///< if limits were checked
    std::string heat_map{};                            ///< the written picture, or empty
};

/// {"schema": "rakelight.inspect/1", "rows": [...]}
RL_API std::string to_json(std::span<const InspectionRow> rows);

}  // namespace rakelight
