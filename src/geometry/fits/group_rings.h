// SPDX-License-Identifier: Apache-2.0
// Corner groups as the vertices of one surface over all objects: where they are, their faces, their neighbors.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/corners/corner_bins.h"
#include "geometry/corners/topology.h"

namespace rakelight::geometry {

/// What places ask of a triangle.
struct GroupFace {
    vec3 normal;               ///< unit, world; zero: no face
    float area = 0;            ///< [m^2]
    float slack_rad = 0;       ///< by how much the rounding of positions may turn the normal
    bool is_mirrored = false;  ///< its placement turns the order of its corners around
};

/// Groups have the numbers of their representatives, as in Topology::group. Faces without area are left out.
struct GroupRings {
    BlockArray<GroupFace> faces;                ///< [triangles]
    BlockArray<std::uint32_t> group_of_corner;  ///< [3 * triangles]
    CornerBins corners;                         ///< [groups] also of faces without area
    BlockArray<dvec3> places;                   ///< [groups] world, of representatives
    std::vector<std::uint32_t> ring_begin;      ///< [groups] in the chunk's members
    std::vector<std::uint32_t> ring_size;       ///< [groups] 0 for all that are no representatives, or not wanted
    std::vector<std::vector<std::uint32_t>> ring_members;  ///< [chunks of vertices_per_chunk]
    MemoryCharge charge;

    void release(GeneralScratch& scratch);

    /// Groups that share an edge with this one, each once.
    std::span<const std::uint32_t> ring(std::uint32_t group) const {
        return {ring_members[group / vertices_per_chunk].data() + ring_begin[group], ring_size[group]};
    }
    bool is_face(std::uint32_t triangle) const { return faces[triangle].normal != vec3{}; }
    dvec3 normal(std::uint32_t triangle) const { return cast<double>(faces[triangle].normal); }
    /// The other two groups of a corner's face, counter-clockwise as seen from outside.
    std::uint32_t next(std::uint32_t corner) const {
        return group_of_corner[faces[corner / 3].is_mirrored ? corner_before(corner) : corner_after(corner)];
    }
    std::uint32_t previous(std::uint32_t corner) const {
        return group_of_corner[faces[corner / 3].is_mirrored ? corner_after(corner) : corner_before(corner)];
    }
};

/// All but rings.
/// @param known  [groups] not 0: its corners and their faces are asked for; empty: all. Nothing is known of other faces
GroupRings group_faces(const Topology& topology, const AttributeInput& input, std::span<const std::uint8_t> known,
                       GeneralScratch& scratch, Context& context);

/// Calls body(group) for the representatives of a range of groups.
template <class Body>
void for_each_group(const Topology& topology, std::size_t first, std::size_t last, const Body& body) {
    for (std::size_t g = first; g < last; ++g)
        if (topology.group[g] == g) body(std::uint32_t(g));
}

}  // namespace rakelight::geometry
