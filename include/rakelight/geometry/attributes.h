// SPDX-License-Identifier: Apache-2.0
// Seam-free normals and tangents for models of many parts. Needs no Scene: spans and matrices in, arrays out.
//
// Terms of this header:
// - A *position* is a point in world space. Welded vertices (AttributeOptions::weld_distance) share one position, also
//   if they belong to different meshes. With Scope::object, only vertices of one object are welded.
// - A *corner* is one of the three corners of a triangle. Corner 3 * t + k is corner k of triangle t.
// - A *valid face* has a nonzero area and only finite corners. All other faces contribute nothing to any result.
// - A *corner group* is a set of corners at one position that get the same normal.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/base/export.h>
#include <rakelight/math/vector.h>

namespace rakelight {

/// The faces over which a normal is smoothed: one face, the faces of one object, or the faces of all objects.
enum class Scope : std::uint8_t { face, object, model };

/// How much the unit normal of a face counts in a vertex normal. The weight is computed for each corner of the face.
/// - `uniform`: 1 (Gouraud 1971).
/// - `area`: the area of the face.
/// - `angle`: the angle of the face at the corner (Thuermer & Wuethrich 1998, "Computing Vertex Normals from Polygonal
///   Facets").
/// - `angle_area`: the angle times the area.
/// - `max`: the sine of the angle, divided by the lengths of both edges at the corner (Max 1999, "Weights for Computing
///   Vertex Normals from Facet Normals"). Exact for vertices on a sphere.
/// - `fit`: no weight. A height function is fitted to the positions of two rings of neighbors, over the borders of
///   objects. Where there are too few of them, as `max`.
/// - `automatic`: no weight. At each corner group a fit, a plane, or the weights `max` or `angle`, as the surface there
///   asks for: docs/attributes.md. Tangents and average() take the weights `max` with both.
enum class CornerWeight : std::uint8_t { uniform, area, angle, angle_area, max, fit, automatic };

/// How tangents are computed.
/// - `averaged`: the unit tangents of the faces are summed, with the weights used for normals (CornerWeight). Not all
///   tangents at a position go into one sum. First each vertex gets a tangent from its own faces only. Two vertices are
///   compatible if their corners are in the same corner group, their handedness is the same, and these first tangents
///   differ by at most 45 degrees. Two vertices share a sum only if they are compatible or connected by a chain of
///   compatible vertices.
/// - `mikktspace`: the same tangents as MikkTSpace (Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited") with
///   an angular threshold of 180 degrees. Each mesh is computed in its own object space. Use this mode for maps that
///   were baked with MikkTSpace.
/// - `published`: at each position the unit tangents of all faces in the scope are averaged, and so are their unit
///   bitangents. Mirrored faces are included. The bitangent is a separate attribute. The tangent is made perpendicular
///   to the normal. Then it is negated if dot(cross(normal, tangent), bitangent) < 0. So all frames are right-handed,
///   and maps on mirrored texture coordinates run backwards along u.
/// - `published_no_handedness`: as `published`, but no tangent is negated. The w of a tangent gives the side of the
///   bitangent: it is the sign of dot(cross(normal, tangent), bitangent).
enum class TangentMode : std::uint8_t { averaged, published, mikktspace, published_no_handedness };
/// Whether bitangents are a separate attribute.
inline bool is_published(TangentMode mode) {
    return mode == TangentMode::published || mode == TangentMode::published_no_handedness;
}

/// `attribute`: the summed tangents are made perpendicular to the normals. `off`: they are only normalized.
enum class Orthogonalize : std::uint8_t { attribute, off };

/// How faces that share an edge are divided. `angle`: by AttributeOptions::crease_angle_rad. `automatic`: edge by edge, by
/// the rule of find_creases() (<rakelight/geometry/creases.h>).
enum class Creasing : std::uint8_t { angle, automatic };

/// Options of compute_attributes().
struct AttributeOptions {
    Scope scope = Scope::model;
    CornerWeight weight = CornerWeight::angle;
    /// [rad] 0..pi. Faces that share an edge are joined if the angle between their normals is at most this angle. A
    /// slack of 1e-5 rad allows for the rounding of positions. pi: all faces at a position are joined. 0: flat shading.
    double crease_angle_rad = radians(60);
    /// `automatic`: crease_angle_rad is not used. AttributeMesh::crease_angle_rad, smoothing groups and hints go before
    /// the rule. The rule sees the faces of all meshes. Where it meets an own angle, both must join the faces.
    Creasing creases = Creasing::angle;
    /// [m] in world space. Vertices at most this far apart are welded. 0: only vertices with equal positions are
    /// welded.
    ///
    /// < 0: automatic. Two meshes with equal matrices are welded only where their positions are equal. For other meshes
    /// the distance is the sum of the rounding errors of the two meshes. The rounding error of a mesh has two parts:
    /// - 2 float ulps of the mesh's size. The size is the largest object-space coordinate times the scale of
    ///   AttributeMesh::to_world.
    /// - 1 float ulp of the distance between the mesh's pivot (the object-space origin, in world space) and a reference
    ///   point. The reference point is the world origin or the center of the model's bounding box, whichever is nearer
    ///   to the pivot.
    ///
    /// The rounding error is limited to 2^-14 of the diagonal of the bounding box. Quantized positions have other
    /// rules, see AttributeMesh::position_step.
    ///
    /// A chain of vertices, each close to the next, is welded to one position. If the chain extends over more than
    /// twice the distance, only its vertices with equal positions are welded, and the report gets a warning. No vertex
    /// is moved.
    double weld_distance = -1;
    bool normals = true;   ///< false: keep the given normals (every mesh must have them) and compute only tangents
    bool tangents = true;  ///< compute tangents for meshes with texture coordinates
    bool groups_across = false;  ///< smoothing groups also join faces of different objects
    TangentMode tangent_mode = TangentMode::averaged;
    /// TangentMode::mikktspace ignores this option: MikkTSpace orthogonalizes the tangent of each face before summing.
    Orthogonalize orthogonalize = Orthogonalize::attribute;
    bool measure_orthogonality = false;  ///< fill MeshAttributes::orthogonality_loss_*
    /// If true, two faces at a position are joined only if a chain of common edges connects them. So the two halves of
    /// a bow-tie stay separate. The option matters only for a crease angle of pi: for smaller angles this rule always
    /// applies.
    bool fans = false;
    bool locked_vote = true;  ///< faces at locked vertices contribute to normals of other vertices at the same position
};

/// The meaning of AttributeMesh::smoothing. `masks` (3DS, ASE): two faces join if the AND of their bit masks is not 0.
/// `numbers` (OBJ): two faces join if their numbers are equal. In both cases a face with the value 0 is flat.
enum class GroupKind : std::uint8_t { none, masks, numbers };

/// One mesh, placed in the world.
struct AttributeMesh {
    std::uint32_t object = 0;                    ///< meshes with equal numbers form one object (Scope::object)
    std::span<const vec3> positions{};           ///< [V] object space; faces with non-finite corners are not valid
    std::span<const std::uint32_t> indices{};    ///< [3T] each < V; counter-clockwise seen from outside
    std::span<const vec2> texcoords{};           ///< [V] or empty; v down
    std::span<const vec3> normals{};             ///< [V] or empty; see AttributeOptions::normals and `locked`
    std::span<const std::uint32_t> smoothing{};  ///< [T] or empty
    GroupKind group_kind = GroupKind::none;      ///< the meaning of `smoothing`
    /// [3T] or empty: one vector for each corner, used only if `smoothing` is empty. Two faces of one object join at a
    /// position if their corners have equal vectors there. If an importer drops smoothing groups, pass its normals
    /// here.
    std::span<const vec3> smoothing_hint{};
    dmat4 to_world{};  ///< object -> world, affine; det < 0 mirrors
    /// [V] or empty. Not 0: locked, the vertex keeps its entry of `normals` (not empty), unless that is zero or
    /// not finite. 2: authored, the other vertices of its corner group get the mean of such normals, not the faces'.
    std::span<const std::uint8_t> locked{};
    /// [m] object space, >= 0: the quantization step of the positions; 0: not quantized. A quantized position may be
    /// off by half a step on each axis. So for the automatic AttributeOptions::weld_distance, the rounding error of
    /// this mesh is at least half the diagonal of a cube whose edges are one step long. If either of two meshes is
    /// quantized, they are welded within the distance even if their matrices are equal.
    ///
    /// Exception for quantized meshes: two positions stay separate if a single mesh has vertices at both of them. That
    /// mesh stores them as neighboring grid points, so they are different positions.
    double position_step = 0;
    /// [rad] 0..pi, overrides AttributeOptions::crease_angle_rad; < 0: not set. Between two meshes the smaller angle
    /// applies.
    double crease_angle_rad = -1;
};

/// Result for one mesh, in object space. Vertices 0 to V - 1 are the input's vertices in the same order. If the corners
/// of a vertex get different normals or tangents, copies of the vertex are appended. V' is the new number of vertices.
struct MeshAttributes {
    std::vector<vec3> normals{};  ///< [V'] unit, finite; (0, 0, 1) if no valid face touches the vertex's position
    /// [V'] Empty without texcoords. xyz is unit, and perpendicular to the normal unless Orthogonalize::off was given.
    /// w is +1 or -1 in object space; in world space a mirroring matrix negates it. If the texture area is zero, w is
    /// +1, and xyz is the world axis farthest from the normal, made perpendicular to the normal.
    std::vector<vec4> tangents{};
    std::vector<vec3> bitangents{};        ///< [V'] unit, towards decreasing v; filled only by the published modes
    std::vector<std::uint32_t> indices{};  ///< [3T] each < V'; empty if no vertex was split: use the input's indices
    std::vector<std::uint32_t> source_vertex{};  ///< [V' - V] the input vertex that each appended vertex copies
    std::uint32_t degenerate_faces = 0;          ///< faces with zero area or a non-finite corner
    std::uint32_t isolated_vertices = 0;         ///< vertices that no valid face touches
    /// [degrees] maximum and mean over the vertices: the angle between the summed tangent and the plane perpendicular
    /// to the normal. Measured in world space before orthogonalization. 0 unless
    /// AttributeOptions::measure_orthogonality.
    double orthogonality_loss_max_deg = 0, orthogonality_loss_mean_deg = 0;
    /// Number of faces on which a normal map runs backwards. On such a face the mean tangent of the corners points
    /// towards decreasing u, or the mean of cross(n, t) * w points towards increasing v (v is down). Only the published
    /// modes count these faces.
    std::uint32_t inverted_faces = 0;
};

/// The corner groups of all meshes. A plan is computed once and stays valid when vertices of the same meshes move
/// (poses, morphs). regroup() reuses a plan when the crease angle changes. A plan is immutable and cheap to copy. It
/// takes about 45 bytes per triangle.
class RL_API AttributePlan {
public:
    struct Impl;
    /// For use by the library only.
    explicit AttributePlan(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
    /// @throws Error usage: the plan is empty or was moved from
    const Impl& impl() const;

private:
    std::shared_ptr<const Impl> impl_;
};

/// First step: makes the corner groups. It welds positions, joins faces by crease angle and smoothing groups, and finds
/// the vertices to split. Positions are compared in world space, in double precision; -0 equals +0. Face normals of a
/// corner group may cancel each other, as on two coincident shells of opposite orientation. Such a group is split.
/// Expected O(n), deterministic for any number of threads.
/// @throws Error bad_file: sizes that do not fit, an index out of range (the message names the first one), a non-finite
///         matrix
RL_API AttributePlan group(std::span<const AttributeMesh> meshes, const AttributeOptions& options, Context& context);

/// The first step again with other options, for example from a slider of the crease angle. It returns the same plan as
/// group(meshes, options, context), but faster: it reuses face normals, welded positions, automatic creases and the
/// faces around each position. It welds again only if AttributeOptions::weld_distance, `normals` or `scope` differs from the plan's.
/// @param plan    of group() or regroup()
/// @param meshes as given to group(), with unmoved positions; only smoothing groups, hints and locks may have changed
/// @throws Error bad_file: counts that differ from the plan's; and as group()
RL_API AttributePlan regroup(const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                             const AttributeOptions& options, Context& context);

/// Second step: computes normals and tangents as sums over the corner groups of the plan. Positions may have moved
/// since the first step; the counts of vertices and triangles must be equal. If no position has moved, the result is
/// that of compute_attributes(): bit-identical but in the fast case (compute_attributes_into()), which sums in float.
/// @return one entry per mesh, in the order of the input
RL_API std::vector<MeshAttributes> accumulate(const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                                              Context& context);

/// Like accumulate(), but averages the caller's own per-face values (light, measurements). Each vertex gets the mean
/// over the faces of its corner group, with the plan's weights. The result is smooth across the same edges as the
/// normals, also between objects, and sharp at creases. Each component of a mean lies between the minimum and the
/// maximum of this component over the faces. If all values are equal, the mean is bit-identical to them.
/// @param meshes as given to group(); positions may have moved
/// @param values [meshes][T] finite; values of faces that are not valid are ignored
/// @return [meshes][V'] vertices as in the result of accumulate(); 0 if a vertex's corner group has no valid face
/// @throws Error bad_file: counts that differ from the plan's
RL_API std::vector<std::vector<vec3>> average(const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                                              std::span<const std::span<const vec3>> values, Context& context);

/// Both steps. All corners of a corner group get bit-equal vectors in world space. These vectors are then transformed
/// to the space of each object.
RL_API std::vector<MeshAttributes> compute_attributes(std::span<const AttributeMesh> meshes,
                                                      const AttributeOptions& options, Context& context);

/// How many corner groups CornerWeight::automatic decides by what. Where it blends, the larger share counts.
struct NormalChoices {
    std::uint64_t smooth = 0;    ///< faces that differ so little that the weight `max` is enough
    std::uint64_t plane = 0;     ///< a plane of several triangles
    std::uint64_t fit = 0;       ///< a cubic height function
    std::uint64_t edge_fit = 0;  ///< a quadric, at open borders and creases or where a cubic is not determined
    std::uint64_t noise = 0;     ///< a quadric that averages noise
    std::uint64_t planar = 0;    ///< several planes, of which none is large enough: the weight `max`
    std::uint64_t angle = 0;     ///< none of these: the weight `angle`
};
/// The choices for normals of these options, with the weight `automatic`.
/// @throws as compute_attributes()
RL_API NormalChoices normal_choices(std::span<const AttributeMesh> meshes, const AttributeOptions& options,
                                    Context& context);

/// Output buffers of compute_attributes_into() for one mesh. Entry v belongs to vertex v of the input. Entries beyond V
/// are not written.
struct AttributeBuffers {
    std::span<vec3> normals{};   ///< [>= V]
    std::span<vec4> tangents{};  ///< [>= V] if the mesh has texcoords and tangents are requested; else ignored
};

/// A corner whose index changed because its vertex was split.
struct CornerVertex {
    std::uint32_t corner, vertex;  ///< the corner (3 * triangle + 0, 1 or 2), and its new vertex
    bool operator==(const CornerVertex&) const = default;
};

/// The vertices that are appended to one mesh because vertices were split. AttributeBuffers has no entries for them. If
/// no vertex was split (V' = V), all arrays are empty. Otherwise append `normals` and `tangents` to the first V entries
/// of the buffers, and change the indices of the listed corners. The result has the contents of MeshAttributes.
struct SplitAttributes {
    std::vector<std::uint32_t> source_vertex{};  ///< [V' - V] input vertex that each appended vertex copies; ascending
    std::vector<vec3> normals{};                 ///< [V' - V]
    std::vector<vec4> tangents{};                ///< [V' - V], or empty without tangents
    std::vector<CornerVertex> corners{};         ///< ascending; each vertex is >= V
    std::uint32_t degenerate_faces = 0;          ///< as in MeshAttributes
    std::uint32_t isolated_vertices = 0;         ///< as in MeshAttributes
};

/// Scratch memory of compute_attributes_into(), reused by later calls with any number of vertices. The fast case (see
/// compute_attributes_into()) uses 24 bytes per vertex for normals alone, or 40 for normals and tangents. 8 of these
/// bytes are for the weld. The general path uses about 70 bytes per triangle, and fitted normals up to 180 more.
/// Concurrent calls must not share a workspace.
class RL_API AttributeWorkspace {
public:
    AttributeWorkspace();
    AttributeWorkspace(AttributeWorkspace&&) noexcept;
    AttributeWorkspace& operator=(AttributeWorkspace&&) noexcept;
    ~AttributeWorkspace();
    std::size_t bytes() const;  ///< allocated now
    struct Impl;
    Impl& impl();  ///< for use by the library only; a workspace that was moved from gets a new one

private:
    std::unique_ptr<Impl> impl_;
};

/// compute_attributes() into the caller's buffers.
///
/// The *fast case* sums in float, and decides in double only at creases and where several surfaces meet. It needs one crease
/// angle of at least a degree, or the rule of creases on a model that bends by less than 6 degrees at every edge. The scope
/// must be model or object, the weld distance 0 or automatic (< 0), and tangents averaged and orthogonalized. All meshes
/// must have the same angle-preserving matrix, and no smoothing groups, hints, locks or quantized positions. At a crease
/// angle of pi and with a weight of sums, once the workspace has grown, it allocates no memory per vertex or triangle. In
/// all other cases the workspace holds the largest arrays, and each call allocates the others.
///
/// @param out [meshes] buffers must not overlap each other or the input
/// @return split vertices and counts, one entry per mesh; the same values as compute_attributes()
/// @throws Error usage: a buffer is too small (the message has the mesh and the sizes); and as compute_attributes().
///         After an error the contents of the buffers are unspecified.
RL_API std::vector<SplitAttributes> compute_attributes_into(std::span<const AttributeMesh> meshes,
                                                            const AttributeOptions& options,
                                                            std::span<const AttributeBuffers> out,
                                                            AttributeWorkspace& workspace, Context& context);

}  // namespace rakelight
