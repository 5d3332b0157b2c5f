// SPDX-License-Identifier: Apache-2.0
// Data channels as 8-bit RGB pictures to look at.
#pragma once
#include <cstddef>
#include <cstdint>

#include <rakelight/render/channel_view.h>

#include "world/keys/channel_info.h"

namespace rakelight {

/// One row. Directions: v * 0.5 + 0.5. Depth: gray, 1 at the range's near end to 1/8 at its far end. Position: 0..1
/// across the range's box. Coordinates: u red, v green, wrapped to 0..1. Weights: red, green, blue. Numbers: a color
/// each. Overdraw: 1 dark blue, 2 blue-green, 4 green-yellow, 8 orange, 16 and more white. Colors: sRGB, clamped. Black
/// where nothing is.
/// @param words  [count * components] of four bytes, as PictureSink keeps them
/// @param rgb    [count * 3] out
void view_row(const ChannelInfo& channel, const ChannelRange& range, const std::uint32_t* words, std::size_t count,
              std::uint8_t* rgb);

}  // namespace rakelight
