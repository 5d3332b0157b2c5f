// SPDX-License-Identifier: Apache-2.0
#include "tools/stages/label.h"

namespace rakelight::stages {
namespace {

/// 3 x 5 dots: an octal digit a row from the top, 4 the left dot and 1 the right one.
struct Glyph {
    char character;
    const char* rows;
};
constexpr Glyph glyphs[] = {
    {'0', "75557"}, {'1', "26227"}, {'2', "71747"}, {'3', "71717"}, {'4', "55711"}, {'5', "74717"},
    {'6', "74757"}, {'7', "71122"}, {'8', "75757"}, {'9', "75717"}, {'.', "00002"}, {'-', "00700"},
    {'+', "02720"}, {'%', "51245"}, {'a', "03553"}, {'c', "03443"}, {'d', "11353"}, {'e', "25743"},
    {'f', "34644"}, {'g', "34553"}, {'i', "20222"}, {'k', "45665"}, {'l', "22222"}, {'m', "57755"},
    {'n', "06555"}, {'o', "00757"}, {'p', "06564"}, {'r', "05644"}, {'s', "34216"}, {'t', "27222"},
    {'u', "05553"}, {'v', "00552"}, {'w', "05575"}, {'x', "05225"}, {'y', "05536"}, {'z', "07247"},
};
constexpr int dot = 2;  ///< [px]

const char* rows_of(char character) {
    for (const Glyph& g : glyphs)
        if (g.character == character) return g.rows;
    return "00000";
}

}  // namespace

void label(Canvas& canvas, int x, int y, std::string_view text, Code color) {
    for (const char character : text) {
        const char* const rows = rows_of(character);
        for (int py = 0; py < 5 * dot; ++py)
            for (int px = 0; px < 3 * dot; ++px)
                if ((rows[py / dot] - '0') & (4 >> px / dot)) canvas.set(x + px, y + py, color);
        x += label_advance;
    }
}

}  // namespace rakelight::stages
