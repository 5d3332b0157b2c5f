// SPDX-License-Identifier: Apache-2.0
#include "render/channel_view.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "engines/channel_arrays.h"
#include "image/false_color.h"
#include "math/color.h"
#include "math/linear.h"

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

/// The words of a channel, as view_row() takes them.
std::vector<std::uint32_t> words_of(const Frame& frame, std::uint32_t channel) {
    std::vector<std::uint32_t> words;
    for_each_channel(
        [&](std::uint32_t bit, const auto& values) {
            if (bit != channel || values.empty()) return;
            words.resize(values.size() * sizeof(values[0]) / sizeof words[0]);
            std::memcpy(words.data(), values.data(), words.size() * sizeof words[0]);
        },
        static_cast<const ChannelArrays&>(frame));
    return words;
}

}  // namespace

ChannelRange channel_range_of(const Bounds& bounds, const Camera& camera) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 p = {corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                         corner & 4 ? bounds.high.z : bounds.low.z};
        const double distance = -dot(p - camera.to_world[3].xyz(), camera.to_world[2].xyz());
        low = std::min(low, distance);
        high = std::max(high, distance);
    }
    return {std::max(low, camera.z_near), std::min(high, camera.z_far), bounds.low, bounds.high};
}

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

std::vector<std::uint32_t> channel_codes(const Frame& frame, std::uint32_t channel, const ChannelRange& range) {
    const bool is_one =
        channel != 0 && (channel & (channel - 1)) == 0 && (channel & ~(channels_all | channel_ambient_occlusion)) == 0;
    const std::vector<std::uint32_t> words = is_one ? words_of(frame, channel) : std::vector<std::uint32_t>();
    const std::size_t count = std::size_t(frame.window.width) * std::size_t(frame.window.height);
    if (!is_one || words.size() != count * std::size_t(info_of(channel).components()))
        throw Error(ErrorCode::usage, "the frame has no such channel");
    std::vector<std::uint8_t> rgb(3 * count);
    view_row(info_of(channel), range, words.data(), count, rgb.data());
    std::vector<std::uint32_t> codes(count);
    for (std::size_t i = 0; i < count; ++i)
        codes[i] = 0xff000000u | std::uint32_t(rgb[3 * i]) | std::uint32_t(rgb[3 * i + 1]) << 8 |
                   std::uint32_t(rgb[3 * i + 2]) << 16;
    return codes;
}

std::vector<std::string> channel_words() {
    std::vector<std::string> words;
    for (const ChannelInfo& channel : all_channels()) words.emplace_back(channel.word);
    return words;
}

}  // namespace rakelight
