// SPDX-License-Identifier: Apache-2.0
#include "image/false_color.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <tuple>

namespace rakelight {
namespace {

TEST(FalseColor, NumbersNearEachOtherHaveColorsOfTheirOwn) {
    std::set<std::tuple<int, int, int>> seen;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const Code c = color_of_number(i);
        EXPECT_GT(c.r + c.g + c.b, 100) << i;
        seen.insert({c.r, c.g, c.b});
    }
    EXPECT_GE(seen.size(), 950u);
    for (std::uint32_t i = 0; i < 1000; ++i) EXPECT_NE(color_of_number(i), color_of_number(i + 1)) << i;
}

TEST(FalseColor, ANumberKeepsItsColor) {
    EXPECT_EQ(color_of_number(0), (Code{166, 41, 41}));
    EXPECT_EQ(color_of_number(7), color_of_number(7));
}

TEST(FalseColor, HeatGoesFromDarkBlueToWhite) {
    EXPECT_EQ(heat(0), (Code{20, 20, 64}));
    EXPECT_EQ(heat(0.4), (Code{51, 179, 89}));
    EXPECT_EQ(heat(1), (Code{255, 255, 255}));
    EXPECT_EQ(heat(5), heat(1));
    EXPECT_EQ(heat(-1), heat(0));
    EXPECT_EQ(heat(std::numeric_limits<double>::quiet_NaN()), heat(0));
}

TEST(FalseColor, CodesAreRoundedAndClamped) {
    EXPECT_EQ(code_of(0.5), 128);
    EXPECT_EQ(code_of(-3), 0);
    EXPECT_EQ(code_of(3), 255);
    EXPECT_EQ(code_of(std::numeric_limits<double>::quiet_NaN()), 0);
}

}  // namespace
}  // namespace rakelight
