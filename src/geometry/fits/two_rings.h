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
            bits_ = std::max(11u, unsigned(std::bit_width(2 * most)));
            slots_.assign(std::size_t(1) << bits_, 0);
            round_ = 1;
        }
        if (groups_.size() <= most) groups_.resize(most + 1);
        count_ = 0;
    }
    /// In all at most clear()'s `most`.
    void add(std::span<const std::uint32_t> groups) {
        // Multiplication by a random odd number: Dietzfelbinger et al. 1997, "A reliable randomized algorithm for the
        // closest-pair problem" (lemma 1).
        std::uint64_t* const slots = slots_.data();
        std::uint32_t* const out = groups_.data();
        const std::uint64_t factor = factor_, mask = slots_.size() - 1, round = round_;
        const unsigned shift = 64 - bits_;
        std::size_t count = count_;
        for (const std::uint32_t group : groups) {
            const std::uint64_t taken = round << 32 | group;
            std::size_t at = (group * factor) >> shift;
            while (slots[at] >> 32 == round && slots[at] != taken) at = (at + 1) & mask;
            out[count] = group;  // without a branch: whether it is new could not be foretold
            count += slots[at] != taken ? 1 : 0;
            slots[at] = taken;
        }
        count_ = count;
    }
    std::span<const std::uint32_t> groups() const { return {groups_.data(), count_}; }

private:
    std::uint64_t factor_ = hash_key_of_this_run().a | 1;  // the order of groups does not depend on it
    std::vector<std::uint64_t> slots_;                     // the round in which it was taken, and the group
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
    out.add({&group, 1});
    out.add(ring);
    for (const std::uint32_t u : ring)
        if (rings.ring_size[u] <= most_to_widen) out.add(rings.ring(u));
}

}  // namespace rakelight::geometry
