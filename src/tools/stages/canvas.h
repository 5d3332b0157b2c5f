// SPDX-License-Identifier: Apache-2.0
// A picture to draw lines into, and colors for numbers.
#pragma once
#include <cstdint>

#include <rakelight/image.h>
#include <rakelight/vector.h>

#include "image/false_color.h"

namespace rakelight::stages {

using rakelight::Code;

class Canvas {
public:
    Canvas(int width, int height, Code ground);
    int width() const { return pixels_.width; }
    int height() const { return pixels_.height; }
    /// Nothing happens outside of the picture.
    void set(int x, int y, Code color);
    /// [px] a line of one pixel's width; parts outside, and ends that are not finite, are left out.
    void line(dvec2 a, dvec2 b, Code color);
    /// [px] the pixels whose centers lie in the triangle, either way round; nothing where a corner is not finite.
    void fill(dvec2 a, dvec2 b, dvec2 c, Code color);
    const Pixels& pixels() const { return pixels_; }

private:
    Pixels pixels_;
};

using rakelight::color_of_number;
using rakelight::heat;
Code gray(double value);  ///< 0 black to 1 white; clamped
/// -1..1 a component to 0..255.
Code color_of_normal(vec3 n);
/// Linear light, clamped, as display codes.
Code display(vec3 linear);

}  // namespace rakelight::stages
