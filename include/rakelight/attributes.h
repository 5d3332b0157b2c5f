// SPDX-License-Identifier: Apache-2.0
// Seam-free normals and tangents for models of many parts. Needs no Scene: spans and matrices in, arrays out.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/export.h>
#include <rakelight/vector.h>

namespace rakelight {

/// The faces over which a normal is smoothed: one face, the faces of one object, or the faces of all objects.
enum class Scope : std::uint8_t { face, object, model };

/// The weight of a face normal in the vertex normal at one corner. `uniform` is the sum of unit face normals (Gouraud
/// 1971); `angle` is Thuermer & Wuethrich 1998, "Computing Vertex Normals from Polygonal Facets".
enum class CornerWeight : std::uint8_t { uniform, area, angle, angle_area };

/// How tangents are computed. `averaged`: a weighted sum at each position, with the normals' weights, over vertices of
/// equal handedness whose tangents lie within 45 degrees of each other. `mikktspace`: reproduces MikkTSpace (Mikkelsen
/// 2008, "Simulation of Wrinkled Surfaces Revisited") at an angular threshold of 180 degrees, for each mesh in its own
/// space. Use it for maps that were baked with MikkTSpace. `published`: averages unit tangents and unit bitangents of
/// all faces at a position, mirrored or not, over the scope. The tangent is made perpendicular to the normal, and
/// negated where it disagrees with the bitangent, which is a separate attribute. All frames are then right-handed, and
/// maps on mirrored texture coordinates run backwards along u. `published_no_handedness`: the same without the
/// negation; w gives the side of the bitangent.
enum class TangentMode : std::uint8_t { averaged, published, mikktspace, published_no_handedness };
/// Whether bitangents are a separate attribute.
inline bool is_published(TangentMode mode) {
    return mode == TangentMode::published || mode == TangentMode::published_no_handedness;
}

/// Whether tangents are orthogonalized against the normals here (`attribute`) or kept as summed (`off`).
enum class Orthogonalize : std::uint8_t { attribute, off };

/// Options of compute_attributes().
struct AttributeOptions {
    Scope scope = Scope::model;
    CornerWeight weight = CornerWeight::angle;
    /// [rad] 0..pi. Faces that share an edge are joined if the angle between their normals is at most this one. A slack of
    /// 1e-5 rad allows for the rounding of positions. pi joins everything at a position, 0 is flat.
    double crease_angle_rad = radians(60);
    /// [m] in world space: positions this close are welded; 0: only equal ones. < 0: automatic, the sum of the rounding
    /// errors of the two meshes that meet. The error of a mesh is zero where both matrices are equal. Else it is 2
    /// float ulps of its largest local coordinate, scaled to the world, plus 1 ulp of the distance of its pivot. That
    /// distance counts from the center of the model's box or from the world origin, whichever is less. The error is at
    /// most 2^-14 of the box's diagonal. For quantized positions see AttributeMesh::position_step. Connected components
    /// of close pairs are one place. Components wider than twice the distance are welded exactly only, with a warning
    /// in the report. Positions never move.
    double weld_distance = -1;
    bool normals = true;         ///< false: keep the given normals (every mesh must have them) and make only tangents
    bool tangents = true;        ///< where texture coordinates exist
    bool groups_across = false;  ///< smoothing groups also apply between objects
    TangentMode tangent_mode = TangentMode::averaged;
    /// `mikktspace` ignores it: it orthogonalizes the vote of each face.
    Orthogonalize orthogonalize = Orthogonalize::attribute;
    bool measure_orthogonality = false;  ///< fill MeshAttributes::orthogonality_loss_*
    /// At a crease angle of pi: faces at a place are joined only across common edges, so each fan is a group (bow-ties
    /// are separated). Below pi this is always so.
    bool fans = false;
    bool locked_vote = true;  ///< faces at locked vertices contribute to the normals of other vertices at their place
};

/// The meaning of smoothing[]: bit masks join when AND != 0 (3DS, ASE), numbers join when equal (OBJ); 0 is flat.
enum class GroupKind : std::uint8_t { none, masks, numbers };

/// One mesh, placed in the world.
struct AttributeMesh {
    std::uint32_t object = 0;                    ///< meshes with equal numbers form one object (Scope::object)
    std::span<const vec3> positions{};           ///< [V] object space; a face with a non-finite corner has no vote
    std::span<const std::uint32_t> indices{};    ///< [3T] each < V; counter-clockwise seen from outside
    std::span<const vec2> texcoords{};           ///< [V] or empty; v down
    std::span<const vec3> normals{};             ///< [V] or empty; read only when AttributeOptions::normals is false
    std::span<const std::uint32_t> smoothing{};  ///< [T] or empty
    GroupKind group_kind = GroupKind::none;
    std::span<const vec3>
        smoothing_hint{};  ///< [3T] or empty: corners of one position whose hints are equal were one group
    dmat4 to_world{};      ///< object -> world, affine; det < 0 mirrors
    /// [V] or empty. Nonzero: the vertex keeps its entry of `normals`, which is then required. Ignored where that
    /// normal is zero or not finite.
    std::span<const std::uint8_t> locked{};
    /// [m] object space, >= 0: the quantization step of the positions; 0: not quantized. A position may be off by half
    /// a step on each axis. AttributeOptions::weld_distance < 0 then uses half the diagonal of the step's cube for this
    /// mesh. It does not weld to a mesh that already has a vertex at the same place, because the next code is then
    /// another place.
    double position_step = 0;
    /// [rad] 0..pi, overrides AttributeOptions::crease_angle_rad; < 0: not set. Between two meshes the smaller angle
    /// applies.
    double crease_angle_rad = -1;
};

/// Result for one mesh: vertex v < V keeps its number; a vertex whose corners differ is appended. Object space.
struct MeshAttributes {
    std::vector<vec3> normals{};  ///< [V'] unit, finite; (0, 0, 1) where no face with a vote touches the vertex's place
    /// [V'] xyz unit and perpendicular to the normal, w = +1 or -1 in object space (a mirroring matrix flips it in
    /// world space); empty without texcoords. Where the texture area is zero: the axis farthest from the world normal,
    /// orthogonalized, w = +1.
    std::vector<vec4> tangents{};
    std::vector<vec3> bitangents{};        ///< [V'] unit, towards decreasing v; filled only by the published modes
    std::vector<std::uint32_t> indices{};  ///< [3T] each < V'; empty when no vertex was split (the input's are valid)
    std::vector<std::uint32_t> source_vertex{};  ///< [V' - V] the vertex that each appended one copies
    std::uint32_t degenerate_faces = 0;          ///< faces without a vote: zero area or a non-finite corner
    std::uint32_t isolated_vertices = 0;         ///< vertices that no face with a vote touches
    /// [degrees] deviation of summed tangents from perpendicular to their normals, in world space before Gram-Schmidt;
    /// 0 unless AttributeOptions::measure_orthogonality.
    double orthogonality_loss_max_deg = 0, orthogonality_loss_mean_deg = 0;
    /// Faces on which a map runs backwards: the mean tangent of their corners points against the direction of u on the
    /// face, or the mean of cross(n, t) * w against that of -v. Counted by the published modes only.
    std::uint32_t inverted_faces = 0;
};

/// Which corners share a normal. Computed once, valid for any positions of the same meshes (poses, morphs), and reused
/// by regroup() when the crease angle changes. Immutable; cheap to copy. Memory: about 45 bytes per triangle.
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

/// First step: finds equal positions (exact in world space, compared in double, -0 equal to +0), joins faces by crease
/// angle and smoothing groups, and finds the vertices to split. Expected O(n), deterministic for any number of threads.
/// Normals are summed only in groups whose face normals may cancel.
/// @throws Error bad_file: sizes that do not fit, an index out of range (first one in the message), a non-finite
///         matrix.
RL_API AttributePlan group(std::span<const AttributeMesh> meshes, const AttributeOptions& options, Context& context);

/// The first step again with other options (a crease slider): the same plan as group(meshes, options, context), faster.
/// Places, face normals and the faces around each place are reused. Another scope (except face), weld_distance or
/// `normals` repeats the weld.
/// @param plan    of group() or regroup()
/// @param meshes as given to group(), unmoved; only their smoothing groups, hints and locks may have changed
/// @throws Error bad_file: counts that differ from the plan's; and as group()
RL_API AttributePlan regroup(const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                             const AttributeOptions& options, Context& context);

/// Second step: the sums over the same meshes. Positions may have moved; counts must be equal. If nothing has moved,
/// the result is bit-identical to compute_attributes(), except at a crease angle of pi with uniform weight, where
/// compute_attributes() sums in float.
/// @return one entry per mesh, in the order of the input
RL_API std::vector<MeshAttributes> accumulate(const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                                              Context& context);

/// The second step for other values of faces (light, measurements): each vertex gets the mean over the faces of its
/// group, with the plan's weights. The result is smooth wherever normals are, also across objects, and sharp at
/// creases. Each component lies between the minimum and maximum over the faces; a constant stays bit-identical.
/// @param meshes as given to group(); positions may have moved
/// @param values [meshes][T] finite; values of faces without a vote are ignored
/// @return [meshes][V'] numbered as in the result of accumulate(); 0 where no face with a vote touches a vertex's group
/// @throws Error bad_file: counts that differ from the plan's
RL_API std::vector<std::vector<vec3>> average(const AttributePlan& plan, std::span<const AttributeMesh> meshes,
                                              std::span<const std::span<const vec3>> values, Context& context);

/// Both steps. All corners of a group get bit-equal vectors in world space, then transformed to each object's space.
RL_API std::vector<MeshAttributes> compute_attributes(std::span<const AttributeMesh> meshes,
                                                      const AttributeOptions& options, Context& context);

/// Output buffers of compute_attributes_into() for one mesh, by the input's vertex numbers; entries beyond V are not
/// written.
struct AttributeBuffers {
    std::span<vec3> normals{};   ///< [>= V]
    std::span<vec4> tangents{};  ///< [>= V] if the mesh has texcoords and tangents are requested; else ignored
};

/// A corner (3 * triangle + 0, 1 or 2) that uses another vertex than the input's index.
struct CornerVertex {
    std::uint32_t corner, vertex;  ///< the corner; its new vertex
    bool operator==(const CornerVertex&) const = default;
};

/// The split vertices of one mesh, which do not fit into its buffers. All empty if none was split (V' = V). Else append
/// normals and tangents to the first V entries of the buffers, and change the listed corners, to get MeshAttributes.
struct SplitAttributes {
    std::vector<std::uint32_t> source_vertex{};  ///< [V' - V] the vertex that each appended one copies; ascending
    std::vector<vec3> normals{};                 ///< [V' - V]
    std::vector<vec4> tangents{};                ///< [V' - V], or empty without tangents
    std::vector<CornerVertex> corners{};         ///< ascending; each vertex is >= V
    std::uint32_t degenerate_faces = 0;          ///< as in MeshAttributes
    std::uint32_t isolated_vertices = 0;         ///< as in MeshAttributes
};

/// Scratch memory of compute_attributes_into(), reused by later calls of any size. It holds 16 bytes per vertex for
/// normals, or 32 for normals and tangents, and 8 more for the weld. The general algorithm needs about 42 bytes per
/// triangle. Not shared by concurrent calls.
class RL_API AttributeWorkspace {
public:
    AttributeWorkspace();
    AttributeWorkspace(AttributeWorkspace&&) noexcept;
    AttributeWorkspace& operator=(AttributeWorkspace&&) noexcept;
    ~AttributeWorkspace();
    std::size_t bytes() const;  ///< allocated now
    struct Impl;
    Impl& impl();  ///< new for a workspace that was moved from

private:
    std::unique_ptr<Impl> impl_;
};

/// compute_attributes() into the caller's buffers. The fast case joins everything at a place: crease angle pi, uniform
/// weight, scope model or object, no smoothing groups or hints, exact weld, one angle-preserving matrix for all meshes.
/// It allocates nothing of the model's size once the workspace has grown. With other options the largest arrays come
/// from the workspace.
///
/// @param out [meshes] buffers must not overlap each other or the input
/// @return split vertices and counts, one entry per mesh; the same values as compute_attributes()
/// @throws Error usage: a buffer too small (mesh and sizes in the message); and as compute_attributes(). The buffers
///         are then unspecified
RL_API std::vector<SplitAttributes> compute_attributes_into(std::span<const AttributeMesh> meshes,
                                                            const AttributeOptions& options,
                                                            std::span<const AttributeBuffers> out,
                                                            AttributeWorkspace& workspace, Context& context);

}  // namespace rakelight
