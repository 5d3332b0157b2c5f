// SPDX-License-Identifier: Apache-2.0
// Splats as triangles: layout and detection. A splat consists of two flat pyramids on one hexagon: the rim lies in the
// plane of the point's normal, with an apex on each side. Where splats overlap, the one with the nearer center is
// visible from either side, except for the curvature of the surface.
#pragma once
#include <cstddef>
#include <cstdint>

#include <rakelight/scene/scene.h>

namespace rakelight {

inline constexpr std::size_t splat_rim = 6, splat_vertices = 2 + splat_rim, splat_triangles = 2 * splat_rim;
inline constexpr float splat_slope = 0.25f;  ///< apex height divided by rim radius

/// The local vertex index of a splat's corner: 0 and 1 are the front and back apexes, then the rim. All triangles are
/// front faces with respect to the point's normal.
/// @param corner  3 * triangle + k
constexpr std::uint32_t splat_corner(std::size_t corner) {
    const std::size_t triangle = corner / 3, k = corner % 3;
    return std::uint32_t(k == 0 ? triangle / splat_rim : 2 + (triangle + k - 1) % splat_rim);
}

/// Whether a mesh consists only of splats in order: splat s starts at s times the number of vertices and triangles of a
/// splat.
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
