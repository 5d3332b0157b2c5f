// SPDX-License-Identifier: Apache-2.0
#include "render/rows.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "image/tone.h"

namespace rakelight {
namespace {

void linear_row(const vec4* pixels, std::size_t count, int channels, const ToneCurve& tone, std::byte* out) {
    const std::size_t bytes = std::size_t(channels) * sizeof(float);
    for (std::size_t i = 0; i < count; ++i) {
        const vec4 p = tone.laid(pixels[i]);
        const vec4 c = channels == 4 ? vec4{p.x * p.w, p.y * p.w, p.z * p.w, p.w} : p;
        std::memcpy(out + i * bytes, &c, bytes);
    }
}

/// Tone-mapped piece by piece.
void mapped_row(const vec4* pixels, std::size_t count, int channels, const ToneCurve& tone, std::uint8_t* out) {
    std::array<vec4, 64> piece;
    for (std::size_t i = 0; i < count; i += piece.size()) {
        const std::size_t n = std::min(piece.size(), count - i);
        const std::span<vec4> mapped(piece.data(), n);
        tone.apply({pixels + i, n}, mapped);
        to_srgb8(mapped, channels, {out + i * std::size_t(channels), n * std::size_t(channels)});
    }
}

}  // namespace

void convert_row(const vec4* pixels, std::size_t count, const PixelFormat& format, const ToneCurve& tone,
                 std::byte* out) {
    std::uint8_t* const codes = reinterpret_cast<std::uint8_t*>(out);
    if (format.component == Component::f32)
        linear_row(pixels, count, format.channels, tone, out);
    else if (tone.is_identity())
        to_srgb8({pixels, count}, format.channels, {codes, count * format.bytes()});
    else
        mapped_row(pixels, count, format.channels, tone, codes);
}

void pack_row(const std::uint32_t* srgb8, std::size_t count, int channels, std::byte* out) {
    static_assert(std::endian::native == std::endian::little);
    if (channels == 4) {
        std::memcpy(out, srgb8, 4 * count);
        return;
    }
    using Pairs [[gnu::vector_size(16)]] = std::uint64_t;
    std::size_t i = 0;
    for (; i + 4 < count; i += 4) {  // what is written too far the next pixels cover
        Pairs pixels;
        std::memcpy(&pixels, srgb8 + i, 16);
        pixels = (pixels & 0xffffffu) | (pixels >> 8 & 0xffffff000000u);
        const std::uint64_t first = pixels[0], second = pixels[1];
        std::memcpy(out + 3 * i, &first, 8);
        std::memcpy(out + 3 * i + 6, &second, 8);
    }
    for (; i < count; ++i) std::memcpy(out + 3 * i, srgb8 + i, 3);
}

}  // namespace rakelight
