// SPDX-License-Identifier: Apache-2.0
// Lines drawn over a picture in a window.
#pragma once
#include <rakelight/math/vector.h>

namespace rakelight {

/// A line segment in world space with a constant width on the screen.
struct Line {
    dvec3 from{}, to{};       ///< [m]
    vec4 color{1, 1, 1, 1};   ///< sRGB display color and opacity
    float width_px = 1;       ///< [px] > 0
    bool is_overlay = false;  ///< visible through surfaces
};

}  // namespace rakelight
