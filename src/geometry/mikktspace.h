// SPDX-License-Identifier: Apache-2.0
// Tangents that reproduce MikkTSpace, the space in which most normal maps are baked.
// Source: Mikkelsen 2008, "Simulation of Wrinkled Surfaces Revisited", master's thesis, DIKU, with the behavior of its
// published standard at an angular threshold of 180 degrees.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/attributes.h>

namespace rakelight::geometry {

/// One mesh with a normal at each vertex, in its own space. All arrays [V] but `indices` [3T], each < V.
struct MikktspaceMesh {
    std::span<const vec3> positions, normals;
    std::span<const vec2> texcoords;  ///< v down
    std::span<const std::uint32_t> indices;
};

/// The tangent of each corner: xyz unit and across the normal, or zero where the standard leaves its default (no face
/// with an area in the texture is near) or the sum vanishes; w = +1 or -1, for a bitangent towards decreasing v. One
/// thread; O(n log n), but where tangents of one group are exactly opposite O(k^2) in its size, up to 256 (beyond, all
/// are summed).
/// @return [3T]
std::vector<vec4> mikktspace_corners(const MikktspaceMesh& mesh);

/// Bytes that mikktspace_corners() holds for so many vertices and triangles.
std::uint64_t mikktspace_bytes(std::uint64_t vertices, std::uint64_t triangles);

/// Replaces the tangents of one mesh's result by those of MikkTSpace; vertices whose corners differ are split. Where a
/// corner has none: perpendicular() of the object-space normal.
void give_mikktspace(const AttributeMesh& mesh, MeshAttributes& result);

}  // namespace rakelight::geometry
