// SPDX-License-Identifier: Apache-2.0
#include "render/channel_view.h"

#include <bit>
#include <cmath>

#include "image/false_color.h"
#include "math/color.h"

namespace rakelight {
namespace {

constexpr double farthest_gray = 0.125;  // so that what is far is not taken for nothing

double real(std::uint32_t word) { return double(std::bit_cast<float>(word)); }

Code gray_of_distance(double d, const ChannelRange& range) {
    if (!std::isfinite(d)) return {};
    const double length = range.depth_high - range.depth_low;
    const double t = length > 0 ? (d - range.depth_low) / length : 0;
    const std::uint8_t g = code_of(1 - (t > 0 ? t < 1 ? t : 1 : 0) * (1 - farthest_gray));
    return {g, g, g};
}

Code color_of_direction(const std::uint32_t* w) {
    if (real(w[0]) == 0 && real(w[1]) == 0 && real(w[2]) == 0) return {};
    return {code_of(real(w[0]) * 0.5 + 0.5), code_of(real(w[1]) * 0.5 + 0.5), code_of(real(w[2]) * 0.5 + 0.5)};
}

double across(double v, double low, double high) { return high > low ? (v - low) / (high - low) : 0.5; }

Code color_of_position(const std::uint32_t* w, const ChannelRange& r) {
    const double x = real(w[0]), y = real(w[1]), z = real(w[2]);
    if (x == 0 && y == 0 && z == 0) return {};
    return {code_of(across(x, r.low.x, r.high.x)), code_of(across(y, r.low.y, r.high.y)),
            code_of(across(z, r.low.z, r.high.z))};
}

/// 1 stays 1, so that the far rim of a texture does not look like the near one.
double wrapped(double v) { return v >= 0 && v <= 1 ? v : v - std::floor(v); }

/// By the logarithm to base 2, straight between powers.
Code color_of_count(std::uint32_t n) {
    if (n == 0) return {};
    const int power = std::bit_width(n) - 1;
    return heat((power + double(n) / double(1u << power) - 1) / 4);
}

Code view(const ChannelInfo& channel, const ChannelRange& range, const std::uint32_t* w) {
    switch (channel.kind) {
        case ChannelKind::distance:
            return gray_of_distance(real(w[0]), range);
        case ChannelKind::direction:
            return color_of_direction(w);
        case ChannelKind::number:
            return w[0] == no_index ? Code{} : color_of_number(w[0]);
        case ChannelKind::count:
            return color_of_count(w[0]);
        case ChannelKind::coordinates:
            return {code_of(wrapped(real(w[0]))), code_of(wrapped(real(w[1]))), 0};
        case ChannelKind::position:
            return color_of_position(w, range);
        case ChannelKind::weights:
            return {code_of(real(w[0])), code_of(real(w[1])), code_of(real(w[2]))};
        case ChannelKind::amount: {
            const std::uint8_t gray = srgb8_from_linear(std::bit_cast<float>(w[0]));
            return {gray, gray, gray};
        }
        case ChannelKind::share: {
            const std::uint8_t gray = code_of(real(w[0]));
            return {gray, gray, gray};
        }
        case ChannelKind::color:
            return code_of_light({std::bit_cast<float>(w[0]), std::bit_cast<float>(w[1]), std::bit_cast<float>(w[2])});
    }
    return {};
}

}  // namespace

void view_row(const ChannelInfo& channel, const ChannelRange& range, const std::uint32_t* words, std::size_t count,
              std::uint8_t* rgb) {
    const auto step = std::size_t(channel.components());
    for (std::size_t i = 0; i < count; ++i) {
        const Code c = view(channel, range, words + i * step);
        rgb[3 * i] = c.r;
        rgb[3 * i + 1] = c.g;
        rgb[3 * i + 2] = c.b;
    }
}

}  // namespace rakelight
