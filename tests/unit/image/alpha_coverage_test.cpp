// SPDX-License-Identifier: Apache-2.0
#include "image/maps/alpha_coverage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "image_support.h"

namespace rakelight {
namespace {

using test::noise;
using test::picture_of;

/// Discs about the points of a jittered grid, one in `cell` texels a side; they reach over the edges. @param share  of the area
Pixels leaves(int width, int height, int cell, double share, double softness = 0) {
    const double radius = cell * std::sqrt(share / 3.14159265358979);
    return picture_of<std::uint8_t>(width, height, 4, [=](int x, int y, int c) {
        if (c < 3) return 200u;
        double nearest = 1e9;
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                const int cx = ((x / cell + i) * cell + width) % width / cell;
                const int cy = ((y / cell + j) * cell + height) % height / cell;
                const double px = (x / cell + i + 0.25 + 0.5 * double(noise(cx, cy, 0) % 256) / 256) * cell;
                const double py = (y / cell + j + 0.25 + 0.5 * double(noise(cx, cy, 1) % 256) / 256) * cell;
                nearest = std::min(nearest, std::hypot(x + 0.5 - px, y + 0.5 - py) - radius);
            }
        if (softness == 0) return nearest < 0 ? 255u : 0u;
        return unsigned(255 * std::clamp(0.5 - nearest / softness, 0.0, 1.0));
    });
}

/// What is seen of a level by the definition: bilinear, at 8 x 8 points a texel, in double.
double seen(const MipChain& chain, const MipLevel& level, double cutoff, int channel = 3, bool repeats = true) {
    const int w = level.width, h = level.height, points = 8;
    const auto place = [repeats](int i, int n) { return repeats ? (i + n) % n : std::clamp(i, 0, n - 1); };
    const auto texel = [&](int x, int y) {
        const std::size_t i = std::size_t(place(y, h)) * std::size_t(w) + std::size_t(place(x, w));
        if (chain.is_float) return double(level.rgba32f[i][std::size_t(channel)]);
        return double(level.rgba8[i] >> 8 * channel & 255u) / 255;
    };
    std::uint64_t count = 0;
    for (int j = 0; j < h * points; ++j)
        for (int i = 0; i < w * points; ++i) {
            const double x = (i + 0.5) / points - 0.5, y = (j + 0.5) / points - 0.5;
            const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
            const double tx = x - x0, ty = y - y0;
            const double a = texel(x0, y0) * (1 - tx) + texel(x0 + 1, y0) * tx;
            const double b = texel(x0, y0 + 1) * (1 - tx) + texel(x0 + 1, y0 + 1) * tx;
            count += a * (1 - ty) + b * ty >= cutoff - 1e-6;
        }
    return double(count) / (double(w) * h * points * points);
}

TEST(AlphaCoverage, IsThatOfEveryPointBetweenTexels) {
    Context context({.threads = 1});
    const MipChain chain = make_mip_chain(leaves(48, 24, 8, 0.3, 3), ColorSpace::srgb, context);
    for (const float cutoff : {0.1f, 0.5f, 0.8f})
        for (const bool repeats : {true, false})
            EXPECT_NEAR(alpha_coverage(chain, chain.levels[1], {cutoff}, 1, repeats, repeats, context),
                        seen(chain, chain.levels[1], cutoff, 3, repeats), 0.01);
}

TEST(AlphaCoverage, StaysAtEveryLevelForEveryCutoffAndShape) {
    Context context({.threads = 2});
    for (const auto& [width, height] : {std::pair(128, 128), {256, 32}, {32, 128}, {125, 66}, {97, 101}})
        for (const double share : {0.1, 0.3, 0.7})
            for (const float cutoff : {0.1f, 0.5f, 0.9f}) {
                MipChain chain = make_mip_chain(leaves(width, height, 16, share, 2), ColorSpace::srgb, context);
                const double wanted = seen(chain, chain.levels[0], cutoff);
                keep_coverage(chain, {cutoff}, true, true, context);
                EXPECT_GE(chain.levels.size(), 4u) << "until a texel is half as large as a leaf's cell";
                for (const MipLevel& level : chain.levels)
                    EXPECT_NEAR(seen(chain, level, cutoff), wanted,
                                (level.width * level.height > 64 ? 0.06 : 0.3) * std::min(wanted, 1 - wanted) + 0.002)
                        << width << " x " << height << ", " << share << " at " << cutoff << ", level of "
                        << level.width;
            }
}

TEST(AlphaCoverage, ColorsAndTheFirstLevelAreLeftAlone) {
    Context context({.threads = 1});
    const Pixels picture = leaves(64, 64, 8, 0.2);
    const MipChain plain = make_mip_chain(picture, ColorSpace::srgb, context);
    MipChain chain = make_mip_chain(picture, ColorSpace::srgb, context);
    keep_coverage(chain, {0.5f}, true, true, context);
    EXPECT_EQ(chain.levels[0].rgba8, plain.levels[0].rgba8);
    for (std::size_t l = 1; l < chain.levels.size(); ++l)
        for (std::size_t i = 0; i < chain.levels[l].rgba8.size(); ++i)
            EXPECT_EQ(chain.levels[l].rgba8[i] & 0xffffffu, plain.levels[l].rgba8[i] & 0xffffffu);
    EXPECT_NE(chain.levels[3].rgba8, plain.levels[3].rgba8);
}

TEST(AlphaCoverage, OfAnotherChannelAndOfFloats) {
    Context context({.threads = 1});
    const MipChain of_alpha = make_mip_chain(leaves(64, 64, 8, 0.2), ColorSpace::linear, context);
    const Pixels gray = picture_of<float>(64, 64, 1, [&](int x, int y, int) {
        return float(of_alpha.levels[0].rgba8[std::size_t(y * 64 + x)] >> 24) / 255;
    });
    MipChain chain = make_mip_chain(gray, ColorSpace::linear, context);
    ASSERT_TRUE(chain.is_float);
    const double wanted = seen(chain, chain.levels[0], 0.4, 0);
    keep_coverage(chain, {0.4f, 0}, false, false, context);
    ASSERT_GE(chain.levels.size(), 5u);
    for (std::size_t l = 0; l < 4; ++l) {
        EXPECT_NEAR(seen(chain, chain.levels[l], 0.4, 0, false), wanted, 0.01) << l;
        for (const vec4& texel : chain.levels[l].rgba32f) EXPECT_TRUE(texel.x <= 1 && texel.w == 1);
    }
}

TEST(AlphaCoverage, OfTexelsThatAreNotInterpolated) {
    Context context({.threads = 1});
    MipChain chain = make_mip_chain(leaves(256, 256, 16, 0.3, 4), ColorSpace::srgb, context);
    const auto share = [](const MipLevel& level) {
        std::size_t count = 0;
        for (const std::uint32_t texel : level.rgba8) count += (texel >> 24) >= 128;
        return double(count) / double(level.rgba8.size());
    };
    const double wanted = share(chain.levels[0]);
    keep_coverage(chain, {0.5f, 3, false}, true, true, context);
    ASSERT_GE(chain.levels.size(), 4u);
    for (std::size_t l = 0; l < 4; ++l) EXPECT_NEAR(share(chain.levels[l]), wanted, 0.02) << l;
}

TEST(AlphaCoverage, WhatIsSeenWhollyOrNotAtAllStaysAnAverage) {
    Context context({.threads = 1});
    const auto chain_of = [&](auto alpha, AlphaTest test) {
        const auto value = [alpha](int x, int y, int c) { return c == 3 ? alpha(x, y) : 90u; };
        MipChain chain = make_mip_chain(picture_of<std::uint8_t>(16, 16, 4, value), ColorSpace::srgb, context);
        keep_coverage(chain, test, true, true, context);
        return chain;
    };
    EXPECT_EQ(chain_of([](int, int) { return 255u; }, {0.5f}).levels.back().rgba8[0] >> 24, 255u);
    EXPECT_EQ(chain_of([](int, int) { return 100u; }, {0.5f}).levels.back().rgba8[0] >> 24, 100u);
    EXPECT_EQ(chain_of([](int x, int) { return x % 2 * 200u; }, {0.9f}).levels.back().rgba8[0] >> 24, 100u);
    EXPECT_EQ(chain_of([](int x, int) { return x % 2 * 200u; }, {-1}).levels.back().rgba8[0] >> 24, 100u);
    EXPECT_EQ(chain_of([](int x, int) { return x % 2 * 200u; }, {0}).levels.back().rgba8[0] >> 24, 100u);
    EXPECT_EQ(chain_of([](int, int) { return 128u; }, {128.0f / 255}).levels.size(), 5u) << "its own code is seen";
}

TEST(AlphaCoverage, IsTheSameForAnyNumberOfThreads) {
    Context one({.threads = 1}), many({.threads = 7});
    MipChain a = make_mip_chain(leaves(300, 170, 12, 0.25, 3), ColorSpace::srgb, one);
    MipChain b = make_mip_chain(leaves(300, 170, 12, 0.25, 3), ColorSpace::srgb, many);
    keep_coverage(a, {0.3f}, true, false, one);
    keep_coverage(b, {0.3f}, true, false, many);
    ASSERT_EQ(a.levels.size(), b.levels.size());
    for (std::size_t l = 0; l < a.levels.size(); ++l) EXPECT_EQ(a.levels[l].rgba8, b.levels[l].rgba8);
}

TEST(AlphaCoverage, PicturesWithoutTexelsAndOfOneTexel) {
    Context context({.threads = 1});
    MipChain none;
    keep_coverage(none, {0.5f}, true, true, context);
    EXPECT_TRUE(none.levels.empty());
    MipChain one = make_mip_chain(picture_of<std::uint8_t>(1, 1, 4, noise), ColorSpace::srgb, context);
    keep_coverage(one, {0.5f}, true, true, context);
    EXPECT_EQ(one.levels.size(), 1u);
}

}  // namespace
}  // namespace rakelight
