// SPDX-License-Identifier: Apache-2.0
// Antialiased lines on pictures.
#pragma once
#include <rakelight/image.h>
#include <rakelight/vector.h>

#include "image/false_color.h"

namespace rakelight {

/// A straight line with round ends into an 8-bit RGBA picture, laid over what is there; what lies outside is left out. Coverage is that of
/// a rim one pixel wide about the pixel's center.
/// @param a, b  [px] (0, 0) is the outer corner of the first pixel; not finite: nothing is drawn
void draw_line(Pixels& picture, dvec2 a, dvec2 b, double width_px, Code color);

}  // namespace rakelight
