// SPDX-License-Identifier: Apache-2.0
// Inspection of a model: objects, materials, textures (not decoded), lights, cameras, surface faults, and seams between
// objects.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rakelight/export.h>
#include <rakelight/matching_borders.h>
#include <rakelight/picture.h>
#include <rakelight/prepare.h>
#include <rakelight/scene.h>

namespace rakelight {

/// A node with meshes.
struct ObjectSummary {
    std::string name{};  ///< of the node; in world files "NAME/name" with the name of the part, or only that name
    std::uint32_t node = no_index;                                                 ///< into Scene::nodes
    std::uint64_t meshes = 0, triangles = 0, vertices = 0, lines = 0, points = 0;  ///< sums over its meshes
    /// Whether no mesh, some meshes or all meshes have an attribute.
    enum class Has : std::uint8_t { no, some, yes };
    Has normals = Has::no, tangents = Has::no, texcoords = Has::no, colors = Has::no, smoothing_groups = Has::no,
        skin = Has::no, morph_targets = Has::no;
    std::vector<std::string> materials{};  ///< unique names, in the order of the meshes
};

/// Topology and normals of one object's surface, with positions welded by AttributeOptions::weld_distance < 0.
struct SurfaceSummary {
    std::uint64_t edges = 0;               ///< of the welded triangles
    std::uint64_t open_edges = 0;          ///< with one face
    std::uint64_t inconsistent_edges = 0;  ///< with two faces of opposite orientation: one of them is inside out
    std::uint64_t non_manifold_edges = 0;  ///< with three or more faces
    bool closed = false;                   ///< has edges and no open edge
    std::uint64_t t_junctions = 0;         ///< vertices of any object in the interior of its open edges
    std::uint64_t degenerate_faces = 0;    ///< zero area, or a non-finite corner
    /// Normals of the file at used vertices; non-unit: the length differs from 1 by more than 0.01.
    std::uint64_t zero_normals = 0, non_finite_normals = 0, non_unit_normals = 0;
    std::uint64_t mirrored_positions = 0;     ///< positions where mirrored and unmirrored texture charts meet
    std::uint64_t mirror_split_vertices = 0;  ///< vertices of both charts, which tangents must split
};

/// A T-junction: a vertex in the interior of an open edge (an edge with one face in the whole model).
struct TJunctionPlace {
    dvec3 position{};                           ///< [m] world
    std::uint32_t object = 0, edge_object = 0;  ///< objects of the vertex and of the edge, into Inspection::objects
};

/// Statistics of angles over positions. p95: 95th percentile (nearest rank).
struct AngleSummary {
    double max_deg = 0, mean_deg = 0, p95_deg = 0;  ///< [degrees]
};

/// [degrees] Normals at most this far apart are continuous: above the rounding of transforms, below visibility.
inline constexpr double continuous_deg = 0.01;

/// The border of two objects: the positions that both share, and the angle between their closest normals there.
/// `before`: current normals; `after`: normals smoothed over the whole model. If smoothing joins faces of both objects
/// (their normals are then continuous), the angle before, over the joined corners, is a *seam*. Else the edge between
/// the objects is sharper than the crease angle.
struct BorderSummary {
    std::uint32_t object_a = 0, object_b = 0;  ///< into Inspection::objects, a < b
    std::uint64_t positions = 0;               ///< number of shared positions
    std::uint64_t continuous = 0;              ///< of these: the angle before is at most continuous_deg
    std::uint64_t joined = 0;  ///< of these: the angle after is at most continuous_deg; the others are creases
    AngleSummary before{}, after{};
    double seam_deg = 0;                     ///< largest angle before at joined positions
    dvec3 seam_position{};                   ///< [m] world: position of seam_deg
    double median_deg = 0, largest_deg = 0;  ///< of the angles before; largest_deg == before.max_deg
    std::uint64_t inconsistent_edges = 0;    ///< common edges with faces of opposite orientation
};

/// Two objects with opposite orientation at common edges.
struct InconsistentPair {
    std::uint32_t object_a = 0, object_b = 0;  ///< into Inspection::objects, a < b
    std::uint64_t edges = 0;                   ///< common edges with faces of opposite orientation
};

/// Totals over all shared positions; where several pairs meet, the pair with the largest angle counts.
struct SeamTotals {
    std::uint64_t positions = 0, continuous = 0, joined = 0;  ///< as in BorderSummary, each position once
    AngleSummary before{}, after{};
    double seam_deg = 0;      ///< largest seam
    std::uint64_t pairs = 0;  ///< examined pairs of objects
    /// Positions of more than 8 objects. Only the 7 objects farthest from the mean normal, and the nearest one, are
    /// paired.
    std::uint64_t crowded_positions = 0;
    std::uint64_t pairings_left_out = 0;   ///< pairs at crowded positions that were not examined
    std::uint64_t inconsistent_edges = 0;  ///< edges of two objects of which one is inside out
    std::string normals_before{};          ///< source of the normals `before`, for people
    /// Smallest and largest crease angle of `after`; they differ if parts have their own.
    double crease_angle_deg = 0, crease_angle_max_deg = 0;
};

/// Two objects with adjacent open borders. Means are weighted by length.
struct MatchedPair {
    /// Into Inspection::objects, a <= b; a == b: two meshes of one object
    std::uint32_t object_a = 0, object_b = 0;
    double length = 0;                 ///< [m] matched length of both sides
    double gap_max = 0, gap_mean = 0;  ///< [m]
    CurveAngles before{}, after{};
    double seam_deg = 0;    ///< largest angle before that is a seam, see MatchedSeams
    dvec3 seam_position{};  ///< [m] world: position of seam_deg; without a seam, of the largest angle before
};

/// Adjacent open borders of different meshes, see match_borders(). `before`: angle between the current normals of both
/// sides along the curve. `after`: the same after smoothing over the whole model and join_borders(). A *seam* is an
/// angle before of more than a quarter of the change of the normals along one edge. Below that, it may be the error of
/// linear interpolation between joined normals.
struct RL_API MatchedSeams {
    double distance = 0;                         ///< [m] InspectOptions::border_distance; 0: not requested
    double open_length = 0, matched_length = 0;  ///< [m] length of open borders; of these, matched
    double unmatched_length() const;             ///< [m] open_length - matched_length
    double seam_deg = 0;                         ///< largest seam of the pairs
    double gap_max = 0, gap_mean = 0;            ///< [m] along matched borders
    CurveAngles before{}, after{};
    std::vector<MatchedPair> pairs{};      ///< the largest seam first, then the largest angle before; at most 10,000
    std::uint64_t pairs_left_out = 0;      ///< pairs beyond the first 10,000
    std::uint64_t edges_not_searched = 0;  ///< BorderMeasure::edges_not_searched
};

/// A proposed border distance if none was given: proposed_border_distance().
struct BorderProposal {
    double distance = 0;        ///< [m] 0: no adjacent borders, or their normals agree within 1 degree
    double open_length = 0;     ///< [m]
    double matched_length = 0;  ///< [m] approximate matched length at that distance
    double gap_max = 0;         ///< [m]
    double seam_deg = 0;        ///< MatchedSeams::seam_deg at that distance
};

/// A line segment of a seam; a == b if objects share a position but no edge.
struct SeamLine {
    dvec3 a{}, b{};              ///< [m] world
    float deg_a = 0, deg_b = 0;  ///< [degrees] angle between the normals at a, at b
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
    double low = 0, high = 0;      ///< range of the finite numbers of all components; 0 without any
    std::uint64_t vertices = 0;    ///< vertices with the attribute
    std::uint64_t not_finite = 0;  ///< numbers
};

/// Result of inspect().
struct Inspection {
    /// Scene::source
    std::string file{};
    /// Unit of all lengths: "m", or "units" for formats without units (OBJ, STL, PLY, 3DS, ASE, OFF, X).
    std::string unit = "m";
    std::uint64_t triangles = 0;  ///< each instance counts
    std::vector<ObjectSummary> objects{};
    std::vector<std::uint32_t> material_objects{};    ///< [scene.materials] number of objects that use it; 0: unused
    std::vector<ArraySummary> arrays{};               ///< in the order of the meshes, one per name
    std::vector<SurfaceSummary> surfaces{};           ///< [objects], or empty if not requested
    std::uint64_t t_junctions = 0;                    ///< each position once
    std::vector<TJunctionPlace> t_junction_places{};  ///< at most 1000
    std::vector<InsideOutBody> inside_out{};          ///< at most 1000
    std::uint64_t edges_not_searched = 0;             ///< open edges whose search for T-junctions was cut off
    dvec3 low{}, high{};  ///< [m] world bounding box of the pose; valid if anything is drawn
    /// The scene has skins, morph targets or clips: the box is that of the pose, seams are those of the bind pose.
    bool is_posed = false;
    std::uint64_t shared_positions = 0;  ///< world positions of two or more objects
    SeamTotals seams{};
    std::vector<BorderSummary> borders{};  ///< the largest seam first, then the largest angle; at most 10,000
    std::uint64_t borders_left_out = 0;    ///< pairs beyond the first 10,000
    std::vector<InconsistentPair> inconsistent_pairs{};  ///< the most edges first; at most 10,000
    MatchedSeams matched{};                              ///< if InspectOptions::border_distance > 0
    BorderProposal proposal{};           ///< if border_distance is 0, and surfaces and borders were examined
    std::vector<SeamLine> seam_lines{};  ///< if requested
    Scene scene{};  ///< the loaded scene without nodes and meshes: materials, textures, lights, cameras, animations
};

/// Options of inspect().
struct InspectOptions {
    bool borders = true;        ///< find shared positions and measure seams
    bool surfaces = true;       ///< examine edges, faces and normals of each object
    bool seam_lines = false;    ///< store the positions of seams, for draw_seams()
    double weld_distance = -1;  ///< [m] as AttributeOptions::weld_distance
    /// [m] in world space, >= 0, finite: with `borders`, also measure seams along adjacent open borders at most this
    /// far apart. 0: off.
    double border_distance = 0;
    /// `normals`: the normals for the angles `before`. Automatic: the file's, or smoothed per object. Crease angle and
    /// weight apply to these and to `after`. measure_orthogonality: report the deviation from orthogonality of the
    /// tangents that these options compute.
    PrepareOptions prepare{};
};

/// Inspects a loaded scene, skinned models in bind pose. Textures are not decoded. Expected O(n log n) at borders, O(n)
/// elsewhere.
/// @throws Error bad_file: too large for the memory budget, or more than 2^32 vertices and corners
RL_API Inspection inspect(const Scene& scene, const InspectOptions& options, Context& context);

/// A line that proposes a border distance; empty: none.
RL_API std::string proposal_text(const Inspection& inspection);

/// Quality limits of a model. The seam limit needs InspectOptions::borders, the others InspectOptions::surfaces. Seams
/// along matched borders count like those at shared positions.
struct CheckLimits {
    std::optional<double> max_seam_deg = 1;  ///< [degrees] 8-bit normals have errors of up to half a degree
    /// Requirements: docs/inspect.md.
    bool no_degenerate = false, no_t_junctions = false, no_non_manifold = false, consistent_winding = false,
         no_inside_out = false, closed = false, unit_normals = false;
};

/// The names of the set limits, in their order: "max-seam", "closed".
RL_API std::vector<std::string> names_of(const CheckLimits& limits);

/// The set limits as text: "max-seam 1, closed".
RL_API std::string to_text(const CheckLimits& limits);

/// A violated limit.
struct CheckFailure {
    std::string limit{};    ///< "max-seam", "no-degenerate", ...: the option's name
    std::string message{};  ///< one line: the worst place, its value, and the number of other places
};

/// One entry for each violated limit, in the order of CheckLimits; empty: passed.
RL_API std::vector<CheckFailure> check_limits(const Inspection& inspection, const CheckLimits& limits);

/// Annotations of a heat map.
enum class SeamMarks : std::uint8_t {
    none,
    legend  ///< a color bar, angle and objects of the largest seam, and a ring around it; in pictures of at least 240 x 180
};

/// Draws the model in plain gray with the normals `before`, and its seams as lines of 0.6 % of the picture's height,
/// colored by heat_color(). Ignores lights and textures of the scene. Needs Inspection::seam_lines.
/// @throws Error usage: an invalid camera; bad_file "nothing to draw"
RL_API Frame draw_seams(const Scene& scene, const Inspection& inspection, const InspectOptions& options,
                        const ViewRequest& view, const RenderSettings& settings, Context& context,
                        SeamMarks marks = SeamMarks::none);

/// The color of a seam angle, linear RGB: 0.01 degrees dark blue, 1 violet, 5 red, 20 orange, 60 and more light yellow;
/// linearly interpolated.
RL_API vec3 heat_color(double seam_deg);

/// A readable table; lines end with line feeds, long lists end with "... N more".
RL_API std::string to_text(const Inspection& inspection);

}  // namespace rakelight
