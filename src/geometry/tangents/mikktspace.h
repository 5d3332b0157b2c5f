// SPDX-License-Identifier: Apache-2.0
// Reproduces the tangents of MikkTSpace, used for baking most normal maps. Source: Mikkelsen 2008, "Simulation of
// Wrinkled Surfaces Revisited", master's thesis, DIKU, with the behavior of the published reference code at an angular
// threshold of 180 degrees.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/geometry/attributes.h>

namespace rakelight::geometry {

/// One mesh with a normal per vertex, in object space. All arrays [V] but `indices` [3T], each < V.
struct MikktspaceMesh {
    std::span<const vec3> positions, normals;
    std::span<const vec2> texcoords;  ///< v down
    std::span<const std::uint32_t> indices;
};

/// The tangent of each corner: xyz unit and perpendicular to the normal; w = +1 or -1, for a bitangent towards
/// decreasing v. Zero where the reference code keeps its default (no neighboring face with texture area) or the sum
/// vanishes. Single-threaded, O(n log n). Groups with exactly opposite tangents take O(k^2) in their size up to 256;
/// larger ones are summed.
/// @return [3T]
std::vector<vec4> mikktspace_corners(const MikktspaceMesh& mesh);

/// [bytes] memory of mikktspace_corners().
std::uint64_t mikktspace_bytes(std::uint64_t vertices, std::uint64_t triangles);

/// Replaces the tangents of one mesh's result by those of MikkTSpace; vertices whose corners differ are split. Corners
/// without one get perpendicular() of the object-space normal.
void give_mikktspace(const AttributeMesh& mesh, MeshAttributes& result);

}  // namespace rakelight::geometry
