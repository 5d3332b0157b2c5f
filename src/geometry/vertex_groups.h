// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

namespace rakelight::geometry {

/// The groups of two and more vertices, as lists; members ascend. A vertex in no list is alone.
struct VertexGroups {
    std::vector<std::uint32_t> begin;  ///< [groups + 1]
    std::vector<std::uint32_t> members;
    std::size_t size() const { return begin.size() - 1; }
};

/// @param group  [vertices] the vertex that stands for each one's group; group[g] == g
VertexGroups make_vertex_groups(const std::vector<std::uint32_t>& group);

}  // namespace rakelight::geometry
