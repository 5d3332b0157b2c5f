// SPDX-License-Identifier: Apache-2.0
// Decoded pictures of any channel count and component as RGBA: 8-bit codes or linear floats.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/image.h>
#include <rakelight/vector.h>

namespace rakelight {

/// What the numbers of an integer picture mean. Float pictures are always linear.
enum class ColorSpace : std::uint8_t { srgb, linear };

/// The code values of an 8-bit picture, R in the low byte. Gray is copied to RGB, missing alpha is 255.
/// @param pixels  Component::u8; the caller has charged 4 bytes a pixel for the result
/// @return [height * width]
std::vector<std::uint32_t> to_rgba8(const Pixels& pixels, Context& context);

/// Linear RGB with straight alpha. Integers become 0..1, sRGB ones are decoded (alpha never is). Floats keep their
/// values, but NaN becomes 0 and magnitudes beyond the largest finite half (65504, what EXR infinities overflowed from)
/// are brought back to it, so that no filter or shader meets an infinity. Gray is copied to RGB, missing alpha is 1.
/// The caller has charged 16 bytes a pixel for the result.
/// @return [height * width]
std::vector<vec4> to_rgba32f(const Pixels& pixels, ColorSpace space, Context& context);

}  // namespace rakelight
