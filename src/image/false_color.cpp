// SPDX-License-Identifier: Apache-2.0
#include "image/false_color.h"

#include <algorithm>
#include <cmath>

#include "math/color.h"

namespace rakelight {

std::uint8_t code_of(double v) { return std::uint8_t(v > 0 ? (v < 1 ? v * 255 + 0.5 : 255) : 0); }

Code code_of_light(vec3 linear) {
    return {srgb8_from_linear(linear.x), srgb8_from_linear(linear.y), srgb8_from_linear(linear.z)};
}

Code color_of_number(std::uint32_t number) {
    const double hue = double(number * 2654435769u) / 4294967296.0 * 6;  // 2^32 / golden ratio
    const double value = 0.65 + 0.35 * double((number * 40503u >> 4) % 8) / 7;
    const auto part = [&](double at) {
        const double d = std::fabs(hue - at), distance = std::min(d, 6 - d);
        return value * (0.25 + 0.75 * std::clamp(2 - distance, 0.0, 1.0));
    };
    return {code_of(part(0)), code_of(part(2)), code_of(part(4))};
}

Code heat(double v) {
    static constexpr double stops[][3] = {{0.08, 0.08, 0.25}, {0.1, 0.4, 0.6},  {0.2, 0.7, 0.35},
                                          {0.95, 0.8, 0.2},   {0.9, 0.3, 0.15}, {1, 1, 1}};
    const double at = v > 0 ? std::min(v, 1.0) * 5 : 0;
    const auto i = std::size_t(std::min(at, 4.0));
    const double t = at - double(i);
    const auto mix = [&](int c) { return code_of(stops[i][c] * (1 - t) + stops[i + 1][c] * t); };
    return {mix(0), mix(1), mix(2)};
}

}  // namespace rakelight
