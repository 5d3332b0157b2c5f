// SPDX-License-Identifier: Apache-2.0
// The colormap with its numbers, at the right side of a picture.
#pragma once
#include <string>
#include <vector>

#include <rakelight/world/request.h>

namespace rakelight {

/// Round numbers (1, 2 or 5 times a power of ten apart) from x to y, both among them where they are round: 3 to 8; x alone where x = y.
std::vector<double> ticks(dvec2 range);

/// A small picture with its place in the whole; Overlay lays it over. RGBA codes: alpha is 0 or 255.
struct ScalarBar {
    int x = 0, y = 0;  ///< [px] of its top left corner
    Pixels pixels;     ///< empty where the picture has no room for it

    /// @param coloring  its range is set; @param width, height  [px] of the whole picture
    ScalarBar(const Coloring& coloring, int width, int height);
};

}  // namespace rakelight
