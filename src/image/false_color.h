// SPDX-License-Identifier: Apache-2.0
// False colors for pictures of data. 8-bit sRGB codes.
#pragma once
#include <cstdint>

#include <rakelight/math/vector.h>

namespace rakelight {

struct Code {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Code&) const = default;
};

/// Distinct colors for indices (golden ratio steps of the hue); deterministic, never black.
Code color_of_number(std::uint32_t number);
/// 0 dark blue over green and yellow to 1 white; clamped, NaN is 0.
Code heat(double value);
/// 0 is code 0, 1 is code 255; clamped, NaN is 0.
std::uint8_t code_of(double value);
/// The display value of linear light.
Code code_of_light(vec3 linear);

}  // namespace rakelight
