// SPDX-License-Identifier: Apache-2.0
// Seam-free normals and tangents for models made of many parts. Needs no scene: spans and matrices in, arrays out.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/vector.h>

namespace rakelight {

/// Over which faces a normal is smoothed: the face alone, the faces of one object, or the faces of all objects.
enum class Scope : std::uint8_t { face, object, model };

/// How strongly a triangle pulls on the normal at its corner. `uniform` is the published sum of unit face normals;
/// `angle` Thuermer & Wuethrich 1998, "Computing Vertex Normals from Polygonal Facets".
enum class CornerWeight : std::uint8_t { uniform, area, angle, angle_area };

/// How tangents come about.
/// `averaged`: summed with the normals' weights over a place, but only among vertices of one handedness whose tangents
/// lie within 45 degrees of one another. `mikktspace`: reproduces MikkTSpace (Mikkelsen 2008, "Simulation of Wrinkled
/// Surfaces Revisited") at an angular threshold of 180 degrees, each mesh by itself in its own space: for maps that
/// were baked so. `published`: unit tangents and unit bitangents of all faces at a place are averaged, mirrored or not,
/// by the scope; the tangent is made perpendicular to the normal and turned round where it disagrees with the
/// bitangent, which is an attribute of its own: all frames are right-handed then, and maps on mirrored texture
/// coordinates run backwards along u. `published_no_handedness`: the same without that last step; w says on which side
/// the bitangent lies.
enum class TangentMode : std::uint8_t { averaged, published, mikktspace, published_no_handedness };
/// Whether bitangents are attributes of their own.
inline bool is_published(TangentMode mode) {
    return mode == TangentMode::published || mode == TangentMode::published_no_handedness;
}

/// Whether tangents are made perpendicular to the normals here (`attribute`) or left as summed (`off`).
enum class Orthogonalize : std::uint8_t { attribute, off };

/// What compute_attributes() makes, and how.
struct AttributeOptions {
    Scope scope = Scope::model;
    CornerWeight weight = CornerWeight::angle;
    /// [rad] 0..pi. Faces that share an edge are joined if their normals differ by at most this much (inclusive, with 1e-5 rad
    /// of slack for the rounding of positions); pi joins everything at a position, 0 is flat.
    double crease_angle_rad = radians(60);
    /// [m] in the world, over exact equality; 0: exact only. < 0: what rounding makes of one place, by the two meshes that meet, the
    /// sum of what each may be off. Where their matrices differ: 2 float ulps of the mesh's largest local coordinate (as long as in
    /// the world) and 1 of its pivot's distance from the center of the model's box, or from the world's origin if that is less;
    /// at most 2^-14 of the box's diagonal. Where positions were quantized: see AttributeMesh::position_step. Connected components
    /// of close pairs are one place; those wider than twice the distance are kept exact, with a warning in the report. Positions
    /// never move.
    double weld_distance = -1;
    bool normals = true;         ///< false: keep the given normals (every mesh must have them) and make only tangents
    bool tangents = true;        ///< where texture coordinates exist
    bool groups_across = false;  ///< smoothing groups also rule between objects
    TangentMode tangent_mode = TangentMode::averaged;
    /// `mikktspace` has its own, in each face's vote.
    Orthogonalize orthogonalize = Orthogonalize::attribute;
    bool measure_orthogonality = false;  ///< fill MeshAttributes::orthogonality_loss_*
    /// At a crease angle of pi: faces at a place are joined only over common edges, one group a fan (bow-ties fall apart). Below
    /// pi that is so in any case.
    bool fans = false;
    bool locked_vote = true;  ///< faces at locked vertices have a say in the normals of others at their place
};

/// How smoothing[] is to be read: bit masks join when AND != 0 (3DS, ASE), numbers join when equal (OBJ); 0 is flat.
enum class GroupKind : std::uint8_t { none, masks, numbers };

/// One mesh, placed in the world. Meshes with the same `object` number form one object (scope `object` smooths over them).
struct AttributeMesh {
    std::uint32_t object = 0;                    ///< meshes of one number are one object
    std::span<const vec3> positions{};           ///< [V] about `origin`; a face with a non-finite corner has no vote
    std::span<const std::uint32_t> indices{};    ///< [3T] each < V; counter-clockwise seen from outside
    std::span<const vec2> texcoords{};           ///< [V] or empty; v down
    std::span<const vec3> normals{};             ///< [V] or empty; read only when AttributeOptions::normals is false
    std::span<const std::uint32_t> smoothing{};  ///< [T] or empty
    GroupKind group_kind = GroupKind::none;
    std::span<const vec3>
        smoothing_hint{};  ///< [3T] or empty: corners of one position whose hints are equal were one group
    dmat4 to_world{};      ///< object -> world, affine, including `origin`; det < 0 mirrors
    /// [V] or empty: not 0: the vertex keeps its entry of `normals` (which must then be there); ignored where that is zero or not finite.
    std::span<const std::uint8_t> locked{};
    /// [m] in object space, >= 0: the step on which positions were rounded (quantized files), 0: none. A position may then be half a
    /// step off in every axis: AttributeOptions::weld_distance < 0 takes half of its diagonal for this mesh, and welds it with
    /// any other mesh but one that has a vertex at that very place already (the next code then is another place).
    double position_step = 0;
    /// [rad] 0..pi in place of AttributeOptions::crease_angle_rad; < 0: that one. Between two meshes the smaller one
    /// rules.
    double crease_angle_rad = -1;
};

/// Result for one mesh: vertex v < V keeps its number; a vertex whose corners differ is appended. Object space.
struct MeshAttributes {
    std::vector<vec3> normals{};  ///< [V'] unit, finite; (0, 0, 1) where no face with a vote touches a vertex's place
    /// [V'] xyz unit and perpendicular to the normal, w = +1 or -1 as seen in object space (a mirroring matrix flips it on the
    /// way to the world); empty without texcoords. Without texture area: the axis farthest from the world normal, made
    /// perpendicular to it, w = +1.
    std::vector<vec4> tangents{};
    std::vector<vec3> bitangents{};        ///< [V'] unit, towards decreasing v; filled only by the published modes
    std::vector<std::uint32_t> indices{};  ///< [3T] each < V'; empty when no vertex was split (the input's hold)
    std::vector<std::uint32_t> source_vertex{};  ///< [V' - V] the vertex that each appended one copies
    std::uint32_t degenerate_faces = 0;          ///< faces without a vote: zero area or a non-finite corner
    std::uint32_t isolated_vertices = 0;         ///< vertices that no face with a vote touches
    /// [degrees] how far summed tangents were from perpendicular to their normals in the world, before Gram-Schmidt; 0 unless
    /// AttributeOptions::measure_orthogonality.
    double orthogonality_loss_max_deg = 0, orthogonality_loss_mean_deg = 0;
    /// Faces on which a map runs backwards: the mean of their corners' tangents points against the way of u on the
    /// face, or that of cross(n, t) * w against the way of -v. Counted by the published modes only.
    std::uint32_t inverted_faces = 0;
};

/// Which corners share a normal: made once, used for any positions of the same meshes (poses, morphs), and the start of the next
/// one when the crease angle moves. Immutable; cheap to copy. Holds about 45 bytes a triangle.
class RL_API AttributePlan {
public:
    struct Impl;
    /// Of the library itself.
    explicit AttributePlan(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
    /// @throws Error usage: nothing was grouped, or the plan was moved away
    const Impl& impl() const;

private:
    std::shared_ptr<const Impl> impl_;
};

/// First step: border classes by position (exact in the world, compared in double, -0 equal to +0), faces joined by crease
/// angle and smoothing groups, vertices that must split. Expected O(n), deterministic for any number of threads.
/// Sums are made only where the faces of a group look so far away from one another that their normals may cancel.
/// @throws Error bad_file: sizes that do not fit, an index out of range (first one in the message), a matrix that is not finite.
RL_API AttributePlan group(std::span<const AttributeMesh> meshes, const AttributeOptions& options, Context& context);

/// The first step again, for other options (a crease slider): the same plan as group(meshes, options, context), sooner. What does not
/// change with the crease angle is taken from the old plan: places, face normals and the faces around each place. Another
/// scope (but face), weld_distance or `normals` makes the weld anew.
/// @param plan    of group() or regroup()
/// @param meshes  as they were given to group(), unmoved; only their smoothing groups, hints and locks may have changed
/// @throws Error bad_file: other counts than were grouped, and what group() throws
RL_API AttributePlan regroup(const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                             const AttributeOptions& options, Context& context);

/// Second step: the sums, over the same meshes (positions may have moved; counts may not). The same vectors, to the bit, as
/// compute_attributes() where nothing has moved and the crease angle is below pi or the weight is not uniform (else compute_attributes()
/// sums in float).
/// @return one entry a mesh, in the order of the input
RL_API std::vector<MeshAttributes> accumulate(const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                                              Context& context);

/// The second step for what faces have in place of normals (light, measurements): each vertex gets the mean of its group's
/// faces with the plan's weights. Smooth wherever normals are, over borders of objects too, and sharp at creases. A mean lies
/// between the least and the greatest of its faces, by component: a constant stays that constant to the bit.
/// @param meshes  as they were grouped (positions may have moved)
/// @param values  [meshes][T] finite; those of faces without a vote do not count
/// @return [meshes][V'] by the vertex numbers of accumulate()'s result; 0 where no face with a vote touches a vertex's group
/// @throws Error bad_file: other counts than were grouped
RL_API std::vector<std::vector<vec3>> average(const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                                              std::span<const std::span<const vec3>> values, Context& context);

/// Both steps. All corners of a group get bit-equal vectors (in the world; each object's own space after its matrix).
RL_API std::vector<MeshAttributes> compute_attributes(std::span<const AttributeMesh> meshes,
                                                      const AttributeOptions& options, Context& context);

/// Where compute_attributes_into() writes for one mesh, by the input's vertex numbers; entries beyond V are left alone.
struct AttributeBuffers {
    std::span<vec3> normals{};   ///< [>= V]
    std::span<vec4> tangents{};  ///< [>= V] where the mesh has texcoords and tangents are asked for; else not looked at
};

/// A corner (3 * triangle + 0, 1 or 2) that uses another vertex than the input's index says.
struct CornerVertex {
    std::uint32_t corner, vertex;  ///< the corner; the vertex that it uses
    bool operator==(const CornerVertex&) const = default;
};

/// What the buffers of one mesh have no place for: the vertices that had to be split. All empty where none was (V' = V); else
/// append normals and tangents to the buffers' first V entries and change the listed corners, and MeshAttributes is complete.
struct SplitAttributes {
    std::vector<std::uint32_t> source_vertex{};  ///< [V' - V] the vertex that each appended one copies; ascending
    std::vector<vec3> normals{};                 ///< [V' - V]
    std::vector<vec4> tangents{};                ///< [V' - V], or empty as the mesh has none
    std::vector<CornerVertex> corners{};         ///< ascending; each vertex is >= V
    std::uint32_t degenerate_faces = 0;          ///< as in MeshAttributes
    std::uint32_t isolated_vertices = 0;         ///< as in MeshAttributes
};

/// Scratch memory of compute_attributes_into(), kept for the next call (of any sizes): 16 bytes a vertex for normals, 32 for
/// normals and tangents, 8 more for the weld; where the general path runs, about 42 bytes a triangle. For one call at a time.
class RL_API AttributeWorkspace {
public:
    AttributeWorkspace();
    AttributeWorkspace(AttributeWorkspace&&) noexcept;
    AttributeWorkspace& operator=(AttributeWorkspace&&) noexcept;
    ~AttributeWorkspace();
    std::size_t bytes() const;  ///< held now
    struct Impl;
    Impl& impl();  ///< that of a workspace that was moved away is new

private:
    std::unique_ptr<Impl> impl_;
};

/// compute_attributes() into the caller's own buffers. Where everything at a place is joined (crease angle pi, weight uniform, scope
/// model or object, no smoothing groups or hints, weld exact, all meshes by one matrix that keeps angles) nothing of the
/// size of the model is allocated once the workspace has grown to it; with other options the largest arrays come from the workspace.
///
/// @param out  [meshes] the same buffer must not stand twice, nor overlap the input
/// @return what was split and counted, one entry a mesh; the same values as compute_attributes() gives
/// @throws Error usage: a buffer too small (mesh and sizes in the message), and what compute_attributes() throws; then the
///         buffers hold anything
RL_API std::vector<SplitAttributes> compute_attributes_into(std::span<const AttributeMesh> meshes,
                                                            const AttributeOptions& options,
                                                            std::span<const AttributeBuffers> out,
                                                            AttributeWorkspace& workspace, Context& context);

}  // namespace rakelight
