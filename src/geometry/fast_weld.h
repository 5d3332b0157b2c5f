// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "geometry/fast_state.h"

namespace rakelight::geometry {

/// Finds the vertices that share a place (exactly, -0 equal to +0; with scope `object` only inside one object) and gives each
/// class its common row: the sum of its members' rows in the order of their numbers. One radix partition by hash, then a table
/// for each partition that fits the cache; all members of a class lie in one partition, so no two threads meet in a class.
void weld_rows(FastState& state);

}  // namespace rakelight::geometry
