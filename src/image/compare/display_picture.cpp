// SPDX-License-Identifier: Apache-2.0
#include "image/compare/display_picture.h"

#include <algorithm>
#include <cstring>

#include "base/assert.h"
#include "image/srgb_encoder.h"
#include "math/color.h"

namespace rakelight {
namespace {

constexpr std::uint8_t backdrop = 128;

/// A component as 8-bit code; `is_light`: floats are linear light and get sRGB's curve, alpha does not.
std::uint32_t code_at(const std::byte* pixel, int c, Component component, bool is_light) {
    switch (component) {
        case Component::u8:
            return std::uint32_t(pixel[c]);
        case Component::u16: {
            std::uint16_t v = 0;
            std::memcpy(&v, pixel + 2 * c, sizeof v);
            return (std::uint32_t(v) * 255 + 32767) / 65535;
        }
        case Component::f32:
            break;
    }
    float v = 0;
    std::memcpy(&v, pixel + 4 * c, sizeof v);
    if (is_light) return SrgbEncoder::instance()(v);
    return v > 0 ? std::uint32_t(std::min(v, 1.0f) * 255.0f + 0.5f) : 0;  // NaN too
}

/// A color over the backdrop, in linear light.
std::uint32_t over_backdrop(std::uint32_t code, std::uint32_t alpha) {
    const float cover = float(alpha) / 255.0f;
    const float light = linear_from_srgb8(std::uint8_t(code)) * cover + linear_from_srgb8(backdrop) * (1 - cover);
    return SrgbEncoder::instance()(light);
}

void convert_row(const Pixels& pixels, int y, std::uint32_t* to) {
    const bool is_gray = pixels.channels < 3, has_alpha = pixels.channels == 2 || pixels.channels == 4;
    const std::size_t stride = std::size_t(pixels.channels) * size_of(pixels.component);
    const std::byte* from = pixels.row(y);
    for (int x = 0; x < pixels.width; ++x, from += stride) {
        std::uint32_t rgb[3];
        for (int c = 0; c < 3; ++c) rgb[c] = code_at(from, is_gray ? 0 : c, pixels.component, true);
        const std::uint32_t alpha = has_alpha ? code_at(from, pixels.channels - 1, pixels.component, false) : 255;
        if (alpha < 255)
            for (std::uint32_t& code : rgb) code = over_backdrop(code, alpha);
        to[x] = rgb[0] | rgb[1] << 8 | rgb[2] << 16 | 0xff000000u;
    }
}

}  // namespace

DisplayPicture to_display(const Pixels& pixels, Context& context) {
    RL_ASSERT(pixels.channels >= 1 && pixels.channels <= 4 && pixels.width >= 0 && pixels.height >= 0 &&
                  pixels.bytes.size() == pixels.row_bytes() * std::size_t(pixels.height),
              "the picture's bytes do not fit its size");
    const std::size_t count = std::size_t(pixels.width) * std::size_t(pixels.height);
    DisplayPicture out{.width = pixels.width, .height = pixels.height};
    out.charge = MemoryCharge(context.memory(), count * sizeof(std::uint32_t), "the picture as displayed");
    out.codes.resize(count);
    context.parallel_for(std::size_t(pixels.height), [&](std::size_t y) {
        convert_row(pixels, int(y), out.codes.data() + y * std::size_t(pixels.width));
    });
    return out;
}

bool equal_within(const DisplayPicture& a, const DisplayPicture& b, int left, int top, int right, int bottom) {
    left = std::max(left, 0), right = std::min(right, a.width);
    for (int y = std::max(top, 0); y < std::min(bottom, a.height); ++y)
        if (!std::equal(a.row(y) + left, a.row(y) + right, b.row(y) + left)) return false;
    return true;
}

}  // namespace rakelight
