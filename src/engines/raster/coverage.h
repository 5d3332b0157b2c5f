// SPDX-License-Identifier: Apache-2.0
// Rasterization: which pixel centers of a tile lie in a triangle, and at what depth.
#pragma once
#include <algorithm>

#include "engines/raster/front_end.h"

namespace rakelight::raster {

/// A triangle in one tile: which pixels may be covered, in px from the tile's corner, and what decides it. Fixed-point edge
/// functions with the top-left rule (Pineda 1988): a pixel center that lies exactly on an edge belongs to the triangle whose top or left
/// edge it is, so that triangles which share an edge cover each pixel exactly once. From pixel to pixel an edge function
/// changes by multiples of 256, so only the integer part of its 256th counts: floor(e / 256) >= 0 where e >= 0.
struct Coverage {
    int left, top, right, bottom;                  ///< inclusive
    std::int64_t edge[3], step_x[3], step_y[3];    ///< at (left, top), and its change per pixel; 0 where all pixels pass
    float depth_0, depth_x, depth_y;               ///< the plane of the depth keys about the tile's first pixel center
    float depth_low, depth_high;
};

/// @param area  pixels of the picture that count; lies in the tile
/// @return false: no pixel is covered
inline bool set_coverage(const ScreenTriangle& s, const Window& area, int tile_x, int tile_y, Coverage& c) {
    const auto [x_low, x_high] = std::minmax({s.x0, s.x1, s.x2});
    const auto [y_low, y_high] = std::minmax({s.y0, s.y1, s.y2});
    const int left = std::max((x_low + 127) >> subpixel_bits, area.x);
    const int right = std::min((x_high - 128) >> subpixel_bits, area.x + area.width - 1);
    const int top = std::max((y_low + 127) >> subpixel_bits, area.y);
    const int bottom = std::min((y_high - 128) >> subpixel_bits, area.y + area.height - 1);
    if (left > right || top > bottom) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t n = (k + 1) % 3;
        const std::int64_t dx = s.x(n) - s.x(k), dy = s.y(n) - s.y(k);
        const std::int64_t px = (std::int64_t(left) << subpixel_bits) + 128, py = (std::int64_t(top) << subpixel_bits) + 128;
        const bool is_top_or_left = dy < 0 || (dy == 0 && dx > 0);  // positive area, y down
        c.edge[k] = (dx * (py - s.y(k)) - dy * (px - s.x(k)) - (is_top_or_left ? 0 : 1)) >> subpixel_bits;
        c.step_x[k] = -dy;
        c.step_y[k] = dx;
        const std::int64_t across = c.step_x[k] * (right - left), down = c.step_y[k] * (bottom - top);
        const std::int64_t lowest = c.edge[k] + std::min<std::int64_t>(across, 0) + std::min<std::int64_t>(down, 0);
        const std::int64_t highest = c.edge[k] + std::max<std::int64_t>(across, 0) + std::max<std::int64_t>(down, 0);
        if (highest < 0) return false;
        if (lowest >= 0) c.edge[k] = c.step_x[k] = c.step_y[k] = 0;
    }
    c.left = left - tile_x;
    c.right = right - tile_x;
    c.top = top - tile_y;
    c.bottom = bottom - tile_y;
    // The depth plane in float: fixed by the tile, not by the triangle's box.
    c.depth_0 = float(s.depth_0 + s.depth_x * (tile_x + 0.5) + s.depth_y * (tile_y + 0.5));
    c.depth_x = float(s.depth_x);
    c.depth_y = float(s.depth_y);
    c.depth_low = s.depth_low;
    c.depth_high = s.depth_high;
    return true;
}

/// Calls pixel(x, y, depth) for each pixel that is covered; x, y count from the tile's corner. Depth: the key of ScreenTriangle,
/// greater is nearer.
template <class Pixel>
void for_each_covered(const Coverage& c, const Pixel& pixel) {
    std::int64_t row[3] = {c.edge[0], c.edge[1], c.edge[2]};
    for (int y = c.top; y <= c.bottom; ++y) {
        std::int64_t e0 = row[0], e1 = row[1], e2 = row[2];
        const float depth_row = c.depth_0 + c.depth_y * float(y);
        for (int x = c.left; x <= c.right; ++x) {
            if ((e0 | e1 | e2) >= 0) {
                const float plane = depth_row + c.depth_x * float(x);
                // Written so that a NaN of an overflowing plane becomes the farthest corner.
                const float from_below = plane > c.depth_low ? plane : c.depth_low;
                pixel(x, y, from_below < c.depth_high ? from_below : c.depth_high);
            }
            e0 += c.step_x[0];
            e1 += c.step_x[1];
            e2 += c.step_x[2];
        }
        for (int k = 0; k < 3; ++k) row[k] += c.step_y[k];
    }
}

template <class Pixel>
void cover(const ScreenTriangle& s, const Window& area, int tile_x, int tile_y, const Pixel& pixel) {
    Coverage c;
    if (set_coverage(s, area, tile_x, tile_y, c)) for_each_covered(c, pixel);
}

}  // namespace rakelight::raster
