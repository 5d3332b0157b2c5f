// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "geometry/fast_state.h"

namespace rakelight::geometry {

/// From the sums to unit normals and tangents in the caller's buffers.
/// @return the vertices left to the general path, ascending, numbered through; what was written for them is worthless
std::vector<std::uint32_t> finish_rows(FastState& state);

}  // namespace rakelight::geometry
