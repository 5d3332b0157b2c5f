// SPDX-License-Identifier: Apache-2.0
// Detects the green direction of a tangent-space normal map from its texels.
#pragma once
#include <cstdint>
#include <span>

namespace rakelight {

/// Let p and q be the slopes of the height along u and upwards. Where green points up, dp/dy and dq/dx are both the
/// mixed derivative of one height field; with green down one is the other's negative. Agreement is 2 sum(dp/dy dq/dx)
/// over sum((dp/dy)^2 + (dq/dx)^2): 1 where they are equal, -1 where one is the other's negative. A correlation would
/// be fooled by rounding next to large slopes, as in painted bricks.
struct GreenDirection {
    double fine = 0, coarse = 0;  ///< -1..1: agreement of neighboring texels, and of the means of 2 x 2; 0: no relief
    int parts = 0;                ///< number of the map's 8 x 8 parts with relief
    int up = 0, down = 0;         ///< of these: agreement above 0.25, below -0.25

    /// A wrong guess is worse than none: both scales must agree, and eight of ten parts of the map separately. Maps
    /// that are not height fields (combed, painted, of bent charts), or have little detail, stay below.
    bool is_up() const { return is_sure(fine, coarse, up); }
    bool is_down() const { return is_sure(-fine, -coarse, down); }

private:
    bool is_sure(double a, double b, int agreeing) const {
        return a > 0.6 && b > 0.6 && parts >= 8 && 10 * agreeing >= 8 * parts;
    }
};

/// Evaluates windows in the middle of each part, at most 83 000 texels; nothing for maps smaller than 32 x 32.
/// @param texels [height][stride], R in the low byte; the first `width` of a row are read
GreenDirection find_green_direction(std::span<const std::uint32_t> texels, int width, int height, int stride);

}  // namespace rakelight
