// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/input/block_array.h"

namespace rakelight::geometry {

/// The groups of two or more vertices as lists with ascending members. Vertices in no list are single.
struct VertexGroups {
    std::vector<std::uint32_t> begin;  ///< [groups + 1]
    std::vector<std::uint32_t> members;
    std::size_t size() const { return begin.size() - 1; }
};

/// @param group [vertices] representative of each vertex' group; group[g] == g
/// @param scratch  source of memory; null: allocate
VertexGroups make_vertex_groups(const std::vector<std::uint32_t>& group, GeneralScratch* scratch = nullptr);

}  // namespace rakelight::geometry
