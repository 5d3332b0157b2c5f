// SPDX-License-Identifier: Apache-2.0
// Plausibility checks of a tangent-space normal map.
#pragma once
#include <cstdint>
#include <span>

#include "image/maps/green_direction.h"

namespace rakelight {

struct NormalMapCheck {
    std::uint64_t texels = 0;
    std::uint64_t below = 0;  ///< texels that point into the surface: blue under 128
    GreenDirection green;
    double length_error = 0;       ///< mean of | |2 rgb - 1| - 1 |
    double mean_xy = 0;            ///< of red and green, 2 c - 1 each; a flat map saved as sRGB has 0.47
    double mean_z = 0;             ///< of 2 blue - 1
    double mean_spread = 0;        ///< of the largest less the smallest of red, green and blue, in codes of 255
    double srgb_length_error = 0;  ///< the same after decoding the codes as sRGB

    /// Unit vectors that point out of the surface; in a gray picture these have z = 0.58.
    bool looks_like_normals() const { return length_error < 0.05 && mean_z > 0.7; }
    /// Gray up to JPEG artifacts. The only gray normal is (1, 1, 1), tilted by 55 degrees; the spread of a flat map is
    /// 127.
    bool looks_like_heights() const { return texels > 0 && mean_spread < 4; }
    /// Raw vectors are far from unit and tilted to the upper right; decoded as sRGB they are nearly unit.
    bool looks_srgb() const { return mean_xy > 0.25 && length_error > 0.1 && srgb_length_error < length_error / 3; }
};

/// `below` counts all texels; the rest samples evenly distributed rows, about 40,000 texels.
/// @param texels [height][stride], R in the low byte; the first `width` of a row are read
NormalMapCheck check_normal_map(std::span<const std::uint32_t> texels, int width, int height, int stride);

}  // namespace rakelight
