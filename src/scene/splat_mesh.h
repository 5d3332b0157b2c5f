// SPDX-License-Identifier: Apache-2.0
// Splats as triangles: how a mesh has them, and how it is known again. A splat is two flat pyramids on one hexagon: its rim lies
// in the plane of the point's normal, an apex before it and one behind. From either side the nearer center shows where splats overlap, up
// to how the surface bends.
#pragma once
#include <cstddef>
#include <cstdint>

#include <rakelight/scene.h>

namespace rakelight {

inline constexpr std::size_t splat_rim = 6, splat_vertices = 2 + splat_rim, splat_triangles = 2 * splat_rim;
inline constexpr float splat_slope = 0.25f;  ///< height of an apex over the rim's radius

/// The number of a splat's vertex that is a corner of one of its triangles: 0 and 1 are the apexes before and behind, then the rim.
/// All triangles turn about the point's normal as fronts do.
/// @param corner  3 * triangle + k
constexpr std::uint32_t splat_corner(std::size_t corner) {
    const std::size_t triangle = corner / 3, k = corner % 3;
    return std::uint32_t(k == 0 ? triangle / splat_rim : 2 + (triangle + k - 1) % splat_rim);
}

/// Whether all of a mesh is splats in the order of their numbers: splat s has vertices and triangles from s times their number on.
inline bool is_of_splats(const Mesh& mesh) {
    const std::size_t splats = mesh.positions.size() / splat_vertices;
    if (mesh.topology != Topology::triangles || splats == 0 || mesh.positions.size() % splat_vertices != 0 ||
        mesh.indices.size() != 3 * splat_triangles * splats)
        return false;
    for (std::size_t s = 0, i = 0; s < splats; ++s)
        for (std::size_t corner = 0; corner < 3 * splat_triangles; ++corner, ++i)
            if (mesh.indices[i] != splat_vertices * s + splat_corner(corner)) return false;
    return true;
}

}  // namespace rakelight
