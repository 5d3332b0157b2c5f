// SPDX-License-Identifier: Apache-2.0
// Encoding of linear light to code values of picture files, clamped to 0..1, after tone mapping (tone_curves.h).
#pragma once
#include <cstdint>
#include <span>

#include <rakelight/math/vector.h>

namespace rakelight {

/// Encodes a row (or any run) of linear colors as 8-bit sRGB. NaN and negative give 0, over 1 gives 255, else correctly
/// rounded. Alpha is not a color: it is only clamped and rounded to 0..255.
/// @param linear    [n] linear RGB, alpha
/// @param channels  3 (alpha dropped) or 4
/// @param out       [n * channels]
void to_srgb8(std::span<const vec4> linear, int channels, std::span<std::uint8_t> out);

}  // namespace rakelight
