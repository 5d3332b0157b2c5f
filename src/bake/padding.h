// SPDX-License-Identifier: Apache-2.0
// Charts continued beyond their borders, so that filters and smaller versions of a map read nothing foreign.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/context.h>

namespace rakelight::bake {

/// [height * width] for each texel the nearest one that is covered, at most `padding` [px] away: itself where it is; no_index where
/// none is. Of equally near ones the first by columns, then rows.
/// @param covered  [height * width] not 0
std::vector<std::uint32_t> nearest_covered(std::span<const std::uint8_t> covered, int width, int height, int padding,
                                           Context& context);

}  // namespace rakelight::bake
