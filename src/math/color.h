// SPDX-License-Identifier: Apache-2.0
// Color spaces: the sRGB transfer function (IEC 61966-2-1) in both directions. All other code uses linear RGB.
#pragma once
#include <cstdint>

#include <rakelight/math/vector.h>

namespace rakelight {

float linear_from_srgb(float s);          ///< s in 0..1, clamped
float srgb_from_linear(float l);          ///< l in 0..1, clamped; NaN gives 0
float linear_from_srgb8(std::uint8_t s);  ///< by table
std::uint8_t srgb8_from_linear(float l);  ///< correctly rounded; NaN and negative give 0, over 1 gives 255
vec3 linear_from_srgb(vec3 s);

}  // namespace rakelight
