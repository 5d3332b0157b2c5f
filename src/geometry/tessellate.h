// SPDX-License-Identifier: Apache-2.0
// Triangles cut finer without cracks, whatever meshes meet along an edge.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/vector.h>

namespace rakelight::geometry {

/// A mesh to be cut.
struct CoarseMesh {
    std::vector<dvec3> places;  ///< [V] m in the world, equal to the bit where vertices of any meshes are at one place
    std::vector<std::uint32_t> indices;  ///< [3T]
    /// [V] or empty: not 0: on a border. Where it is not empty only edges between two such vertices are cut: of meshes
    /// that stay coarse beside one that is cut finer.
    std::vector<std::uint8_t> on_border;
};

struct FineMesh {
    std::vector<dvec3> places;  ///< [V'] the first V are the coarse mesh's
    std::vector<std::array<std::uint32_t, 2>>
        middle_of;                       ///< [V' - V] each new vertex halves the edge between these two, both before it
    std::vector<std::uint32_t> indices;  ///< [3T']
    std::vector<std::uint32_t> source_triangle;  ///< [T'] of the coarse mesh
};

struct Tessellation {
    std::vector<FineMesh> meshes;
    double longest_edge = 0;  ///< [m] of those that are cut everywhere
    bool is_complete = true;  ///< false: the number of triangles came to its limit first
};

/// Halves every edge that is longer than `edge` (and the triangles at it: one edge gives 2, two give 3, three give 4),
/// again and again. Whether an edge is halved depends on its two places alone, so that all triangles at it, of any
/// mesh, agree: nothing opens. The same result for any number of threads. Stops, for all meshes at once, before the sum
/// passes `most_triangles`.
/// @param edge  [m] > 0
/// @param met  out, for tests: pairs of edges that shared a slot of a table, of the last round; null: not wanted
Tessellation tessellate(std::span<const CoarseMesh> meshes, double edge, std::uint64_t most_triangles, Context& context,
                        std::uint64_t* met = nullptr);

}  // namespace rakelight::geometry
