// SPDX-License-Identifier: Apache-2.0
// Extends charts beyond their borders, so that filtering and mip levels do not read foreign texels.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/base/context.h>

namespace rakelight::bake {

/// [height * width] the nearest covered texel within `padding` [px] of each texel; no_index if there is none. Ties: the
/// first by columns, then rows.
/// @param covered [height * width] nonzero: covered
std::vector<std::uint32_t> nearest_covered(std::span<const std::uint8_t> covered, int width, int height, int padding,
                                           Context& context);

}  // namespace rakelight::bake
