// SPDX-License-Identifier: Apache-2.0
// Colors that stand for numbers, for pictures of data. 8-bit sRGB codes.
#pragma once
#include <cstdint>

#include <rakelight/vector.h>

namespace rakelight {

struct Code {
    std::uint8_t r = 0, g = 0, b = 0;
    bool operator==(const Code&) const = default;
};

/// Colors by number that differ from their neighbors' (golden ratio steps of the hue); always the same, never black.
Code color_of_number(std::uint32_t number);
/// 0 dark blue over green and yellow to 1 white; clamped, NaN is 0.
Code heat(double value);
/// 0 is code 0, 1 is code 255; clamped, NaN is 0.
std::uint8_t code_of(double value);
/// As a display shows linear light.
Code code_of_light(vec3 linear);

}  // namespace rakelight
