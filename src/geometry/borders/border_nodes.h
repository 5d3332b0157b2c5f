// SPDX-License-Identifier: Apache-2.0
// Nodes of open edges: vertices at one place with equal normals are one node, across meshes.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/faults/place_classes.h"

namespace rakelight::geometry {

struct BorderNodes {
    static constexpr std::uint32_t no_node = 0xffffffffu;

    std::vector<std::uint32_t> member_begin;  ///< [nodes + 1] into `members`
    std::vector<std::uint32_t> members;       ///< global vertex indices, ascending inside a node
    std::vector<std::uint32_t> corner_begin;  ///< [members + 1] into `corners`
    std::vector<std::uint32_t> corners;       ///< global corner indices that use the member
    std::vector<std::uint32_t> place;         ///< [nodes] ascending
    std::vector<dvec3> normals;               ///< [nodes] unit, world

    std::uint32_t count() const { return std::uint32_t(place.size()); }
    std::span<const std::uint32_t> members_of(std::uint32_t node) const {
        return std::span(members).subspan(member_begin[node], member_begin[node + 1] - member_begin[node]);
    }
    std::span<const std::uint32_t> corners_of(std::uint32_t member) const {
        return std::span(corners).subspan(corner_begin[member], corner_begin[member + 1] - corner_begin[member]);
    }
};

/// Normals are equal within `authored_equality`, or bit-equal at places with more than 64 different ones. Vertices
/// without a usable normal are in no node.
/// @param open_corners of find_open_edges()
BorderNodes find_border_nodes(const PlacedMeshes& placed, std::span<const std::uint32_t> open_corners,
                              Context& context);

/// The member of a vertex, or no_node; and the node of a member.
class MemberIndex {
public:
    explicit MemberIndex(const BorderNodes& nodes);
    std::uint32_t member_of(std::uint32_t vertex) const;
    std::uint32_t node_of_member(std::uint32_t member) const { return node_[member]; }

private:
    struct Entry {
        std::uint32_t vertex, member;
    };
    std::vector<Entry> entries_;       ///< by vertex
    std::vector<std::uint32_t> node_;  ///< [members]
};

}  // namespace rakelight::geometry
