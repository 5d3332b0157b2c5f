// SPDX-License-Identifier: Apache-2.0
#include "image/compare/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image_support.h"

namespace rakelight {
namespace {

using test::noise;
using test::picture_of;

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(ComparePictures, EqualOnesDifferInNothing) {
    const Pixels a = picture_of<std::uint8_t>(9, 4, 3, noise);
    const PictureDifference d = compare_pictures(a, a);
    EXPECT_EQ(d.max_absolute, 0);
    EXPECT_EQ(d.rmse, 0);
    EXPECT_EQ(d.psnr_db, infinity);
    EXPECT_EQ(d.differing, 0u);
    EXPECT_EQ(d.differing_share, 0);
}

TEST(ComparePictures, OneComponentOfTwentyOffByOneTenthIsCounted) {
    const Pixels a = picture_of<float>(5, 4, 1, [](int, int, int) { return 0.0f; });
    const Pixels b = picture_of<float>(5, 4, 1, [](int x, int y, int) { return x == 2 && y == 1 ? 0.5f : 0.0f; });
    const PictureDifference d = compare_pictures(a, b);
    EXPECT_EQ(d.max_absolute, 0.5);
    EXPECT_NEAR(d.rmse, std::sqrt(0.25 / 20), 1e-15);
    EXPECT_NEAR(d.psnr_db, 19.03089986991944, 1e-12);  // 10 log10(80)
    EXPECT_EQ(d.differing, 1u);
    EXPECT_EQ(d.differing_share, 0.05);
    EXPECT_EQ(compare_pictures(a, b, 0.5).differing, 0u);
}

TEST(ComparePictures, DifferencesOfCodesAreExactSteps) {
    for (int code = 0; code + 2 < 256; ++code) {
        const Pixels a = picture_of<std::uint8_t>(1, 1, 1, [&](int, int, int) { return code; });
        const Pixels b = picture_of<std::uint8_t>(1, 1, 1, [&](int, int, int) { return code + 2; });
        const PictureDifference d = compare_pictures(a, b, 2 / 255.0);
        EXPECT_EQ(d.max_absolute, 2 / 255.0) << code;
        EXPECT_EQ(d.differing, 0u) << code;
    }
    const Pixels a = picture_of<std::uint16_t>(1, 1, 1, [&](int, int, int) { return 50001; });
    const Pixels b = picture_of<std::uint16_t>(1, 1, 1, [&](int, int, int) { return 50008; });
    EXPECT_EQ(compare_pictures(a, b).max_absolute, 7 / 65535.0);
}

TEST(ComparePictures, APixelCountsOnce) {
    const Pixels a = picture_of<std::uint8_t>(4, 2, 3, [](int, int, int) { return 9; });
    const Pixels b = picture_of<std::uint8_t>(4, 2, 3, [](int x, int y, int c) { return x == 1 && c <= y ? 8 : 9; });
    EXPECT_EQ(compare_pictures(a, b).differing, 3u);
    EXPECT_EQ(compare_pictures(a, b).differing_pixels, 2u);
}

TEST(ComparePictures, KindsOfComponentsMayDiffer) {
    const Pixels a = picture_of<std::uint8_t>(3, 3, 4, [](int x, int, int) { return x * 51; });
    const Pixels b = picture_of<std::uint16_t>(3, 3, 4, [](int x, int, int) { return x * 51 * 257; });
    EXPECT_EQ(compare_pictures(a, b).max_absolute, 0);
}

TEST(ComparePictures, NanEqualsNanAndDiffersInfinitelyFromNumbers) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Pixels a = picture_of<float>(2, 1, 1, [&](int, int, int) { return nan; });
    const Pixels b = picture_of<float>(2, 1, 1, [&](int x, int, int) { return x == 0 ? nan : 1.0f; });
    EXPECT_EQ(compare_pictures(a, a).max_absolute, 0);
    EXPECT_EQ(compare_pictures(a, b).max_absolute, infinity);
    EXPECT_EQ(compare_pictures(a, b).differing, 1u);
    EXPECT_EQ(compare_pictures(a, b).psnr_db, -infinity);
}

TEST(ComparePictures, SizesMustAgree) {
    const Pixels a = picture_of<std::uint8_t>(3, 2, 3, noise);
    EXPECT_THROW(compare_pictures(a, picture_of<std::uint8_t>(2, 3, 3, noise)), Error);
    EXPECT_THROW(compare_pictures(a, picture_of<std::uint8_t>(3, 2, 4, noise)), Error);
    EXPECT_EQ(compare_pictures(Pixels{}, Pixels{}).psnr_db, infinity);
}

}  // namespace
}  // namespace rakelight
