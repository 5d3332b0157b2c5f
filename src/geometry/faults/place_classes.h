// SPDX-License-Identifier: Apache-2.0
// Meshes with welded vertices in world space, for queries of a model's surface.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/input/attribute_input.h"

namespace rakelight::geometry {

/// Vertices and triangles have global indices (see AttributeInput).
struct PlacedMeshes {
    AttributeInput input;
    std::vector<std::uint32_t> place;  ///< [vertices] the smallest vertex at the same place in the world

    std::uint32_t object_of_triangle(std::uint32_t triangle) const {
        return input.meshes[input.mesh_of_triangle(triangle)].object;
    }
    /// [m] in the world
    dvec3 position(std::uint32_t vertex) const {
        const std::uint32_t m = input.mesh_of_vertex(vertex);
        return input.placements[m].position(input.meshes[m].positions[vertex - input.vertex_base[m]]);
    }
};

/// Welds as compute_attributes() does (AttributeOptions::weld_distance). The meshes' arrays must outlive the result.
/// O(n).
/// @throws Error bad_file: inconsistent sizes, an index out of range, a non-finite matrix, more than 2^32 vertices and
///         corners, over the memory budget
PlacedMeshes place_vertices(std::span<const AttributeMesh> meshes, double weld_distance, Context& context);

/// The places of a triangle's corners. False if a corner is not finite, or two are at one place.
struct FacePlaces {
    std::uint32_t corner[3];
};
bool face_places(const PlacedMeshes& placed, std::uint32_t mesh, std::uint32_t triangle, FacePlaces& out);

}  // namespace rakelight::geometry
