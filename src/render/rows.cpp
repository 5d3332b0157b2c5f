// SPDX-License-Identifier: Apache-2.0
#include "render/rows.h"

#include <cstring>

#include "math/color.h"

namespace rakelight {
namespace {

void linear_row(const vec4* pixels, std::size_t count, int channels, std::byte* out) {
    const std::size_t bytes = std::size_t(channels) * sizeof(float);
    for (std::size_t i = 0; i < count; ++i) std::memcpy(out + i * bytes, &pixels[i], bytes);
}

void opaque_row(const vec4* pixels, std::size_t count, std::uint8_t* out) {
    for (std::size_t i = 0; i < count; ++i, out += 3) {
        out[0] = srgb8_from_linear(pixels[i].x);
        out[1] = srgb8_from_linear(pixels[i].y);
        out[2] = srgb8_from_linear(pixels[i].z);
    }
}

void transparent_row(const vec4* pixels, std::size_t count, std::uint8_t* out) {
    for (std::size_t i = 0; i < count; ++i, out += 4) {
        const vec4& p = pixels[i];
        const float alpha = p.w >= 0 ? (p.w < 1 ? p.w : 1) : 0;  // NaN becomes 0
        const float scale = alpha > 0 ? 1 / alpha : 0;
        out[0] = srgb8_from_linear(p.x * scale);
        out[1] = srgb8_from_linear(p.y * scale);
        out[2] = srgb8_from_linear(p.z * scale);
        out[3] = std::uint8_t(alpha * 255 + 0.5f);
    }
}

}  // namespace

void convert_row(const vec4* pixels, std::size_t count, const PixelFormat& format, std::byte* out) {
    if (format.component == Component::f32)
        linear_row(pixels, count, format.channels, out);
    else if (format.channels == 3)
        opaque_row(pixels, count, reinterpret_cast<std::uint8_t*>(out));
    else
        transparent_row(pixels, count, reinterpret_cast<std::uint8_t*>(out));
}

}  // namespace rakelight
