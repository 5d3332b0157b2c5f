// SPDX-License-Identifier: Apache-2.0
#include "image/draw_text.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace rakelight {
namespace {

Pixels blank(int width, int height, int channels, Component component = Component::u8) {
    Pixels out{.width = width, .height = height, .channels = channels, .component = component};
    out.bytes.resize(out.row_bytes() * std::size_t(height));
    return out;
}

/// Rows of '#' where the first component is not 0.
std::string drawn(const Pixels& picture) {
    std::string out;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x)
            out += picture.row(y)[std::size_t(x * picture.channels)] != std::byte{0} ? '#' : '.';
        out += '\n';
    }
    return out;
}

TEST(DrawText, DrawsTheDotsOfTheFont) {
    Pixels picture = blank(12, 8, 3);
    draw_text(picture, 0, 0, "Ay", {});
    EXPECT_EQ(drawn(picture),
              ".###........\n"
              "#...#.......\n"
              "#...#.#...#.\n"
              "#####.#...#.\n"
              "#...#.#...#.\n"
              "#...#..####.\n"
              "#...#.....#.\n"
              ".......###..\n");
}

TEST(DrawText, EveryPrintableCharacterHasAPictureOfItsOwn) {
    std::vector<std::string> seen;
    for (char c = '!'; c <= '~'; ++c) {
        std::string dots;
        for (int row = 0; row < text_dots_down; ++row)
            for (int column = 0; column < glyph_dots_across; ++column) dots += is_dot(c, column, row) ? '#' : '.';
        EXPECT_NE(dots.find('#'), std::string::npos) << c;
        for (const std::string& other : seen) EXPECT_NE(dots, other) << c;
        seen.push_back(dots);
    }
    EXPECT_FALSE(is_dot(' ', 2, 3));
}

TEST(DrawText, WhatIsNotAsciiIsOneQuestionMark) {
    Pixels odd = blank(20, 8, 1), asked = blank(20, 8, 1);
    draw_text(odd, 0, 0, "a\xc3\xa4\x01", {});
    draw_text(asked, 0, 0, "a??", {});
    EXPECT_EQ(odd.bytes, asked.bytes);
    EXPECT_EQ(text_width("a\xc3\xa4\x01", 1), text_width("a??", 1));
}

TEST(DrawText, ScaleMakesSquaresAndSizesFollow) {
    Pixels small = blank(5, 8, 1), large = blank(15, 24, 1);
    draw_text(small, 0, 0, "R", {});
    draw_text(large, 0, 0, "R", {.scale = 3});
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 15; ++x) EXPECT_EQ(large.row(y)[x], small.row(y / 3)[x / 3]);
    EXPECT_EQ(text_width("R", 3), 15);
    EXPECT_EQ(text_width("ab\nabc\n", 2), 2 * (3 * 6 - 1));
    EXPECT_EQ(text_width("", 2), 0);
    EXPECT_EQ(text_height("a\nb", 2), 2 * 18);
    EXPECT_EQ(text_scale_for(100), 1);
    EXPECT_EQ(text_scale_for(540), 1);
    EXPECT_EQ(text_scale_for(720), 2);
    EXPECT_EQ(text_scale_for(2160), 4);
}

TEST(DrawText, IsCutAtTheBordersOfThePicture) {
    Pixels whole = blank(40, 20, 3), part = blank(7, 5, 3);
    draw_text(whole, 10, 6, "WQ\ng", {.color = {9, 8, 7}, .halo = Code{1, 2, 3}});
    draw_text(part, 10 - 12, 6 - 8, "WQ\ng", {.color = {9, 8, 7}, .halo = Code{1, 2, 3}});
    for (int y = 0; y < part.height; ++y)
        EXPECT_EQ(std::memcmp(part.row(y), whole.row(y + 8) + 3 * 12, part.row_bytes()), 0) << y;
}

TEST(DrawText, ColorsAreInThePicturesOwnComponents) {
    Pixels deep = blank(5, 8, 4, Component::u16), light = blank(5, 8, 3, Component::f32), gray = blank(5, 8, 2);
    const TextStyle style{.color = {255, 128, 0}};
    draw_text(deep, 0, 0, "L", style);
    draw_text(light, 0, 0, "L", style);
    draw_text(gray, 0, 0, "L", style);
    std::uint16_t codes[4];
    std::memcpy(codes, deep.row(0), sizeof codes);
    EXPECT_EQ(codes[0], 65535);
    EXPECT_EQ(codes[1], 128 * 257);
    EXPECT_EQ(codes[3], 65535);
    float linear[3];
    std::memcpy(linear, light.row(0), sizeof linear);
    EXPECT_EQ(linear[0], 1.0f);
    EXPECT_NEAR(linear[1], 0.2158605f, 1e-6f);
    EXPECT_EQ(gray.row(0)[0], std::byte(145));  // Rec. 709 weights of the codes
    EXPECT_EQ(gray.row(0)[1], std::byte(255));
}

}  // namespace
}  // namespace rakelight
