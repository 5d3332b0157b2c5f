// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tools/stages/canvas.h"

namespace rakelight::stages {
namespace {

// Where a line enters is rounded: some ends lie at -1e-16. A pixel left of the first one is the last of the row above,
// or, in the first row, other memory: the address sanitizer sees it.
TEST(LineCounts, ALineThatEntersFromOutsideStaysInside) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-300, 360);
    for (int i = 0; i < 20000; ++i) {
        LineCounts counts(64, 1);
        counts.line({place(random), place(random)}, {place(random), place(random)});
        const double mean = counts.mean();
        ASSERT_TRUE(mean == 0 || mean >= 1) << i;
    }
}

TEST(CanvasText, BeginsEndsOrIsCenteredAtItsPlace) {
    constexpr int width = 60, at = 30;
    constexpr Code ink{255, 255, 255};
    struct Extent {
        int first = width, last = -1;
    };
    const auto written = [&](Align align) {
        Canvas canvas(width, 20, {});
        canvas.write(at, 2, "HH", ink, align);  // 11 dots from its first stem to its last
        Extent extent;
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < width; ++x)
                if (canvas.at(x, y).r == ink.r) extent = {std::min(extent.first, x), std::max(extent.last, x)};
        return extent;
    };
    EXPECT_EQ(written(Align::left).first, at);
    EXPECT_EQ(written(Align::right).last, at - 1);
    const Extent centered = written(Align::center);
    EXPECT_EQ(at - centered.first, centered.last + 1 - at);
}

}  // namespace
}  // namespace rakelight::stages
