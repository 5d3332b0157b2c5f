// SPDX-License-Identifier: Apache-2.0
// Welding: vertices at exactly the same position in world space.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/input/attribute_input.h"
#include "geometry/input/block_array.h"

namespace rakelight::geometry {

/// What besides the position must be equal for two vertices to be one.
struct WeldKey {
    bool object = false;  ///< the object number (scope `object`)
    bool normal = false;  ///< the given normal, in the world, as float (where given normals are kept)
};

/// representative[v] = the smallest vertex at v's place; v itself where nothing else is there or its position is not
/// finite. World positions are compared in double, -0 equal to +0. Expected O(n); the same for any number of threads.
/// @param scratch  source of memory; null: allocate
/// @param met not null: number of visited full slots, which measures how evenly the tables fill
std::vector<std::uint32_t> weld_positions(const AttributeInput& input, WeldKey key, Context& context,
                                          std::uint64_t* met = nullptr, GeneralScratch* scratch = nullptr);

}  // namespace rakelight::geometry
