// SPDX-License-Identifier: Apache-2.0
#include "image/maps/mip_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "image_support.h"
#include "math/color.h"
#include "math/isa.h"
#include "math/linear.h"

namespace rakelight {
namespace {

using test::noise;
using test::picture_of;

/// The box filter by its definition, in double: every source texel weighted by the area that it shares with the target.
std::vector<dvec4> box(const std::vector<dvec4>& from, int width, int height, int w, int h) {
    std::vector<dvec4> to(std::size_t(w) * std::size_t(h));
    const double sx = double(width) / w, sy = double(height) / h;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            for (int j = 0; j < height; ++j)
                for (int i = 0; i < width; ++i) {
                    const double ox = std::min<double>(i + 1, (x + 1) * sx) - std::max<double>(i, x * sx);
                    const double oy = std::min<double>(j + 1, (y + 1) * sy) - std::max<double>(j, y * sy);
                    if (ox <= 0 || oy <= 0) continue;
                    const dvec4& v = from[std::size_t(j * width + i)];
                    dvec4& sum = to[std::size_t(y * w + x)];
                    for (std::size_t c = 0; c < 4; ++c) sum[c] += v[c] * ox * oy / (sx * sy);
                }
    return to;
}

std::uint32_t channel(std::uint32_t rgba, int c) { return rgba >> (8 * c) & 255; }

/// The levels by a plain loop, in the order of operations that keeps the bits: rows first, each product by itself.
std::vector<std::vector<std::uint32_t>> plain_levels(const std::vector<std::uint32_t>& codes, int width, int height,
                                                     bool srgb) {
    struct Taps {
        int first, count;
        float weight[3];
    };
    const auto taps_of = [](int i, int n) -> Taps {
        if (n == 1) return {0, 1, {1, 0, 0}};
        if (n % 2 == 0) return {2 * i, 2, {0.5f, 0.5f, 0}};
        const int k = n / 2;
        return {2 * i, 3, {float((k - i) / double(n)), float(k / double(n)), float((i + 1) / double(n))}};
    };
    std::vector<vec4> from;
    for (const std::uint32_t code : codes) {
        const auto value = [&](int c) {
            return srgb && c < 3 ? linear_from_srgb8(std::uint8_t(channel(code, c))) : float(channel(code, c));
        };
        from.push_back({value(0), value(1), value(2), value(3)});
    }
    std::vector<std::vector<std::uint32_t>> levels{codes};
    while (width > 1 || height > 1) {
        const int w = std::max(1, width / 2), h = std::max(1, height / 2);
        std::vector<vec4> to;
        std::vector<std::uint32_t> level;
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                const Taps rows = taps_of(y, height), columns = taps_of(x, width);
                vec4 at[3];
                for (int i = 0; i < columns.count; ++i) {
                    const auto texel = [&](int t) {
                        return from[std::size_t((rows.first + t) * width + columns.first + i)];
                    };
                    at[i] = texel(0) * rows.weight[0];
                    for (int t = 1; t < rows.count; ++t) at[i] = at[i] + texel(t) * rows.weight[t];
                }
                vec4 mean = at[0];
                if (columns.count == 2) mean = (at[0] + at[1]) * 0.5f;
                if (columns.count == 3)
                    mean = at[0] * columns.weight[0] + at[1] * columns.weight[1] + at[2] * columns.weight[2];
                to.push_back(mean);
                const auto code = [&](std::size_t c) {
                    return srgb && c < 3 ? std::uint32_t(srgb8_from_linear(mean[c])) : std::uint32_t(mean[c] + 0.5f);
                };
                level.push_back(code(0) | code(1) << 8 | code(2) << 16 | code(3) << 24);
            }
        levels.push_back(level);
        from = to, width = w, height = h;
    }
    return levels;
}

TEST(MipChain, EveryInstructionSetGivesTheBitsOfAPlainLoop) {
    Context context({.threads = 1});
    for (const auto& [width, height] : {std::pair(1, 1), {1, 9}, {7, 1}, {33, 21}, {64, 32}, {101, 6}, {130, 67}}) {
        const Pixels picture = picture_of<std::uint8_t>(width, height, 4, noise);
        for (const ColorSpace space : {ColorSpace::srgb, ColorSpace::linear})
            for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
                if (!is_available(isa)) continue;
                ASSERT_EQ(setenv("RAKELIGHT_ISA", name(isa), 1), 0);
                const MipChain chain = make_mip_chain(picture, space, context);
                unsetenv("RAKELIGHT_ISA");
                const auto expected = plain_levels(chain.levels[0].rgba8, width, height, space == ColorSpace::srgb);
                ASSERT_EQ(chain.levels.size(), expected.size());
                for (std::size_t l = 0; l < expected.size(); ++l)
                    EXPECT_EQ(chain.levels[l].rgba8, expected[l]) << name(isa) << ", level " << l << " of " << width;
            }
    }
}

TEST(MipChain, HasEveryLevelDownToOneTexel) {
    Context context;
    const MipChain chain = make_mip_chain(picture_of<std::uint8_t>(37, 5, 3, noise), ColorSpace::srgb, context);
    const std::pair<int, int> sizes[] = {{37, 5}, {18, 2}, {9, 1}, {4, 1}, {2, 1}, {1, 1}};
    ASSERT_EQ(chain.levels.size(), std::size(sizes));
    for (std::size_t i = 0; i < std::size(sizes); ++i) {
        EXPECT_EQ(std::pair(chain.levels[i].width, chain.levels[i].height), sizes[i]);
        EXPECT_EQ(chain.levels[i].rgba8.size(), std::size_t(sizes[i].first * sizes[i].second));
        EXPECT_TRUE(chain.levels[i].rgba32f.empty());
    }
    EXPECT_TRUE(chain.is_srgb);
    EXPECT_FALSE(chain.is_float);
}

TEST(MipChain, OneTexelIsOneLevelAndNoTexelIsNone) {
    Context context;
    EXPECT_EQ(make_mip_chain(picture_of<std::uint8_t>(1, 1, 4, noise), ColorSpace::linear, context).levels.size(), 1u);
    EXPECT_TRUE(make_mip_chain(Pixels{0, 0, 4, Component::u8, false, {}}, ColorSpace::linear, context).levels.empty());
}

TEST(MipChain, BlackAndWhiteInSrgbAverageInLinearLight) {
    Context context;
    const auto board = picture_of<std::uint8_t>(2, 2, 3, [](int x, int y, int) { return (x + y) % 2 * 255; });
    EXPECT_EQ(make_mip_chain(board, ColorSpace::srgb, context).levels[1].rgba8[0], 0xffbcbcbcu);  // 188: half the light
    EXPECT_EQ(make_mip_chain(board, ColorSpace::linear, context).levels[1].rgba8[0], 0xff808080u);
}

TEST(MipChain, AlphaIsAveragedAsItIsEvenForSrgb) {
    Context context;
    const auto picture = picture_of<std::uint8_t>(2, 1, 4, [](int x, int, int c) { return c == 3 ? x * 255 : 200; });
    EXPECT_EQ(make_mip_chain(picture, ColorSpace::srgb, context).levels[1].rgba8[0], 0x80c8c8c8u);
}

TEST(MipChain, AConstantPictureStaysConstantInEveryCodeAndSize) {
    Context context;
    for (int code = 0; code < 256; ++code) {
        const auto picture = picture_of<std::uint8_t>(15, 7, 4, [&](int, int, int) { return code; });
        for (const ColorSpace space : {ColorSpace::srgb, ColorSpace::linear})
            for (const MipLevel& level : make_mip_chain(picture, space, context).levels)
                for (const std::uint32_t texel : level.rgba8) ASSERT_EQ(texel, std::uint32_t(code) * 0x01010101u);
    }
}

class MipChainSizes : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(MipChainSizes, EveryLevelIsTheBoxFilterOfTheWholePictureStepByStep) {
    const auto [width, height] = GetParam();
    Context context;
    const Pixels picture =
        picture_of<std::uint8_t>(width, height, 4, [](int x, int y, int c) { return noise(x, y, c) & 255; });
    for (const bool srgb : {true, false}) {
        const MipChain chain = make_mip_chain(picture, srgb ? ColorSpace::srgb : ColorSpace::linear, context);
        const auto decode = [&](std::uint32_t v, int c) {
            return srgb && c < 3 ? double(linear_from_srgb8(std::uint8_t(v))) : v / 255.0;
        };
        std::vector<dvec4> expected;
        for (const std::uint32_t texel : chain.levels[0].rgba8)
            expected.push_back({decode(channel(texel, 0), 0), decode(channel(texel, 1), 1),
                                decode(channel(texel, 2), 2), decode(channel(texel, 3), 3)});
        for (std::size_t i = 1; i < chain.levels.size(); ++i) {
            const MipLevel& larger = chain.levels[i - 1];
            const MipLevel& level = chain.levels[i];
            expected = box(expected, larger.width, larger.height, level.width, level.height);
            for (std::size_t t = 0; t < expected.size(); ++t)
                for (int c = 0; c < 4; ++c) {
                    const double linear = expected[t][std::size_t(c)];
                    const double code = srgb && c < 3 ? 255 * double(srgb_from_linear(float(linear))) : 255 * linear;
                    ASSERT_NEAR(code, channel(level.rgba8[t], c), 0.501)
                        << "level " << i << " texel " << t << " channel " << c;
                }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, MipChainSizes,
                         testing::Values(std::pair{2, 2}, std::pair{3, 3}, std::pair{16, 8}, std::pair{1, 9},
                                         std::pair{33, 1}, std::pair{31, 18}, std::pair{5, 64}));

TEST(MipChain, ARampKeepsItsPlaceAndItsMeanInOddSizes) {
    Context context;
    const auto ramp = picture_of<float>(101, 1, 1, [](int x, int, int) { return (x + 0.5f) / 101.0f; });
    for (const MipLevel& level : make_mip_chain(ramp, ColorSpace::linear, context).levels) {
        double sum = 0;
        for (int x = 0; x < level.width; ++x) {
            const float value = level.rgba32f[std::size_t(x)].x;
            // Texels are steps, not slopes, so a tenth of a source texel is left; a filter that drops the odd one moves by half.
            EXPECT_NEAR(value, (float(x) + 0.5f) / float(level.width), 0.1f / 101.0f) << level.width;
            sum += double(value);
        }
        EXPECT_NEAR(sum / level.width, 0.5, 1e-6);
    }
}

TEST(MipChain, SixteenBitAndFloatPicturesBecomeLinearFloats) {
    Context context;
    const auto deep = picture_of<std::uint16_t>(2, 1, 3, [](int x, int, int) { return x * 65535; });
    const MipChain chain = make_mip_chain(deep, ColorSpace::srgb, context);
    EXPECT_TRUE(chain.is_float);
    EXPECT_FALSE(chain.is_srgb);
    ASSERT_EQ(chain.levels.size(), 2u);
    EXPECT_TRUE(chain.levels[0].rgba8.empty());
    EXPECT_EQ(chain.levels[1].rgba32f[0], (vec4{0.5f, 0.5f, 0.5f, 1}));
    EXPECT_TRUE(make_mip_chain(picture_of<float>(1, 1, 3, noise), ColorSpace::srgb, context).is_float);
}

TEST(MipChain, TheBitsDoNotDependOnTheNumberOfThreads) {
    const Pixels picture = picture_of<std::uint8_t>(257, 130, 3, noise),
                 deep = picture_of<std::uint16_t>(257, 130, 4, noise);
    Context one({.threads = 1}), many({.threads = 7});
    for (const Pixels* pixels : {&picture, &deep}) {
        const MipChain a = make_mip_chain(*pixels, ColorSpace::srgb, one),
                       b = make_mip_chain(*pixels, ColorSpace::srgb, many);
        ASSERT_EQ(a.levels.size(), b.levels.size());
        for (std::size_t i = 0; i < a.levels.size(); ++i) {
            EXPECT_EQ(a.levels[i].rgba8, b.levels[i].rgba8);
            EXPECT_EQ(a.levels[i].rgba32f, b.levels[i].rgba32f);
        }
    }
}

TEST(MipChain, AsksTheBudgetFirst) {
    Context small({.max_memory = 64 * 64 * 4});
    EXPECT_THROW(make_mip_chain(picture_of<std::uint8_t>(64, 64, 3, noise), ColorSpace::srgb, small), Error);
}

}  // namespace
}  // namespace rakelight
