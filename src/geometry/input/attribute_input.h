// SPDX-License-Identifier: Apache-2.0
// The checked input of compute_attributes() for all its stages: global indices of vertices and triangles over all
// meshes, the matrices for normals and tangents, and the fixed chunks of work.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/geometry/attributes.h>

#include "math/linear.h"

namespace rakelight::geometry {

/// The placement of one mesh in world space.
struct Placement {
    dmat4 to_world;
    dmat3 linear;  ///< directions: object -> world
    dmat3
        normal_to_world;  ///< normals: cofactor matrix times the sign of the determinant, so that normals stay outward
    double flip = 1;      ///< -1 where the matrix mirrors, else +1
    double scale = 0;     ///< length of the longest column of `linear`

    dvec3 position(vec3 p) const { return transform_point(to_world, cast<double>(p)); }
};

/// The placement of each mesh. Consecutive meshes with equal matrices share one entry, for example the meshes of one
/// object.
class PlacementTable {
public:
    void reserve(std::size_t meshes) { number_.reserve(meshes); }
    void push_back(const dmat4& to_world);
    const Placement& operator[](std::size_t mesh) const { return distinct_[number_[mesh]]; }
    /// The distinct placements, and the index of each mesh's placement.
    const std::vector<Placement>& distinct() const { return distinct_; }
    std::uint32_t number(std::size_t mesh) const { return number_[mesh]; }

private:
    std::vector<Placement> distinct_;
    std::vector<std::uint32_t> number_;  ///< [meshes]
};

/// All meshes of a call with global indices: vertex v of mesh m is vertex_base[m] + v, corner k of triangle t is 3 *
/// (triangle_base[m] + t) + k. Both totals fit 32 bits (checked).
struct AttributeInput {
    std::span<const AttributeMesh> meshes;
    std::vector<std::uint32_t> vertex_base, triangle_base;  ///< [meshes + 1]
    PlacementTable placements;                              ///< [meshes]

    std::uint32_t vertex_count() const { return vertex_base.back(); }
    std::uint32_t triangle_count() const { return triangle_base.back(); }
    std::uint32_t mesh_of_vertex(std::uint32_t vertex) const { return owner(vertex_base, vertex); }
    std::uint32_t mesh_of_triangle(std::uint32_t triangle) const { return owner(triangle_base, triangle); }
    /// The input's vertex of a corner, as a global index.
    std::uint32_t corner_vertex(std::uint32_t mesh, std::uint32_t corner) const {
        return vertex_base[mesh] + meshes[mesh].indices[corner - 3 * triangle_base[mesh]];
    }

private:
    static std::uint32_t owner(const std::vector<std::uint32_t>& base, std::uint32_t item) {
        return std::uint32_t(std::upper_bound(base.begin(), base.end(), item) - base.begin()) - 1;
    }
};

/// Checks sizes, indices, matrices and options.
/// @throws Error bad_file, place "mesh N"
AttributeInput check_input(std::span<const AttributeMesh> meshes, Context& context);
/// The two halves of check_input(): everything except the indices, and the indices (the message names the first bad
/// one).
AttributeInput number_input(std::span<const AttributeMesh> meshes);
void check_indices(const AttributeInput& input, Context& context);
void check_options(const AttributeOptions& options);
/// For functions that need given normals.
/// @throws Error bad_file: not one per vertex
void check_normals(std::span<const AttributeMesh> meshes);

/// Whether the rule of creases decides at the edges of a mesh, not an angle.
inline bool follows_rule(const AttributeMesh& mesh, const AttributeOptions& options) {
    return options.creases == Creasing::automatic && mesh.crease_angle_rad < 0;
}
/// [rad] The crease angle of one mesh; pi if it follows the rule.
inline double crease_angle(const AttributeMesh& mesh, const AttributeOptions& options) {
    if (mesh.crease_angle_rad >= 0) return mesh.crease_angle_rad;
    return options.creases == Creasing::automatic ? pi : options.crease_angle_rad;
}
/// [rad] Range over all meshes; without meshes the options' angle.
struct CreaseRange {
    double least, most;
    bool has_rule = false;  ///< some mesh follows the rule
    bool joins_all() const { return !has_rule && least + 1e-6 >= pi; }
};
CreaseRange crease_range(std::span<const AttributeMesh> meshes, const AttributeOptions& options);

/// A unit of work, independent of the number of threads: one piece of a large mesh (`pieces` > 1), or several whole
/// meshes.
struct Chunk {
    std::uint32_t mesh_begin = 0, mesh_end = 0;
    std::uint32_t piece = 0, pieces = 1;
};

/// First item of a piece when `count` items are split into equal pieces.
inline std::uint32_t piece_begin(std::uint32_t count, std::uint32_t piece, std::uint32_t pieces) {
    return std::uint32_t(std::uint64_t(count) * piece / pieces);
}
/// The piece that holds an item: the largest p with piece_begin(count, p, pieces) <= item.
inline std::uint32_t piece_of(std::uint32_t item, std::uint32_t count, std::uint32_t pieces) {
    return std::uint32_t(((std::uint64_t(item) + 1) * pieces - 1) / count);
}

/// Chunks of about `target` items over meshes of base[m + 1] - base[m] items; at most 64 pieces per mesh.
std::vector<Chunk> make_chunks(std::span<const std::uint32_t> base, std::uint32_t target);

/// Calls body(mesh, first, last) for each range of items in a chunk, with indices local to the mesh.
template <class Body>
void for_each_range(const Chunk& chunk, std::span<const std::uint32_t> base, const Body& body) {
    for (std::uint32_t m = chunk.mesh_begin; m != chunk.mesh_end; ++m) {
        const std::uint32_t count = base[m + 1] - base[m];
        body(m, piece_begin(count, chunk.piece, chunk.pieces), piece_begin(count, chunk.piece + 1, chunk.pieces));
    }
}

constexpr std::uint32_t triangles_per_chunk = 1u << 16;
constexpr std::uint32_t vertices_per_chunk = 1u << 15;

}  // namespace rakelight::geometry
