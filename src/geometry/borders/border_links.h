// SPDX-License-Identifier: Apache-2.0
// Which border nodes follow which edges of other meshes: matches -> stretches -> the side that leads -> links.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/borders/border_nodes.h"
#include "geometry/borders/border_search.h"

namespace rakelight::geometry {

/// A node that follows an edge at `t` from its end `a` to its end `b`.
struct BorderLink {
    std::uint32_t node = 0;
    std::uint32_t member_a = 0, member_b = 0;  ///< of BorderNodes: the ends of the edge in its own mesh
    std::uint32_t node_a = 0, node_b = 0;      ///< that these are in
    double t = 0;
    std::uint32_t depth = 1;  ///< 1: neither end that counts follows anything; at most `max_depth`
    bool counts_a() const { return t < 1; }
    bool counts_b() const { return t > 0; }
};

constexpr std::uint32_t max_depth = 4;

struct BorderLinks {
    std::vector<BorderLink> links;  ///< by depth, then by node; each node once
    std::uint64_t vertices_not_searched = 0;
};

/// @param edges  of border_edges(), whose ends are members of `nodes`
BorderLinks link_borders(const BorderSearch& search, const AttributeInput& input, const BorderNodes& nodes,
                         double distance, Context& context);

}  // namespace rakelight::geometry
