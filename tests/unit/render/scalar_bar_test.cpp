// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "math/color.h"
#include "render/output/scalar_bar.h"

namespace rakelight {
namespace {

TEST(ScalarBar, TicksAreRoundAndInTheRange) {
    EXPECT_EQ(ticks({0, 10}), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(ticks({-1, 1}), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
    EXPECT_EQ(ticks({0.3, 0.3}), (std::vector<double>{0.3}));
    for (const dvec2 range : {dvec2{0.013, 0.97}, dvec2{-12345, 99}, dvec2{1e-9, 7e-9}, dvec2{3, 1e12}}) {
        const std::vector<double> at = ticks(range);
        EXPECT_GE(at.size(), 2u) << range.x;
        EXPECT_LE(at.size(), 9u) << range.x;
        for (const double t : at)
            EXPECT_TRUE(t >= range.x - 1e-6 * (range.y - range.x) && t <= range.y + 1e-6 * (range.y - range.x));
    }
}

TEST(ScalarBar, HasTheColormapFromTopToBottom) {
    const Coloring coloring{.is_on = true, .array = "heat", .range = dvec2{0, 10}, .map = ColorMap::gray};
    const ScalarBar bar(coloring, 640, 480);
    ASSERT_GT(bar.pixels.height, 200);
    const auto gray = [&](int row) { return std::to_integer<int>(bar.pixels.row(row)[4 * 4]); };
    const int top = bar.pixels.height - 480 * 3 / 5, bottom = bar.pixels.height - 12;
    EXPECT_GT(gray(top), 230);
    EXPECT_LT(gray(bottom), 25);
    for (int row = top + 1; row <= bottom; ++row) EXPECT_LE(gray(row), gray(row - 1)) << row;
    EXPECT_GT(bar.x, 320) << "at the right side";
    EXPECT_LE(bar.x + bar.pixels.width, 640);
}

TEST(ScalarBar, SmallPicturesHaveNoRoom) {
    const Coloring coloring{.is_on = true, .array = "a long name of an array", .range = dvec2{0, 1}};
    EXPECT_TRUE(ScalarBar(coloring, 40, 30).pixels.bytes.empty());
    EXPECT_TRUE(ScalarBar(coloring, 1, 1).pixels.bytes.empty());
}

}  // namespace
}  // namespace rakelight
