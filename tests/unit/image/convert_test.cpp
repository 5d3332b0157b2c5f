// SPDX-License-Identifier: Apache-2.0
#include "image/convert.h"

#include <gtest/gtest.h>

#include <limits>

#include "image_support.h"
#include "math/color.h"

namespace rakelight {
namespace {

using test::picture_of;

TEST(ToRgba8, FillsUpGrayAndMissingAlpha) {
    Context context;
    const auto code = [](int, int, int c) { return 10 + c; };
    EXPECT_EQ(to_rgba8(picture_of<std::uint8_t>(1, 1, 1, code), context), (std::vector<std::uint32_t>{0xff0a0a0a}));
    EXPECT_EQ(to_rgba8(picture_of<std::uint8_t>(1, 1, 2, code), context), (std::vector<std::uint32_t>{0x0b0a0a0a}));
    EXPECT_EQ(to_rgba8(picture_of<std::uint8_t>(1, 1, 3, code), context), (std::vector<std::uint32_t>{0xff0c0b0a}));
    EXPECT_EQ(to_rgba8(picture_of<std::uint8_t>(1, 1, 4, code), context), (std::vector<std::uint32_t>{0x0d0c0b0a}));
}

TEST(ToRgba8, KeepsEveryPixelInItsPlace) {
    Context context;
    const auto out = to_rgba8(picture_of<std::uint8_t>(3, 130, 1, [](int x, int y, int) { return x + y; }), context);
    ASSERT_EQ(out.size(), 390u);
    for (int y = 0; y < 130; ++y)
        for (int x = 0; x < 3; ++x) EXPECT_EQ(out[std::size_t(y * 3 + x)] & 255, std::uint32_t(x + y));
}

TEST(ToRgba32f, DecodesColorsButNeverAlpha) {
    Context context;
    const auto deep = picture_of<std::uint16_t>(1, 1, 4, [](int, int, int) { return 0x8080; });
    const vec4 srgb = to_rgba32f(deep, ColorSpace::srgb, context)[0],
               linear = to_rgba32f(deep, ColorSpace::linear, context)[0];
    EXPECT_EQ(srgb.x, linear_from_srgb(float(0x8080) / 65535.0f));
    EXPECT_EQ(srgb.w, float(0x8080) / 65535.0f);
    EXPECT_EQ(linear, (vec4{srgb.w, srgb.w, srgb.w, srgb.w}));
    const auto shallow = picture_of<std::uint8_t>(1, 1, 2, [](int, int, int) { return 0x80; });
    const vec4 color = to_rgba32f(shallow, ColorSpace::srgb, context)[0];
    EXPECT_EQ(color,
              (vec4{linear_from_srgb8(0x80), linear_from_srgb8(0x80), linear_from_srgb8(0x80), 128.0f / 255.0f}));
}

TEST(ToRgba32f, MakesFloatsFiniteAndLeavesThemOtherwiseAlone) {
    Context context;
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float values[] = {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, 3.5f};
    const auto picture = picture_of<float>(1, 1, 4, [&](int, int, int c) { return values[c]; });
    EXPECT_EQ(to_rgba32f(picture, ColorSpace::srgb, context)[0], (vec4{0, 65504, -65504, 3.5f}));
    const auto gray = picture_of<float>(1, 1, 1, [](int, int, int) { return 0.25f; });
    EXPECT_EQ(to_rgba32f(gray, ColorSpace::srgb, context)[0], (vec4{0.25f, 0.25f, 0.25f, 1}));
}

TEST(ToRgba, APictureWithoutPixelsGivesNone) {
    Context context;
    EXPECT_TRUE(to_rgba8(Pixels{0, 0, 3, Component::u8, false, {}}, context).empty());
    EXPECT_TRUE(to_rgba32f(Pixels{0, 5, 3, Component::f32, true, {}}, ColorSpace::linear, context).empty());
}

}  // namespace
}  // namespace rakelight
