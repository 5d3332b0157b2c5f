// SPDX-License-Identifier: Apache-2.0
// The neighbors of a corner group and their neighbors.
#pragma once
#include <vector>

#include "base/hash_key.h"
#include "geometry/group_rings.h"

namespace rakelight::geometry {

/// A set of groups, in the order in which they came. Reused, so that it allocates nothing for most groups.
class GroupSet {
public:
    void clear(std::size_t most) {
        std::size_t size = 64;
        while (size < 2 * most) size *= 2;
        slots_.assign(size, none);
        if (groups_.size() < most) groups_.resize(most);
        count_ = 0;
    }
    /// At most clear()'s `most` times.
    void add(std::uint32_t group) {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = folded_product(group ^ key_.a, key_.b | 1) & mask;
        while (slots_[at] != none) {
            if (slots_[at] == group) return;
            at = (at + 1) & mask;
        }
        slots_[at] = group;
        groups_[count_++] = group;
    }
    std::span<const std::uint32_t> groups() const { return {groups_.data(), count_}; }

private:
    static constexpr std::uint32_t none = 0xffffffffu;
    HashKey key_ = hash_key_of_this_run();  // the order of groups does not depend on it
    std::vector<std::uint32_t> slots_, groups_;
    std::size_t count_ = 0;
};

/// Neighbors of more than this many places are not passed through to the second ring.
constexpr std::uint32_t most_to_widen = 64;

/// The group itself first, then both rings.
inline void two_rings(const GroupRings& rings, std::uint32_t group, GroupSet& out) {
    const std::span<const std::uint32_t> ring = rings.ring(group);
    std::size_t most = 1 + ring.size();
    for (const std::uint32_t u : ring)
        if (rings.ring_size[u] <= most_to_widen) most += rings.ring_size[u];
    out.clear(most);
    out.add(group);
    for (const std::uint32_t u : ring) out.add(u);
    for (const std::uint32_t u : ring)
        if (rings.ring_size[u] <= most_to_widen)
            for (const std::uint32_t v : rings.ring(u)) out.add(v);
}

}  // namespace rakelight::geometry
