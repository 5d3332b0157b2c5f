// SPDX-License-Identifier: Apache-2.0
// Decoded pictures of any channel count and component as RGBA: 8-bit codes or linear floats.
#pragma once
#include <cstdint>
#include <vector>

#include <rakelight/image/image.h>
#include <rakelight/math/vector.h>

namespace rakelight {

/// Color space of integer pictures. Float pictures are always linear.
enum class ColorSpace : std::uint8_t { srgb, linear };

/// The code values of an 8-bit picture, R in the low byte. Gray is copied to RGB, missing alpha is 255.
/// @param pixels Component::u8; the caller has charged 4 bytes per pixel for the result
/// @return [height * width]
std::vector<std::uint32_t> to_rgba8(const Pixels& pixels, Context& context);

/// Linear RGB with straight alpha. Integers become 0..1 and sRGB is decoded, except alpha. Floats are clamped to the
/// largest finite half (65504), so that no filter or shader gets an infinity; NaN becomes 0. Gray is copied to RGB,
/// missing alpha is 1. The caller has charged 16 bytes per pixel for the result.
/// @return [height * width]
std::vector<vec4> to_rgba32f(const Pixels& pixels, ColorSpace space, Context& context);

}  // namespace rakelight
