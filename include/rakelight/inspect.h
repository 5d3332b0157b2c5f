// SPDX-License-Identifier: Apache-2.0
// What is in a model: objects, materials, textures (not decoded), lights, cameras, and the borders that objects share.
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

/// One node that owns meshes.
struct ObjectSummary {
    std::string name{};  ///< of the node; of what a world file places "NAME/name" with its name there, or that alone
    std::uint32_t node = no_index;                                                 ///< into Scene::nodes
    std::uint64_t meshes = 0, triangles = 0, vertices = 0, lines = 0, points = 0;  ///< of all its meshes together
    /// What its meshes have: yes on all, on some, on none of them.
    enum class Has : std::uint8_t { no, some, yes };
    Has normals = Has::no, tangents = Has::no, texcoords = Has::no, colors = Has::no, smoothing_groups = Has::no,
        skin = Has::no, morph_targets = Has::no;
    std::vector<std::string> materials{};  ///< names, each once, in the order of the meshes
};

/// The surface of one object as its triangles make it, over positions welded as AttributeOptions::weld_distance < 0
/// says.
struct SurfaceSummary {
    std::uint64_t edges = 0;               ///< of its welded triangles
    std::uint64_t open_edges = 0;          ///< of one face
    std::uint64_t inconsistent_edges = 0;  ///< of two faces that go along it the same way: one of them is inside out
    std::uint64_t non_manifold_edges = 0;  ///< of three or more faces
    bool closed = false;                   ///< has edges, and none is open
    std::uint64_t t_junctions = 0;         ///< vertices, of any object, on the inside of its open edges
    std::uint64_t degenerate_faces = 0;    ///< zero area, or a corner that is not finite
    /// Of the file's normals, at vertices that a triangle uses; non-unit: the length is off 1 by more than 0.01.
    std::uint64_t zero_normals = 0, non_finite_normals = 0, non_unit_normals = 0;
    std::uint64_t mirrored_positions = 0;     ///< where texture charts of both handedness meet
    std::uint64_t mirror_split_vertices = 0;  ///< that both use: tangents must split them
};

/// A vertex on the inside of an open edge (an edge of one face in the whole model), which has no vertex there.
struct TJunctionPlace {
    dvec3 position{};                           ///< [m] world
    std::uint32_t object = 0, edge_object = 0;  ///< the vertex's and the edge's, into Inspection::objects
};

/// Angles over some positions. p95: 95 of 100 are at most this (nearest rank).
struct AngleSummary {
    double max_deg = 0, mean_deg = 0, p95_deg = 0;  ///< [degrees]
};

/// Normals at most this far apart are continuous [degrees]: more than rounding through matrices, less than any eye
/// sees.
inline constexpr double continuous_deg = 0.01;

/// The border of two objects: the positions that both of them draw, and the angle there between a normal of the one and
/// a normal of the other, of all their corners the nearest two. `before`: normals as they are; `after`: smoothed over
/// the whole model. Where faces of both objects are joined by that (their normals after it are continuous), the angle
/// before is a *seam*, taken over the joined corners; where none are, an edge between the objects is sharper than the
/// crease angle.
struct BorderSummary {
    std::uint32_t object_a = 0, object_b = 0;  ///< into Inspection::objects, a < b
    std::uint64_t positions = 0;               ///< how many they share
    std::uint64_t continuous = 0;              ///< of these, where the angle before is at most continuous_deg
    std::uint64_t joined = 0;                  ///< of these, where the angle after is: the others are creases
    AngleSummary before{}, after{};
    double seam_deg = 0;                     ///< the largest angle before at the joined positions
    dvec3 seam_position{};                   ///< [m] world: where that is
    double median_deg = 0, largest_deg = 0;  ///< of the angles before; largest_deg == before.max_deg
    std::uint64_t inconsistent_edges = 0;    ///< common edges along which a face of each goes the same way
};

/// Two objects of which one is inside out at common edges.
struct InconsistentPair {
    std::uint32_t object_a = 0, object_b = 0;  ///< into Inspection::objects, a < b
    std::uint64_t edges = 0;                   ///< common edges along which both go the same way
};

/// Over all positions that objects share; where several pairs meet, the pair with the largest angle counts.
struct SeamTotals {
    std::uint64_t positions = 0, continuous = 0, joined = 0;  ///< of BorderSummary, each position once
    AngleSummary before{}, after{};
    double seam_deg = 0;      ///< the largest of all
    std::uint64_t pairs = 0;  ///< of objects, that were looked at
    /// Where more than 8 objects meet, only the 7 whose normals turn farthest from the mean and the nearest one are
    /// paired.
    std::uint64_t crowded_positions = 0;
    std::uint64_t pairings_left_out = 0;   ///< pairs at crowded positions that were not looked at
    std::uint64_t inconsistent_edges = 0;  ///< between two objects: one of them is inside out
    std::string normals_before{};          ///< whose normals `before` are, for people
    /// Of `after`: the smallest and the largest; different where parts have their own.
    double crease_angle_deg = 0, crease_angle_most_deg = 0;
};

/// Two objects whose open borders run along each other. Angles and gaps are weighted by length.
struct MatchedPair {
    /// Into Inspection::objects, a <= b; a == b: two meshes of one object.
    std::uint32_t object_a = 0, object_b = 0;
    double length = 0;                 ///< [m] of what is matched, of both sides
    double gap_max = 0, gap_mean = 0;  ///< [m]
    CurveAngles before{}, after{};
    double seam_deg = 0;    ///< the largest angle before that is a seam, see MatchedSeams
    dvec3 seam_position{};  ///< [m] world: where that is; where none is, where the angle before is largest
};

/// Open borders of different meshes that run along each other by the rule of match_borders(). `before`: between the
/// normals as they are (as BorderSummary::before) of both sides, along the curve: a *seam* that no shared position shows.
/// `after`: smoothed over the whole model, then joined by join_borders(). A *seam* is an angle before of more than a quarter of
/// the turn of the normals along one edge there: so far straight interpolation may be off where normals are joined.
struct RL_API MatchedSeams {
    double distance = 0;                         ///< [m] InspectOptions::border_distance; 0: nobody asked
    double open_length = 0, matched_length = 0;  ///< [m] of all open borders; of these, what is matched
    double unmatched_length() const;             ///< [m] the rest of open_length
    double seam_deg = 0;                         ///< the largest of the pairs'
    double gap_max = 0, gap_mean = 0;            ///< [m] along what is matched
    CurveAngles before{}, after{};
    std::vector<MatchedPair> pairs{};      ///< the largest seam first, then the largest angle before; at most 10,000
    std::uint64_t pairs_left_out = 0;      ///< pairs beyond the first 10,000
    std::uint64_t edges_not_searched = 0;  ///< BorderMeasure::edges_not_searched
};

/// A distance at which open borders run along each other where nobody asked for one: proposed_border_distance().
struct BorderProposal {
    double distance = 0;        ///< [m] 0: no borders do, or their normals agree to 1 degree
    double open_length = 0;     ///< [m]
    double matched_length = 0;  ///< [m] of it, about, at that distance
    double gap_max = 0;         ///< [m]
    double seam_deg = 0;        ///< MatchedSeams::seam_deg at that distance
};

/// A piece of a border with a seam; a == b where objects share a position but no edge.
struct SeamLine {
    dvec3 a{}, b{};              ///< [m] world
    float deg_a = 0, deg_b = 0;  ///< [degrees] angle between the normals at a, at b
};

/// A closed body, of one object or of several whose parts close together, all of whose faces look inwards.
struct InsideOutBody {
    std::uint64_t triangles = 0;           ///< of the body
    std::vector<std::uint32_t> objects{};  ///< that it is made of, into Inspection::objects
};

/// The numbers that vertices have under one name (Mesh::arrays).
struct ArraySummary {
    std::string name{};            ///< as the file has it
    std::uint32_t components = 1;  ///< numbers a vertex
    double low = 0, high = 0;      ///< of the finite numbers of all components; 0 where there are none
    std::uint64_t vertices = 0;    ///< that have it
    std::uint64_t not_finite = 0;  ///< numbers
};

/// What inspect() found.
struct Inspection {
    /// Scene::source
    std::string file{};
    /// Of all lengths: "m", or "units" where the file's format knows none (OBJ, STL, PLY, 3DS, ASE, OFF, X).
    std::string unit = "m";
    std::uint64_t triangles = 0;  ///< instances counted each time
    std::vector<ObjectSummary> objects{};
    std::vector<std::uint32_t> material_objects{};    ///< [scene.materials] how many objects have it; 0: unused
    std::vector<ArraySummary> arrays{};               ///< in the order of the meshes, each name once
    std::vector<SurfaceSummary> surfaces{};           ///< [objects], or empty when not asked for
    std::uint64_t t_junctions = 0;                    ///< each position once
    std::vector<TJunctionPlace> t_junction_places{};  ///< at most 1000
    std::vector<InsideOutBody> inside_out{};          ///< at most 1000
    std::uint64_t edges_not_searched = 0;             ///< open edges at which the search for T-junctions gave up
    dvec3 low{}, high{};  ///< world bounding box [m] of the pose; meaningful when triangles, lines or points are drawn
    /// Skins, morph targets or clips stand in the scene: the box is that of the pose, seams are those of the bind pose.
    bool is_posed = false;
    std::uint64_t shared_positions = 0;  ///< world positions that two or more objects draw
    SeamTotals seams{};
    std::vector<BorderSummary> borders{};  ///< the largest seam first, then the largest angle; at most 10,000
    std::uint64_t borders_left_out = 0;    ///< pairs beyond the first 10,000
    std::vector<InconsistentPair> inconsistent_pairs{};  ///< the most edges first; at most 10,000
    MatchedSeams matched{};                              ///< with InspectOptions::border_distance
    BorderProposal proposal{};                           ///< without it, of surfaces and borders that were looked at
    std::vector<SeamLine> seam_lines{};                  ///< when asked for
    Scene scene{};  ///< as loaded, but without its nodes and meshes: materials, textures, lights, cameras, animations
};

/// What inspect() looks at.
struct InspectOptions {
    bool borders = true;        ///< look for shared positions and their seam angles
    bool surfaces = true;       ///< look at edges, faces and normals of each object
    bool seam_lines = false;    ///< keep where the seams are, for draw_seams()
    double weld_distance = -1;  ///< [m] which positions are one, as AttributeOptions::weld_distance
    /// [m] in the world, >= 0, finite: also measure the seams along open borders that run along each other no farther
    /// apart, with `borders`. 0: off.
    double border_distance = 0;
    /// `normals`: whose the angles `before` are. Automatic: the file's, smoothed per object where it has none. Crease
    /// angle and weight hold for these and for `after`. measure_orthogonality: the report says how far from
    /// perpendicular to their normals the tangents are that these options make.
    PrepareOptions prepare{};
};

/// Looks a loaded scene over. Decodes no texture. Skinned models in bind pose. Expected O(n log n) at borders, O(n)
/// elsewhere.
/// @throws Error bad_file: too large for the memory that files may ask for, or more than 2^32 vertices and corners
RL_API Inspection inspect(const Scene& scene, const InspectOptions& options, Context& context);

/// The line that proposes a border distance, for people; empty: none is proposed.
RL_API std::string proposal_text(const Inspection& inspection);

/// What a model must keep to. The seam limit needs InspectOptions::borders, the others InspectOptions::surfaces. Seams along
/// matched borders count like those at shared positions.
struct CheckLimits {
    std::optional<double> max_seam_deg = 1;  ///< [degrees] 8-bit normals are off by up to half a degree each
    /// What must not be, or must be: docs/inspect.md.
    bool no_degenerate = false, no_t_junctions = false, no_non_manifold = false, consistent_winding = false,
         no_inside_out = false, closed = false, unit_normals = false;
};

/// The names of the limits that are set, in their order: "max-seam", "closed".
RL_API std::vector<std::string> names_of(const CheckLimits& limits);

/// The options that were set, for people: "max-seam 1, closed".
RL_API std::string to_text(const CheckLimits& limits);

/// A limit that was passed.
struct CheckFailure {
    std::string limit{};    ///< "max-seam", "no-degenerate", ...: the option's name
    std::string message{};  ///< one line: where it is passed most, how much, how many more there are
};

/// One entry for each limit that is passed, in the order of CheckLimits; empty: all is well.
RL_API std::vector<CheckFailure> check_limits(const Inspection& inspection, const CheckLimits& limits);

/// What is written on a heat map.
enum class SeamMarks : std::uint8_t {
    none,
    legend  ///< the bar of colors, the largest seam's angle and objects, and a ring about it; in pictures of 240 x 180 and more
};

/// The model in plain gray with the normals `before`, and its seams over it, as wide as 0.6 % of the picture's height,
/// in colors by their angle: heat_color(). Lights and textures of the scene are not used. Needs Inspection::seam_lines.
/// @throws Error usage: an impossible camera; bad_file "nothing to draw"
RL_API Frame draw_seams(const Scene& scene, const Inspection& inspection, const InspectOptions& options,
                        const ViewRequest& view, const RenderSettings& settings, Context& context,
                        SeamMarks marks = SeamMarks::none);

/// The color of a seam angle, linear RGB; from dark to light: 0.01 degrees dark blue, 1 violet, 5 red, 20 orange, 60
/// and more light yellow; linear between them.
RL_API vec3 heat_color(double seam_deg);

/// A table for people, lines ending with line feeds; long lists are cut with "... N more".
RL_API std::string to_text(const Inspection& inspection);

}  // namespace rakelight
