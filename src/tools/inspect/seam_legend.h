// SPDX-License-Identifier: Apache-2.0
// The legend of a heat map: the color bar in degrees, and the place of the largest seam.
#pragma once
#include <optional>

#include <rakelight/tools/inspect.h>

namespace rakelight {

/// Where the largest seam is in the picture.
struct SeamPlace {
    double x = 0, y = 0;     ///< [px] of the frame
    bool is_hidden = false;  ///< a surface is before it
};

/// Smaller pictures have no room for a legend.
inline constexpr int least_legend_width = 240, least_legend_height = 180;

/// Draws the legend into the lower left corner, and a ring about the largest seam with its angle (broken where a surface hides it).
/// @param place  absent: it is not in the picture, which the legend says
void draw_seam_legend(Frame& frame, const Inspection& inspection, const std::optional<SeamPlace>& place);

}  // namespace rakelight
