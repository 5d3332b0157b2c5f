// SPDX-License-Identifier: Apache-2.0
// The neighbors of a corner group and their neighbors.
#pragma once
#include <algorithm>
#include <bit>
#include <vector>

#include "base/hash_key.h"
#include "geometry/fits/group_rings.h"

namespace rakelight::geometry {

/// A set of groups, in the order in which they came. Reused, so that it allocates nothing for most groups.
class GroupSet {
public:
    void clear(std::size_t most) {
        if (slots_.size() < 2 * most || ++round_ == 0) {
            bits_ = std::max(8u, unsigned(std::bit_width(2 * most)));
            slots_.assign(std::size_t(1) << bits_, Slot{});
            round_ = 1;
        }
        if (groups_.size() < most) groups_.resize(most);
        count_ = 0;
    }
    /// At most clear()'s `most` times.
    void add(std::uint32_t group) {
        // Multiplication by a random odd number: Dietzfelbinger et al. 1997, "A reliable randomized algorithm for the
        // closest-pair problem" (lemma 1).
        std::size_t at = (group * factor_) >> (64 - bits_);
        for (; slots_[at].round == round_; at = (at + 1) & (slots_.size() - 1))
            if (slots_[at].group == group) return;
        slots_[at] = {group, round_};
        groups_[count_++] = group;
    }
    std::span<const std::uint32_t> groups() const { return {groups_.data(), count_}; }

private:
    struct Slot {
        std::uint32_t group = 0, round = 0;  ///< taken in the round of this number
    };
    std::uint64_t factor_ = hash_key_of_this_run().a | 1;  // the order of groups does not depend on it
    std::vector<Slot> slots_;
    std::vector<std::uint32_t> groups_;
    std::uint32_t round_ = 0;
    unsigned bits_ = 0;
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
