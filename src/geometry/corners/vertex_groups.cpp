// SPDX-License-Identifier: Apache-2.0
#include "geometry/corners/vertex_groups.h"

namespace rakelight::geometry {

// Counting sort by group; one pass over all vertices, then only over vertices that share.
VertexGroups make_vertex_groups(const std::vector<std::uint32_t>& group, GeneralScratch* scratch) {
    VertexGroups groups;
    std::vector<std::uint32_t> sharing, size;
    if (scratch) size = scratch->take_words();
    size.assign(group.size(), 0);
    for (std::uint32_t v = 0; v < group.size(); ++v)
        if (group[v] != v) {
            sharing.push_back(v);
            ++size[group[v]];
        }
    std::uint32_t sum = 0;
    groups.begin.push_back(0);
    for (std::uint32_t g = 0; g < group.size() && !sharing.empty(); ++g) {
        if (size[g] == 0) continue;
        const std::uint32_t count = size[g] + 1;
        size[g] = sum;  // from here on: position of the next member
        sum += count;
        groups.begin.push_back(sum);
    }
    groups.members.resize(sum);
    // The representative need not be the smallest member, so both are inserted in index order.
    std::vector<std::uint8_t> stands(sharing.empty() ? 0 : group.size(), 0);
    for (const std::uint32_t v : sharing) stands[group[v]] = 1;
    std::size_t next = 0;
    for (std::uint32_t v = 0; v < stands.size(); ++v) {
        const bool shares = next < sharing.size() && sharing[next] == v;
        if (shares) ++next;
        if (shares || stands[v] != 0) groups.members[size[group[v]]++] = v;
    }
    if (scratch) scratch->give(size);
    return groups;
}

}  // namespace rakelight::geometry
