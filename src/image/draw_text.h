// SPDX-License-Identifier: Apache-2.0
// Text on pictures: a fixed-width bitmap font of 5 x 7 dots for ASCII, each dot a square of whole pixels.
#pragma once
#include <optional>
#include <string_view>

#include <rakelight/image/image.h>

#include "image/false_color.h"

namespace rakelight {

/// [dots] cell of a character; capitals and digits are 7 dots high, the eighth row is for descenders.
inline constexpr int text_dots_across = 6, text_dots_down = 8, glyph_dots_across = 5;

/// Style of text.
inline constexpr Code words_color{255, 255, 255}, halo_color{24, 24, 28};

struct TextStyle {
    Code color = words_color;    ///< sRGB codes
    int scale = 1;               ///< [px] side of a dot, >= 1
    std::optional<Code> halo{};  ///< outline color, for text over a picture of any brightness
};

/// [px] of the longest line, without the halo; lines are separated by '\n'.
int text_width(std::string_view text, int scale);
/// [px] of all lines, from the top of capitals to the last row of descenders; lines have a gap of two dots.
int text_height(std::string_view text, int scale);
/// A legible scale for a picture of this height: 1 up to 540 rows, one more for every further 540.
int text_scale_for(int picture_height);

/// Whether a dot of a character is set: column 0..4, row 0..7. Non-ASCII characters are question marks.
bool is_dot(char character, int column, int row);

/// Draws into a picture of any component and of 1 to 4 channels. Gray takes the luminance of the color, alpha becomes
/// opaque, and floats get linear light. The top left corner of the first line is (x, y) [px]; text is clipped to the
/// picture. Each UTF-8 character beyond ASCII becomes a question mark.
void draw_text(Pixels& picture, int x, int y, std::string_view text, const TextStyle& style);

/// Fills a rectangle, clipped to the picture, with a color.
void fill_rectangle(Pixels& picture, int x, int y, int width, int height, Code color);

}  // namespace rakelight
