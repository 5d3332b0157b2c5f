// SPDX-License-Identifier: Apache-2.0
#include "image/compare/display_picture.h"

#include <gtest/gtest.h>

#include <limits>

#include "image_support.h"

namespace rakelight {
namespace {

using test::picture_of;

std::vector<int> codes_of(const DisplayPicture& picture, int x) {
    const std::uint32_t code = picture.row(0)[x];
    return {int(code & 255), int(code >> 8 & 255), int(code >> 16 & 255), int(code >> 24)};
}

TEST(DisplayPicture, CodesOf8BitsStayAndGrayIsCopied) {
    Context context({.threads = 1});
    const auto rgb =
        to_display(picture_of<std::uint8_t>(2, 1, 3, [](int x, int, int c) { return 10 * c + x; }), context);
    EXPECT_EQ(codes_of(rgb, 1), (std::vector{1, 11, 21, 255}));
    const auto gray = to_display(picture_of<std::uint8_t>(1, 1, 1, [](int, int, int) { return 77; }), context);
    EXPECT_EQ(codes_of(gray, 0), (std::vector{77, 77, 77, 255}));
}

TEST(DisplayPicture, CodesOf16BitsAreRounded) {
    Context context({.threads = 1});
    const int values[] = {0, 128, 129, 32896, 65535};  // 128.5 is half a step of 257
    const auto p = to_display(picture_of<std::uint16_t>(5, 1, 1, [&](int x, int, int) { return values[x]; }), context);
    const int expected[] = {0, 0, 1, 128, 255};
    for (int x = 0; x < 5; ++x) EXPECT_EQ(codes_of(p, x)[0], expected[x]) << values[x];
}

TEST(DisplayPicture, FloatsAreClampedAndEncoded) {
    Context context({.threads = 1});
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const float values[] = {-1, 0, 0.21586050f, 1, 7, inf, -inf, nan};  // the third is the light of code 128
    const auto p = to_display(picture_of<float>(8, 1, 3, [&](int x, int, int) { return values[x]; }), context);
    const int expected[] = {0, 0, 128, 255, 255, 255, 0, 0};
    for (int x = 0; x < 8; ++x) EXPECT_EQ(codes_of(p, x)[1], expected[x]) << values[x];
}

TEST(DisplayPicture, ColorsWithAlphaLieOverMiddleGray) {
    Context context({.threads = 1});
    const int alpha[] = {0, 255, 128};
    const auto p = to_display(
        picture_of<std::uint8_t>(3, 1, 4, [&](int x, int, int c) { return c == 3 ? alpha[x] : 255 * (c == 0); }),
        context);
    EXPECT_EQ(codes_of(p, 0), (std::vector{128, 128, 128, 255}));
    EXPECT_EQ(codes_of(p, 1), (std::vector{255, 0, 0, 255}));
    // light 0.501961 + 0.498039 * 0.215861 = 0.609468 and 0.107507: codes 205 and 92
    EXPECT_EQ(codes_of(p, 2), (std::vector{205, 92, 92, 255}));
    const auto floats =
        to_display(picture_of<float>(1, 1, 2, [](int, int, int c) { return c == 1 ? 0.0f : 9.0f; }), context);
    EXPECT_EQ(codes_of(floats, 0), (std::vector{128, 128, 128, 255}));
}

TEST(DisplayPicture, MemoryIsChargedAndGivenBack) {
    Context context({.threads = 1, .max_memory = 400});
    {
        const auto small = to_display(picture_of<std::uint8_t>(10, 10, 1, test::noise), context);
        EXPECT_EQ(context.memory().charged(), 400u);
    }
    EXPECT_EQ(context.memory().charged(), 0u);
    EXPECT_THROW(to_display(picture_of<std::uint8_t>(10, 11, 1, test::noise), context), Error);
}

}  // namespace
}  // namespace rakelight
