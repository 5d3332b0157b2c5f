// SPDX-License-Identifier: Apache-2.0
// A picture to draw lines and words into, and colors for numbers.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include <rakelight/image/image.h>
#include <rakelight/math/vector.h>

#include "image/false_color.h"

namespace rakelight::stages {

using rakelight::Code;

inline constexpr int letter_dot = 2, letter_height = 7 * letter_dot;  ///< [px] a dot of a letter; a capital or digit

/// Which end of a text a place is.
enum class Align : std::uint8_t { left, center, right };

class Canvas {
public:
    Canvas(int width, int height, Code ground);
    int width() const { return pixels_.width; }
    int height() const { return pixels_.height; }
    /// Nothing happens outside of the picture.
    void set(int x, int y, Code color);
    Code at(int x, int y) const;
    /// [px] a line of one pixel's width; parts outside, and ends that are not finite, are left out.
    void line(dvec2 a, dvec2 b, Code color);
    /// [px] the pixels whose centers lie in the triangle, either way round; nothing where a corner is not finite.
    void fill(dvec2 a, dvec2 b, dvec2 c, Code color);
    /// [px] `y` is the top of capitals.
    void write(int x, int y, std::string_view text, Code color, Align align = Align::left);
    const Pixels& pixels() const { return pixels_; }

private:
    Pixels pixels_;
};

/// How many lines go through each pixel, for more of them than a picture can distinguish.
class LineCounts {
public:
    LineCounts(int width, int height);
    /// As Canvas::line().
    void line(dvec2 a, dvec2 b);
    /// Lines through a pixel that some go through; 0: there are none.
    double mean() const;
    /// Lines over a canvas of the same size: in full where they can be distinguished, else the stronger the more of them
    /// go through a pixel.
    void draw(Canvas& canvas, Code color) const;
    bool is_crowded() const { return mean() > told_apart; }

private:
    /// So many lines that only one pixel in fifty has more.
    double often() const;

    static constexpr double told_apart = 4;  ///< an edge inside of a mesh is drawn by both of its triangles
    int width_, height_;
    std::vector<std::uint32_t> counts_;
};

using rakelight::code_of_light;
using rakelight::color_of_number;
using rakelight::heat;
Code gray(double value);  ///< 0 black to 1 white; clamped
/// -1..1 a component to 0..255.
Code color_of_normal(vec3 n);

}  // namespace rakelight::stages
