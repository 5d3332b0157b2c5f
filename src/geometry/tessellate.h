// SPDX-License-Identifier: Apache-2.0
// Triangles cut finer without cracks, whatever meshes meet along an edge.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/vector.h>

#include "geometry/place_classes.h"

namespace rakelight::geometry {

/// A mesh to be cut.
struct CoarseMesh {
    std::vector<dvec3> places;  ///< [V] m in the world, equal to the bit where vertices of any meshes are at one place
    std::vector<std::uint32_t> indices;  ///< [3T]
    /// [V] or empty: not 0: on a border. Where it is not empty only edges between two such vertices are cut: of meshes
    /// that stay coarse beside one that is cut finer.
    std::vector<std::uint8_t> on_border;
};

/// [meshes] As they stand in the world, without borders.
std::vector<CoarseMesh> coarse_meshes(const PlacedMeshes& placed);

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
/// passes `max_triangles`.
/// @param edge  [m] > 0
/// @param met  out, for tests: pairs of edges that shared a slot of a table, of the last round; null: not wanted
Tessellation tessellate(std::span<const CoarseMesh> meshes, double edge, std::uint64_t max_triangles, Context& context,
                        std::uint64_t* met = nullptr);

/// Whether an edge is halved, by its two places alone: the same for (a, b) and (b, a). Called by any thread.
using EdgeRule = std::function<bool(dvec3 a, dvec3 b)>;

/// The mesh before the first cut; `on_border` does not count.
FineMesh uncut(CoarseMesh mesh);

/// Cuts the triangles at every edge that the rule names once, as tessellate() does: triangles that stay keep the order of
/// their corners. `source_triangle` follows, of what it counted before.
/// @return false: the sum would pass `max_triangles`, and nothing was cut
bool halve_edges(std::span<FineMesh> meshes, const EdgeRule& is_halved, std::uint64_t max_triangles, Context& context);

}  // namespace rakelight::geometry
