// SPDX-License-Identifier: Apache-2.0
// Grid cells with several places: candidates for welding within a distance.
//
// A place within half the distance of a cell's wall is also in the neighbor, so every pair within the distance shares a
// cell. Cells are identified by a 32-bit hash; collisions only add candidates. Larger cells would have fewer entries
// (here twice as many as places) but more candidates, and small parts of a wide scene would crowd in them.
#pragma once
#include <bit>
#include <vector>

#include "base/hash_key.h"
#include "geometry/input/attribute_input.h"
#include "geometry/input/fast_memory.h"

namespace rakelight::geometry {

class NearCells {
public:
    /// @param representative  [vertices] of weld_positions(): places are its own members
    /// @param origin    at or below all places in each axis
    /// @param distance  > 0; the box of all places is less than 1e15 distances wide
    NearCells(const std::vector<std::uint32_t>& representative, const AttributeInput& input, dvec3 origin,
              double distance, Context& context);

    /// Shares of the work.
    std::uint32_t partitions() const { return partitions_; }

    /// Calls body(vertices) for each cell of a partition with two places or more: std::span<const std::uint32_t>, none
    /// twice.
    /// @return number of visited slots of other cells, which measures how evenly the table fills
    template <class Body>
    std::uint64_t for_each_shared_cell(std::uint32_t partition, const Body& body) const {
        const Entry* entries = entries_.data() + begin_[partition];
        const std::uint32_t count = begin_[partition + 1] - begin_[partition];
        const std::uint32_t mask = std::uint32_t(std::bit_ceil(std::uint64_t(count) * 2 + 1) - 1);
        std::vector<std::uint32_t> last(std::size_t(mask) + 1, nobody), previous(count), cell;
        std::uint64_t met = 0;
        for (std::uint32_t e = 0; e != count; ++e) {
            std::uint32_t slot = slot_of(entries[e].tag) & mask;
            for (; last[slot] != nobody && entries[last[slot]].tag != entries[e].tag; ++met) slot = (slot + 1) & mask;
            previous[e] = last[slot];
            last[slot] = e;
        }
        for (const std::uint32_t newest : last) {
            if (newest == nobody || previous[newest] == nobody) continue;
            cell.clear();
            for (std::uint32_t e = newest; e != nobody; e = previous[e])
                if (cell.empty() || cell.back() != entries[e].vertex) cell.push_back(entries[e].vertex);
            if (cell.size() > 1) body(std::span<const std::uint32_t>(cell));
        }
        return met;
    }

private:
    struct Entry {
        std::uint32_t tag, vertex;
    };
    static constexpr std::uint32_t nobody = 0xffffffffu;

    std::uint32_t partition_of(std::uint64_t hash) const {
        return partitions_ == 1 ? 0 : std::uint32_t(hash >> shift_);
    }

    // Tags have no random key, so that collisions of cells are equal in every run. Table positions have one, against
    // hostile files.
    std::uint32_t slot_of(std::uint32_t tag) const { return std::uint32_t(folded_product(tag ^ key_.a, key_.b)); }

    HashKey key_ = hash_key_of_this_run();
    std::uint32_t partitions_ = 1, shift_ = 64;
    std::vector<std::uint32_t> begin_;  // [partitions + 1]
    LargeArray<Entry> entries_;         // entries of one vertex in one cell are adjacent
};

}  // namespace rakelight::geometry
