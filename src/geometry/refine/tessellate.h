// SPDX-License-Identifier: Apache-2.0
// Crack-free tessellation of triangles, also between meshes.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/math/vector.h>

#include "geometry/faults/place_classes.h"

namespace rakelight::geometry {

/// A mesh to tessellate.
struct CoarseMesh {
    std::vector<dvec3> places;  ///< [V] m in the world, equal to the bit where vertices of any meshes are at one place
    std::vector<std::uint32_t> indices;  ///< [3T]
    /// [V] or empty. Nonzero: on a border. If present, only edges between two border vertices are split: for coarse
    /// meshes next to a finer one.
    std::vector<std::uint8_t> on_border;
};

/// [meshes] in world space, without borders.
std::vector<CoarseMesh> coarse_meshes(const PlacedMeshes& placed);

struct FineMesh {
    std::vector<dvec3> places;  ///< [V'] the first V are the coarse mesh's
    std::vector<std::array<std::uint32_t, 2>>
        middle_of;  ///< [V' - V] each new vertex bisects the edge between these two earlier vertices
    std::vector<std::uint32_t> indices;          ///< [3T']
    std::vector<std::uint32_t> source_triangle;  ///< [T'] of the coarse mesh
};

struct Tessellation {
    std::vector<FineMesh> meshes;
    double longest_edge = 0;  ///< [m] of edges that are split everywhere
    bool is_complete = true;  ///< false: the limit of triangles was reached first
};

/// Bisects every edge longer than `edge`, repeatedly; a triangle with one, two or three such edges becomes 2, 3 or 4.
/// The decision depends only on the two positions of an edge, so all triangles of all meshes agree and no crack opens.
/// The result is equal for any number of threads. Stops for all meshes at once before the sum exceeds `max_triangles`.
/// @param edge  [m] > 0
/// @param met out, for tests: hash collisions of the last round; may be null
Tessellation tessellate(std::span<const CoarseMesh> meshes, double edge, std::uint64_t max_triangles, Context& context,
                        std::uint64_t* met = nullptr);

/// Whether to bisect an edge, by its two positions only: equal for (a, b) and (b, a). Called from any thread.
using EdgeRule = std::function<bool(dvec3 a, dvec3 b)>;

/// The unrefined mesh; ignores `on_border`.
FineMesh uncut(CoarseMesh mesh);

/// Bisects the edges selected by the rule once, as in tessellate(). Unchanged triangles keep the order of their
/// corners. `source_triangle` is updated.
/// @return false: the sum would exceed `max_triangles`, and nothing was changed
bool halve_edges(std::span<FineMesh> meshes, const EdgeRule& is_halved, std::uint64_t max_triangles, Context& context);

}  // namespace rakelight::geometry
