// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/color.h"

namespace rakelight {
namespace {

TEST(Color, KnownValuesOfTheSrgbCurve) {
    // IEC 61966-2-1; mid gray 0.5 encoded is 0.2140411 linear.
    EXPECT_EQ(linear_from_srgb(0.0f), 0.0f);
    EXPECT_EQ(linear_from_srgb(1.0f), 1.0f);
    EXPECT_NEAR(linear_from_srgb(0.5f), 0.21404114f, 1e-7f);
    EXPECT_NEAR(linear_from_srgb(0.04f), 0.04f / 12.92f, 1e-8f);
    EXPECT_NEAR(srgb_from_linear(0.21404114f), 0.5f, 1e-7f);
    EXPECT_NEAR(srgb_from_linear(0.18f), 0.46135613f, 1e-7f);
    EXPECT_EQ(srgb_from_linear(1.0f), 1.0f);
    const vec3 decoded = linear_from_srgb(vec3{0.0f, 0.5f, 1.0f});
    EXPECT_EQ(decoded, (vec3{0.0f, linear_from_srgb(0.5f), 1.0f}));
}

TEST(Color, ValuesOutsideTheRangeAreClampedAndNanIsBlack) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(linear_from_srgb(-1.0f), 0.0f);
    EXPECT_EQ(linear_from_srgb(2.0f), 1.0f);
    EXPECT_EQ(srgb_from_linear(-1.0f), 0.0f);
    EXPECT_EQ(srgb_from_linear(inf), 1.0f);
    EXPECT_EQ(srgb_from_linear(nan), 0.0f);
    EXPECT_EQ(srgb8_from_linear(nan), 0);
    EXPECT_EQ(srgb8_from_linear(-inf), 0);
    EXPECT_EQ(srgb8_from_linear(-0.0f), 0);
    EXPECT_EQ(srgb8_from_linear(1.0f), 255);
    EXPECT_EQ(srgb8_from_linear(inf), 255);
}

TEST(Color, EveryByteSurvivesTheWayToLinearAndBack) {
    for (int i = 0; i < 256; ++i) {
        EXPECT_EQ(srgb8_from_linear(linear_from_srgb8(std::uint8_t(i))), i);
        EXPECT_FLOAT_EQ(linear_from_srgb8(std::uint8_t(i)), linear_from_srgb(float(i / 255.0)));
    }
}

TEST(Color, BytesAreRoundedCorrectly) {
    for (int i = 0; i <= 300000; ++i) {
        const float l = float(i) / 300000.0f;
        const double exact = (l <= 0.0031308 ? l * 12.92 : 1.055 * std::pow(double(l), 1 / 2.4) - 0.055) * 255;
        const int got = srgb8_from_linear(l);
        ASSERT_LE(std::fabs(got - exact), 0.5 + 1e-9) << l;
    }
}

TEST(Color, BytesNeverFallWhereLightRises) {
    for (int i = 1; i < 255; ++i) {
        const float middle = linear_from_srgb(float((i + 0.5) / 255.0));
        EXPECT_LE(srgb8_from_linear(std::nextafterf(middle, 0.0f)), srgb8_from_linear(std::nextafterf(middle, 1.0f)));
    }
}

}  // namespace
}  // namespace rakelight
