// SPDX-License-Identifier: Apache-2.0
// Corner groups as the vertices of one surface over all objects: where they are, their faces, their neighbors.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/corner_bins.h"
#include "geometry/topology.h"

namespace rakelight::geometry {

/// Groups have the numbers of their representatives, as in Topology::group. Faces without area are left out.
struct GroupRings {
    FaceNormals face_normals;                    ///< [triangles] unit; zero: no face
    std::vector<std::uint32_t> group_of_corner;  ///< [3 * triangles]
    CornerBins corners;                          ///< [groups] also of faces without area
    std::vector<std::uint32_t> ring_size;        ///< [groups] 0 for all that are no representatives
    BlockArray<std::uint32_t> ring_members;
    BlockArray<dvec3> places;  ///< [groups] world, of representatives

    /// Groups that share an edge with this one, ascending.
    std::span<const std::uint32_t> ring(std::uint32_t group) const {
        return {ring_members.data() + 2 * std::size_t(corners.begin[group]), ring_size[group]};
    }
    bool is_face(std::uint32_t triangle) const { return face_normals[triangle] != dvec3{}; }
};

GroupRings group_rings(const Topology& topology, const AttributeInput& input, Context& context);

/// Calls body(group) for the representatives of a range of groups.
template <class Body>
void for_each_group(const Topology& topology, std::size_t first, std::size_t last, const Body& body) {
    for (std::size_t g = first; g < last; ++g)
        if (topology.group[g] == g) body(std::uint32_t(g));
}

}  // namespace rakelight::geometry
