// SPDX-License-Identifier: Apache-2.0
// Lines that a window shows over a picture.
#pragma once
#include <rakelight/vector.h>

namespace rakelight {

/// A line in the world, as wide everywhere on the screen.
struct Line {
    dvec3 from{}, to{};       ///< [m]
    vec4 color{1, 1, 1, 1};   ///< sRGB as it is shown, and opacity
    float width_px = 1;       ///< more than 0
    bool is_overlay = false;  ///< seen through surfaces
};

}  // namespace rakelight
