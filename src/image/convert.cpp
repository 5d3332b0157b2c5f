// SPDX-License-Identifier: Apache-2.0
#include "image/convert.h"

#include <algorithm>
#include <cstring>

#include "base/assert.h"
#include "math/color.h"

namespace rakelight {
namespace {

constexpr int rows_per_task = 64;

/// Calls row(y) for all rows, in parallel.
template <class Row>
void for_rows(int height, Context& context, const Row& row) {
    context.parallel_for(std::size_t((height + rows_per_task - 1) / rows_per_task), [&](std::size_t task) {
        const int first = int(task) * rows_per_task, last = std::min(height, first + rows_per_task);
        for (int y = first; y < last; ++y) row(y);
    });
}

void expand_rgba8(const std::byte* from, int channels, int width, std::uint32_t* to) {
    const auto value = [&](int i) { return std::uint32_t(from[i]); };
    constexpr std::uint32_t opaque = 0xff000000;
    switch (channels) {
        case 1:
            for (int x = 0; x < width; ++x, from += 1) to[x] = value(0) * 0x010101u | opaque;
            break;
        case 2:
            for (int x = 0; x < width; ++x, from += 2) to[x] = value(0) * 0x010101u | value(1) << 24;
            break;
        case 3:
            for (int x = 0; x < width; ++x, from += 3) to[x] = value(0) | value(1) << 8 | value(2) << 16 | opaque;
            break;
        default:
            for (int x = 0; x < width; ++x, from += 4)
                to[x] = value(0) | value(1) << 8 | value(2) << 16 | value(3) << 24;
    }
}

/// Linear light of 16-bit sRGB codes; computed at the first use.
const std::vector<float>& linear_of_code16() {
    static const std::vector<float> table = [] {
        std::vector<float> values(65536);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = linear_from_srgb(float(i) / 65535.0f);
        return values;
    }();
    return table;
}

float finite(float v) {
    constexpr float largest_half = 65504.0f;
    if (v != v) return 0.0f;
    return std::clamp(v, -largest_half, largest_half);
}

/// Reads component i of a row as a number: colors through `color`, alpha through `plain`.
template <class T, class Color, class Plain>
void expand_rgba32f(const std::byte* from, int channels, int width, vec4* to, const Color& color, const Plain& plain) {
    const bool gray = channels < 3, has_alpha = channels == 2 || channels == 4;
    for (int x = 0; x < width; ++x, from += std::size_t(channels) * sizeof(T)) {
        T value[4];
        std::memcpy(value, from, std::size_t(channels) * sizeof(T));
        const float r = color(value[0]);
        to[x] = {r, gray ? r : color(value[1]), gray ? r : color(value[2]),
                 has_alpha ? plain(value[channels - 1]) : 1.0f};
    }
}

void require_whole(const Pixels& pixels) {
    RL_ASSERT(pixels.channels >= 1 && pixels.channels <= 4 && pixels.width >= 0 && pixels.height >= 0 &&
                  pixels.bytes.size() == pixels.row_bytes() * std::size_t(pixels.height),
              "the picture's bytes do not fit its size");
}

}  // namespace

std::vector<std::uint32_t> to_rgba8(const Pixels& pixels, Context& context) {
    require_whole(pixels);
    RL_ASSERT(pixels.component == Component::u8, "only 8-bit pictures have 8-bit codes");
    const std::size_t count = std::size_t(pixels.width) * std::size_t(pixels.height);
    std::vector<std::uint32_t> out(count);
    for_rows(pixels.height, context, [&](int y) {
        expand_rgba8(pixels.row(y), pixels.channels, pixels.width,
                     out.data() + std::size_t(y) * std::size_t(pixels.width));
    });
    return out;
}

std::vector<vec4> to_rgba32f(const Pixels& pixels, ColorSpace space, Context& context) {
    require_whole(pixels);
    const std::size_t count = std::size_t(pixels.width) * std::size_t(pixels.height);
    std::vector<vec4> out(count);
    const bool srgb = space == ColorSpace::srgb && !pixels.is_linear;
    const float* const code16 = srgb && pixels.component == Component::u16 ? linear_of_code16().data() : nullptr;
    const auto unit8 = [](std::uint8_t v) { return float(v) / 255.0f; };
    const auto unit16 = [](std::uint16_t v) { return float(v) / 65535.0f; };
    const auto color8 = [&](std::uint8_t v) { return srgb ? linear_from_srgb8(v) : unit8(v); };
    const auto color16 = [&](std::uint16_t v) { return code16 != nullptr ? code16[v] : unit16(v); };
    for_rows(pixels.height, context, [&](int y) {
        vec4* const to = out.data() + std::size_t(y) * std::size_t(pixels.width);
        switch (pixels.component) {
            case Component::u8:
                expand_rgba32f<std::uint8_t>(pixels.row(y), pixels.channels, pixels.width, to, color8, unit8);
                break;
            case Component::u16:
                expand_rgba32f<std::uint16_t>(pixels.row(y), pixels.channels, pixels.width, to, color16, unit16);
                break;
            case Component::f32:
                expand_rgba32f<float>(pixels.row(y), pixels.channels, pixels.width, to, finite, finite);
                break;
        }
    });
    return out;
}

}  // namespace rakelight
