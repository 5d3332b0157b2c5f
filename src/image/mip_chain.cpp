// SPDX-License-Identifier: Apache-2.0
#include "image/mip_chain.h"

#include <algorithm>
#include <array>
#include <span>

#include "image/srgb_encoder.h"
#include "math/color.h"
#include "math/linear.h"

namespace rakelight {
namespace {

constexpr int rows_per_task = 16;

/// Which texels of the larger level one texel of the smaller one covers along one axis, and how much of each.
struct Taps {
    int first = 0, count = 1;
    float weight[3] = {1, 0, 0};
};

/// Even: pairs. Odd, n = 2k + 1 -> k: texel i covers i n / k .. (i + 1) n / k, which are parts (k - i) / n of texel 2i,
/// k / n of 2i + 1 and (i + 1) / n of 2i + 2 (Guthe & Heckbert 2005, section 3).
Taps taps_of(int i, int larger) {
    if (larger == 1) return {};
    if (larger % 2 == 0) return {2 * i, 2, {0.5f, 0.5f, 0}};
    const int k = larger / 2;
    const double n = larger;
    return {2 * i, 3, {float((k - i) / n), float(k / n), float((i + 1) / n)}};
}

using Table = std::array<float, 256>;

/// Code values as what is averaged: linear light for sRGB colors, the code itself for data and alpha.
struct Decoder {
    Table color, plain;

    explicit Decoder(bool srgb) {
        for (std::size_t i = 0; i < 256; ++i) {
            plain[i] = float(i);
            color[i] = srgb ? linear_from_srgb8(std::uint8_t(i)) : float(i);
        }
    }
    vec4 operator()(std::uint32_t rgba) const {
        return {color[rgba & 255], color[rgba >> 8 & 255], color[rgba >> 16 & 255], plain[rgba >> 24]};
    }
};

struct Identity {
    vec4 operator()(const vec4& v) const { return v; }
};

std::uint32_t round_code(float v) { return std::uint32_t(v + 0.5f); }

void encode_row(const vec4* from, int width, bool srgb, std::uint32_t* to) {
    if (srgb) {
        const SrgbEncoder& encode = SrgbEncoder::instance();
        for (int x = 0; x < width; ++x)
            to[x] = encode(from[x].x) | encode(from[x].y) << 8 | encode(from[x].z) << 16 | round_code(from[x].w) << 24;
    } else {
        for (int x = 0; x < width; ++x)
            to[x] = round_code(from[x].x) | round_code(from[x].y) << 8 | round_code(from[x].z) << 16 |
                    round_code(from[x].w) << 24;
    }
}

/// Averages the rows that one row of the smaller level covers.
template <class Texel, class Decode>
void filter_vertically(const Texel* rows, int width, const Taps& taps, const Decode& decode, vec4* out) {
    const Texel* row = rows + std::size_t(taps.first) * std::size_t(width);
    for (int x = 0; x < width; ++x) out[x] = decode(row[x]) * taps.weight[0];
    for (int t = 1; t < taps.count; ++t) {
        row += width;
        for (int x = 0; x < width; ++x) out[x] = out[x] + decode(row[x]) * taps.weight[t];
    }
}

void filter_horizontally(const vec4* row, int larger, int smaller, vec4* out) {
    if (larger == 1) {
        out[0] = row[0];
    } else if (larger % 2 == 0) {
        for (int x = 0; x < smaller; ++x) out[x] = (row[2 * x] + row[2 * x + 1]) * 0.5f;
    } else {
        for (int x = 0; x < smaller; ++x) {
            const Taps taps = taps_of(x, larger);
            out[x] = row[2 * x] * taps.weight[0] + row[2 * x + 1] * taps.weight[1] + row[2 * x + 2] * taps.weight[2];
        }
    }
}

/// The next smaller level as unrounded averages.
template <class Texel, class Decode>
std::vector<vec4> halve(std::span<const Texel> larger, int width, int height, const Decode& decode, Context& context) {
    const int half_width = std::max(1, width / 2), half_height = std::max(1, height / 2);
    std::vector<vec4> smaller(std::size_t(half_width) * std::size_t(half_height));
    context.parallel_for(std::size_t((half_height + rows_per_task - 1) / rows_per_task), [&](std::size_t task) {
        std::vector<vec4> row{std::size_t(width)};
        const int first = int(task) * rows_per_task, last = std::min(half_height, first + rows_per_task);
        for (int y = first; y < last; ++y) {
            filter_vertically(larger.data(), width, taps_of(y, height), decode, row.data());
            filter_horizontally(row.data(), width, half_width,
                                smaller.data() + std::size_t(y) * std::size_t(half_width));
        }
    });
    return smaller;
}

std::vector<std::uint32_t> encode(const std::vector<vec4>& averages, int width, int height, bool srgb,
                                  Context& context) {
    std::vector<std::uint32_t> codes(averages.size());
    context.parallel_for(std::size_t((height + rows_per_task - 1) / rows_per_task), [&](std::size_t task) {
        const int first = int(task) * rows_per_task, last = std::min(height, first + rows_per_task);
        const std::size_t at = std::size_t(first) * std::size_t(width);
        encode_row(averages.data() + at, (last - first) * width, srgb, codes.data() + at);
    });
    return codes;
}

void add_rgba8_levels(MipChain& chain, Context& context) {
    const Decoder decode(chain.is_srgb);
    std::vector<vec4> averages;
    while (chain.levels.back().width > 1 || chain.levels.back().height > 1) {
        const MipLevel& larger = chain.levels.back();
        averages = chain.levels.size() == 1
                       ? halve<std::uint32_t>(larger.rgba8, larger.width, larger.height, decode, context)
                       : halve<vec4>(averages, larger.width, larger.height, Identity(), context);
        MipLevel smaller{std::max(1, larger.width / 2), std::max(1, larger.height / 2), {}, {}};
        smaller.rgba8 = encode(averages, smaller.width, smaller.height, chain.is_srgb, context);
        chain.levels.push_back(std::move(smaller));
    }
}

void add_rgba32f_levels(MipChain& chain, Context& context) {
    while (chain.levels.back().width > 1 || chain.levels.back().height > 1) {
        const MipLevel& larger = chain.levels.back();
        MipLevel smaller{std::max(1, larger.width / 2), std::max(1, larger.height / 2), {}, {}};
        smaller.rgba32f = halve<vec4>(larger.rgba32f, larger.width, larger.height, Identity(), context);
        chain.levels.push_back(std::move(smaller));
    }
}

/// Texels of all levels, or of all but the first.
std::uint64_t texels_of(int width, int height, bool with_first) {
    std::uint64_t count = with_first ? std::uint64_t(width) * std::uint64_t(height) : 0;
    while (width > 1 || height > 1) {
        width = std::max(1, width / 2);
        height = std::max(1, height / 2);
        count += std::uint64_t(width) * std::uint64_t(height);
    }
    return count;
}

std::uint64_t level_bytes(const Pixels& pixels) {
    return texels_of(pixels.width, pixels.height, true) *
           (pixels.component == Component::u8 ? sizeof(std::uint32_t) : sizeof(vec4));
}

/// Unrounded averages live beside the 8-bit levels until all are made.
std::uint64_t averages_bytes(const Pixels& pixels) {
    return pixels.component == Component::u8 ? texels_of(pixels.width, pixels.height, false) * sizeof(vec4) : 0;
}

}  // namespace

vec3 linear_texel(const MipChain& chain, const MipLevel& level, std::size_t i) {
    if (chain.is_float) return level.rgba32f[i].xyz();
    const std::uint32_t code = level.rgba8[i];
    const auto linear = [](std::uint32_t c) { return linear_from_srgb8(std::uint8_t(c)); };
    return {linear(code & 255u), linear(code >> 8 & 255u), linear(code >> 16 & 255u)};
}

std::uint64_t mip_chain_bytes(const Pixels& pixels) { return level_bytes(pixels) + averages_bytes(pixels); }

MipChain make_mip_chain(const Pixels& pixels, ColorSpace space, Context& context) {
    MipChain chain;
    chain.is_float = pixels.component != Component::u8;
    chain.is_srgb = !chain.is_float && space == ColorSpace::srgb && !pixels.is_linear;
    if (pixels.width <= 0 || pixels.height <= 0) return chain;
    MipLevel base{pixels.width, pixels.height, {}, {}};
    chain.charge = MemoryCharge(context.memory(), level_bytes(pixels), "the texture");
    const MemoryCharge averages(context.memory(), averages_bytes(pixels), "the texture while it is made smaller");
    if (chain.is_float) {
        base.rgba32f = to_rgba32f(pixels, space, context);
        chain.levels.push_back(std::move(base));
        add_rgba32f_levels(chain, context);
    } else {
        base.rgba8 = to_rgba8(pixels, context);
        chain.levels.push_back(std::move(base));
        add_rgba8_levels(chain, context);
    }
    return chain;
}

}  // namespace rakelight
