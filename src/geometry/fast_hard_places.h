// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "geometry/fast_state.h"

namespace rakelight::geometry {

/// Gives some places to the general path: a model of all faces that touch them, whose results for these vertices replace what
/// the fast path wrote. All that the general path decides at a place depends on the faces there alone.
/// @param vertices  ascending, numbered through; with a vertex all others at its place
/// @param splits    [meshes] gets the vertices that had to be split
void redo_places(FastState& state, std::span<const std::uint32_t> vertices, std::span<const AttributeBuffers> out,
                 std::vector<SplitAttributes>& splits);

}  // namespace rakelight::geometry
