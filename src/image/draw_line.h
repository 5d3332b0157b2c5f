// SPDX-License-Identifier: Apache-2.0
// Antialiased lines on pictures.
#pragma once
#include <rakelight/image/image.h>
#include <rakelight/math/vector.h>

#include "image/false_color.h"

namespace rakelight {

/// Composites a straight line with round caps over an 8-bit RGBA picture, clipped to it. Coverage falls off linearly
/// over one pixel at the edge.
/// @param a, b [px] (0, 0) is the outer corner of the first pixel; non-finite: nothing is drawn
void draw_line(Pixels& picture, dvec2 a, dvec2 b, double width_px, Code color);

}  // namespace rakelight
