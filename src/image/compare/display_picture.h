// SPDX-License-Identifier: Apache-2.0
// Pictures as display values, for perceptual metrics.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/image/image.h>

namespace rakelight {

/// 8-bit sRGB codes, R in the low byte, then G and B; the high byte is 255.
struct DisplayPicture {
    int width = 0, height = 0;           ///< [px]
    std::vector<std::uint32_t> codes{};  ///< [height * width]
    MemoryCharge charge{};               ///< memory charge of `codes`

    const std::uint32_t* row(int y) const { return codes.data() + std::size_t(y) * std::size_t(width); }
};

/// Gray is copied to RGB. 16-bit codes are rounded to 8 bits; linear light (floats) is clamped to 0..1 and encoded as
/// sRGB, NaN is black. Transparent colors are composited over middle gray (code 128) in linear light.
/// @throws Error bad_file: too large for the memory budget
DisplayPicture to_display(const Pixels& pixels, Context& context);

/// Whether two pictures of one size are equal in a rectangle, clipped to the picture.
bool equal_within(const DisplayPicture& a, const DisplayPicture& b, int left, int top, int right, int bottom);

}  // namespace rakelight
