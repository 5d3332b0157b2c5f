// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "geometry/fast_state.h"

namespace rakelight::geometry {

std::uint32_t weld_partition_bits(std::uint32_t vertices);

/// Writes the hashes of positions first .. last - 1 of a mesh (in the world, -0 as +0; with scope `object` also of the object)
/// and counts them by their partitions in the lane.
void hash_places(const FastState& state, LaneScratch& lane, std::uint32_t mesh, std::uint32_t first,
                 std::uint32_t last);

/// Finds the vertices that share a place (exactly, -0 equal to +0; with scope `object` only inside one object) and gives each
/// class its common row: the sum of its members' rows in the order of their numbers. All places must have been hashed. One
/// radix partition by hash, then a table for each partition that fits the cache; all members of a class lie in one partition,
/// so no two threads meet in a class.
void weld_rows(FastState& state);

}  // namespace rakelight::geometry
