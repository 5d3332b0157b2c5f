// SPDX-License-Identifier: Apache-2.0
#include "image/draw_text.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "base/assert.h"
#include "math/color.h"

namespace rakelight {
namespace {

// clang-format off
/// The printable characters of ASCII, 19 to a band of 8 rows.
constexpr int glyphs_a_band = 19;
constexpr const char* font[] = {
    "..... ..#.. .#.#. .#.#. ..#.. ##..# .##.. ..#.. ...#. .#... ..... ..... ..... ..... ..... ....# .###. ..#.. .###.",
    "..... ..#.. .#.#. .#.#. .#### ##..# #..#. ..#.. ..#.. ..#.. ..#.. ..#.. ..... ..... ..... ....# #...# .##.. #...#",
    "..... ..#.. .#.#. ##### #.#.. ...#. #.#.. ..#.. .#... ...#. #.#.# ..#.. ..... ..... ..... ...#. #..## ..#.. ....#",
    "..... ..#.. ..... .#.#. .###. ..#.. .#... ..... .#... ...#. .###. ##### ..... ##### ..... ..#.. #.#.# ..#.. ..##.",
    "..... ..#.. ..... ##### ..#.# .#... #.#.# ..... .#... ...#. #.#.# ..#.. ..... ..... ..... .#... ##..# ..#.. .#...",
    "..... ..... ..... .#.#. ####. #..## #..#. ..... ..#.. ..#.. ..#.. ..#.. ..#.. ..... .##.. #.... #...# ..#.. #....",
    "..... ..#.. ..... .#.#. ..#.. #..## .##.# ..... ...#. .#... ..... ..... ..#.. ..... .##.. #.... .###. .###. #####",
    "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .#... ..... ..... ..... ..... ..... .....",

    ".###. ...#. ##### ..##. ##### .###. .###. ..... ..... ...#. ..... .#... .###. .###. .###. ####. .###. ###.. #####",
    "#...# ..##. #.... .#... ....# #...# #...# .##.. ..#.. ..#.. ..... ..#.. #...# #...# #...# #...# #...# #..#. #....",
    "....# .#.#. ####. #.... ...#. #...# #...# .##.. ..#.. .#... ##### ...#. ....# #.### #...# #...# #.... #...# #....",
    "..##. #..#. ....# ####. ...#. .###. .#### ..... ..... #.... ..... ....# ..##. #.#.# ##### ####. #.... #...# ####.",
    "....# ##### ....# #...# ..#.. #...# ....# .##.. ..... .#... ##### ...#. ..#.. #.### #...# #...# #.... #...# #....",
    "#...# ...#. #...# #...# ..#.. #...# ...#. .##.. ..#.. ..#.. ..... ..#.. ..... #.... #...# #...# #...# #..#. #....",
    ".###. ...#. .###. .###. ..#.. .###. .##.. ..... ..#.. ...#. ..... .#... ..#.. .#### #...# ####. .###. ###.. #####",
    "..... ..... ..... ..... ..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....",

    "##### .###. #...# .###. ..### #...# #.... #...# #...# .###. ####. .###. ####. .#### ##### #...# #...# #...# #...#",
    "#.... #...# #...# ..#.. ...#. #..#. #.... ##.## ##..# #...# #...# #...# #...# #.... ..#.. #...# #...# #...# #...#",
    "#.... #.... #...# ..#.. ...#. #.#.. #.... #.#.# ##..# #...# #...# #...# #...# #.... ..#.. #...# #...# #...# .#.#.",
    "####. #.### ##### ..#.. ...#. ##... #.... #.#.# #.#.# #...# ####. #...# ####. .###. ..#.. #...# .#.#. #.#.# ..#..",
    "#.... #...# #...# ..#.. ...#. #.#.. #.... #...# #..## #...# #.... #.#.# #.#.. ....# ..#.. #...# .#.#. #.#.# .#.#.",
    "#.... #...# #...# ..#.. #..#. #..#. #.... #...# #..## #...# #.... #..#. #..#. ....# ..#.. #...# .#.#. ##.## #...#",
    "#.... .###. #...# .###. .##.. #...# ##### #...# #...# .###. #.... .##.# #...# ####. ..#.. .###. ..#.. #...# #...#",
    "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .....",

    "#...# ##### .###. #.... .###. ..#.. ..... .#... ..... #.... ..... ....# ..... ..##. ..... #.... ..#.. ...#. #....",
    "#...# ....# .#... #.... ...#. .#.#. ..... ..#.. ..... #.... ..... ....# ..... .#..# ..... #.... ..... ..... #....",
    ".#.#. ...#. .#... .#... ...#. #...# ..... ...#. .###. ####. .###. .#### .###. .#... .#### ####. .##.. ..##. #..#.",
    "..#.. ..#.. .#... ..#.. ...#. ..... ..... ..... ....# #...# #...# #...# #...# ###.. #...# #...# ..#.. ...#. #.#..",
    "..#.. .#... .#... ...#. ...#. ..... ..... ..... .#### #...# #.... #...# ##### .#... #...# #...# ..#.. ...#. ##...",
    "..#.. #.... .#... ....# ...#. ..... ..... ..... #...# #...# #...# #...# #.... .#... .#### #...# ..#.. ...#. #.#..",
    "..#.. ##### .###. ....# .###. ..... ##### ..... .#### ####. .###. .#### .#### .#... ....# #...# .###. #..#. #..#.",
    "..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... ..... .###. ..... ..... .##.. .....",

    ".##.. ..... ..... ..... ..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... ...## ..#.. ##... .....",
    "..#.. ..... ..... ..... ..... ..... ..... ..... .#... ..... ..... ..... ..... ..... ..... ..#.. ..#.. ..#.. .....",
    "..#.. ##.#. ####. .###. ####. .#### #.##. .#### ###.. #...# #...# #...# #...# #...# ##### ..#.. ..#.. ..#.. .#...",
    "..#.. #.#.# #...# #...# #...# #...# ##..# #.... .#... #...# #...# #.#.# .#.#. #...# ...#. .#... ..#.. ...#. #.#.#",
    "..#.. #.#.# #...# #...# #...# #...# #.... .###. .#... #...# .#.#. #.#.# ..#.. #...# ..#.. ..#.. ..#.. ..#.. ...#.",
    "..#.. #.#.# #...# #...# ####. .#### #.... ....# .#..# #...# .#.#. #.#.# .#.#. .#### .#... ..#.. ..#.. ..#.. .....",
    ".###. #.#.# #...# .###. #.... ....# #.... ####. ..##. .#### ..#.. .#.#. #...# ....# ##### ...## ..#.. ##... .....",
    "..... ..... ..... ..... #.... ....# ..... ..... ..... ..... ..... ..... ..... .###. ..... ..... ..... ..... .....",
};
// clang-format on

constexpr int line_gap = 2;  ///< [dots]

/// The end of the UTF-8 character at `at`.
std::size_t after_character(std::string_view text, std::size_t at) {
    ++at;
    while (at < text.size() && (std::uint8_t(text[at]) & 0xc0) == 0x80) ++at;
    return at;
}

/// Calls f(character, column, line) for each character except line breaks.
/// @return [characters] of the longest line
template <class Call>
int for_characters(std::string_view text, const Call& call) {
    int column = 0, line = 0, longest = 0;
    for (std::size_t at = 0; at < text.size(); at = after_character(text, at)) {
        if (text[at] == '\n') {
            ++line, column = 0;
            continue;
        }
        call(text[at], column++, line);
        longest = std::max(longest, column);
    }
    return longest;
}

/// The bytes of one pixel of a color, in the picture's own components.
struct PixelBytes {
    std::byte bytes[4 * sizeof(float)];
    std::size_t count;
};

template <class T>
PixelBytes bytes_of(const T (&components)[4], int channels) {
    const bool is_gray = channels < 3;
    const T luminance =
        T(0.2126f * float(components[0]) + 0.7152f * float(components[1]) + 0.0722f * float(components[2]));
    const T in_order[4] = {is_gray ? luminance : components[0], is_gray ? components[3] : components[1], components[2],
                           components[3]};
    PixelBytes out{};
    out.count = std::size_t(channels) * sizeof(T);
    std::memcpy(out.bytes, in_order, out.count);
    return out;
}

PixelBytes pixel_of(Code c, const Pixels& picture) {
    switch (picture.component) {
        case Component::u8: {
            const std::uint8_t codes[4] = {c.r, c.g, c.b, 255};
            return bytes_of(codes, picture.channels);
        }
        case Component::u16: {
            const std::uint16_t codes[4] = {std::uint16_t(c.r * 257), std::uint16_t(c.g * 257),
                                            std::uint16_t(c.b * 257), 65535};
            return bytes_of(codes, picture.channels);
        }
        case Component::f32:
            break;
    }
    const float light[4] = {linear_from_srgb8(c.r), linear_from_srgb8(c.g), linear_from_srgb8(c.b), 1};
    return bytes_of(light, picture.channels);
}

}  // namespace

int text_width(std::string_view text, int scale) {
    const int longest = for_characters(text, [](char, int, int) {});
    return longest == 0 ? 0 : (longest * text_dots_across - 1) * scale;
}

int text_height(std::string_view text, int scale) {
    const int lines = 1 + int(std::ranges::count(text, '\n'));
    return (lines * (text_dots_down + line_gap) - line_gap) * scale;
}

int text_scale_for(int picture_height) { return std::max(1, picture_height / 540 + (picture_height % 540 ? 1 : 0)); }

bool is_dot(char character, int column, int row) {
    RL_ASSERT(column >= 0 && column < glyph_dots_across && row >= 0 && row < text_dots_down, "no such dot");
    const bool is_printable = character >= ' ' && character <= '~';
    const int number = (is_printable ? character : '?') - ' ';
    const int band = number / glyphs_a_band, in_band = number % glyphs_a_band;
    return font[band * text_dots_down + row][in_band * text_dots_across + column] == '#';
}

void fill_rectangle(Pixels& picture, int x, int y, int width, int height, Code color) {
    const PixelBytes pixel = pixel_of(color, picture);
    const int left = std::clamp(x, 0, picture.width), top = std::clamp(y, 0, picture.height);
    const int right = std::clamp(x + width, left, picture.width), bottom = std::clamp(y + height, top, picture.height);
    for (int row = top; row < bottom; ++row) {
        std::byte* to = picture.row(row) + std::size_t(left) * pixel.count;
        for (int i = left; i < right; ++i, to += pixel.count) std::memcpy(to, pixel.bytes, pixel.count);
    }
}

namespace {

/// @param rim [px] enlargement of each dot on every side
void draw_dots(Pixels& picture, int x, int y, std::string_view text, int scale, int rim, Code color) {
    for_characters(text, [&](char character, int column, int line) {
        const int left = x + column * text_dots_across * scale, top = y + line * (text_dots_down + line_gap) * scale;
        for (int v = 0; v < text_dots_down; ++v)
            for (int u = 0; u < glyph_dots_across; ++u)
                if (is_dot(character, u, v))
                    fill_rectangle(picture, left + u * scale - rim, top + v * scale - rim, scale + 2 * rim,
                                   scale + 2 * rim, color);
    });
}

}  // namespace

void draw_text(Pixels& picture, int x, int y, std::string_view text, const TextStyle& style) {
    RL_ASSERT(style.scale >= 1, "a dot has at least a pixel");
    if (style.halo) draw_dots(picture, x, y, text, style.scale, style.scale, *style.halo);
    draw_dots(picture, x, y, text, style.scale, 0, style.color);
}

}  // namespace rakelight
