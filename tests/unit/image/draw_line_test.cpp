// SPDX-License-Identifier: Apache-2.0
#include "image/draw_line.h"

#include <gtest/gtest.h>

#include <limits>

namespace rakelight {
namespace {

Pixels clear_picture(int width, int height) {
    Pixels out{.width = width, .height = height, .channels = 4, .component = Component::u8};
    out.bytes.resize(out.row_bytes() * std::size_t(height));
    return out;
}

int alpha(const Pixels& p, int x, int y) { return std::to_integer<int>(p.row(y)[4 * std::size_t(x) + 3]); }

TEST(DrawLine, CoversWhatItsWidthSays) {
    Pixels picture = clear_picture(40, 20);
    draw_line(picture, {5, 10}, {35, 10}, 4, {10, 20, 30});
    double sum = 0;
    for (int y = 0; y < 20; ++y) sum += alpha(picture, 20, y) / 255.0;
    EXPECT_NEAR(sum, 4, 0.01);
    EXPECT_EQ(alpha(picture, 20, 9), 255);
    EXPECT_EQ(alpha(picture, 20, 3), 0);
    EXPECT_EQ(alpha(picture, 39, 10), 0);
    EXPECT_EQ(picture.row(9)[4 * 20 + 2], std::byte(30));
}

TEST(DrawLine, IsLaidOverWhatIsThere) {
    Pixels picture = clear_picture(9, 9);
    draw_line(picture, {0, 4.5}, {9, 4.5}, 3, {255, 0, 0});
    draw_line(picture, {4.5, 0}, {4.5, 9}, 3, {0, 0, 255});
    EXPECT_EQ(picture.row(4)[4 * 4], std::byte(0));
    EXPECT_EQ(picture.row(4)[4 * 4 + 2], std::byte(255));
    EXPECT_EQ(picture.row(4)[0], std::byte(255));
}

TEST(DrawLine, WhatIsOutsideOrNoNumberIsLeftOut) {
    Pixels picture = clear_picture(8, 8);
    draw_line(picture, {-50, -50}, {-10, -20}, 3, {255, 255, 255});
    draw_line(picture, {std::numeric_limits<double>::quiet_NaN(), 0}, {8, 8}, 3, {255, 255, 255});
    for (const std::byte b : picture.bytes) EXPECT_EQ(b, std::byte(0));
    draw_line(picture, {-1e9, -1e9}, {1e9, 1e9}, 2, {255, 255, 255});
    EXPECT_EQ(alpha(picture, 3, 3), 255);
}

}  // namespace
}  // namespace rakelight
