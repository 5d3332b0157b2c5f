// SPDX-License-Identifier: Apache-2.0
// Rasterization: which pixel centers of a tile lie in a triangle, and at what depth.
#pragma once
#include <algorithm>

#include "engines/raster/front_end.h"

namespace rakelight::raster {

/// Calls pixel(x, y, depth) for each pixel of `area` (in the picture) whose center the triangle covers; x, y count from the
/// tile's corner. Fixed-point edge functions with the top-left rule (Pineda 1988): a pixel center that lies exactly on an edge
/// belongs to the triangle whose top or left edge it is, so that triangles which share an edge cover each pixel exactly once.
/// Depth: the key of ScreenTriangle, greater is nearer.
template <class Pixel>
void cover(const ScreenTriangle& s, const Window& area, int tile_x, int tile_y, const Pixel& pixel) {
    const auto [x_low, x_high] = std::minmax({s.x[0], s.x[1], s.x[2]});
    const auto [y_low, y_high] = std::minmax({s.y[0], s.y[1], s.y[2]});
    const int left = std::max((x_low + 127) >> subpixel_bits, area.x);
    const int right = std::min((x_high - 128) >> subpixel_bits, area.x + area.width - 1);
    const int top = std::max((y_low + 127) >> subpixel_bits, area.y);
    const int bottom = std::min((y_high - 128) >> subpixel_bits, area.y + area.height - 1);

    std::int64_t row[3], step_x[3], step_y[3];  // edge functions at the first pixel center, and their steps
    for (int k = 0; k < 3; ++k) {
        const int n = (k + 1) % 3;
        const std::int64_t dx = s.x[n] - s.x[k], dy = s.y[n] - s.y[k];
        const std::int64_t px = (std::int64_t(left) << subpixel_bits) + 128, py = (std::int64_t(top) << subpixel_bits) + 128;
        const bool is_top_or_left = dy < 0 || (dy == 0 && dx > 0);  // positive area, y down
        row[k] = dx * (py - s.y[k]) - dy * (px - s.x[k]) - (is_top_or_left ? 0 : 1);
        step_x[k] = -dy * (1 << subpixel_bits);
        step_y[k] = dx * (1 << subpixel_bits);
    }
    // The depth plane about the tile's first pixel center in float: fixed by the tile, not by the triangle's box.
    const auto depth_0 = float(s.depth_0 + s.depth_x * (tile_x + 0.5) + s.depth_y * (tile_y + 0.5));
    const auto depth_x = float(s.depth_x), depth_y = float(s.depth_y);
    for (int y = top; y <= bottom; ++y) {
        std::int64_t e0 = row[0], e1 = row[1], e2 = row[2];
        const float depth_row = depth_0 + depth_y * float(y - tile_y);
        for (int x = left; x <= right; ++x) {
            if ((e0 | e1 | e2) >= 0) {
                const float plane = depth_row + depth_x * float(x - tile_x);
                // Written so that a NaN of an overflowing plane becomes the farthest corner.
                const float from_below = plane > s.depth_low ? plane : s.depth_low;
                pixel(x - tile_x, y - tile_y, from_below < s.depth_high ? from_below : s.depth_high);
            }
            e0 += step_x[0];
            e1 += step_x[1];
            e2 += step_x[2];
        }
        for (int k = 0; k < 3; ++k) row[k] += step_y[k];
    }
}

}  // namespace rakelight::raster
