// SPDX-License-Identifier: Apache-2.0
// Rasterization: which pixel centers of a tile lie in a triangle, and at what depth.
#pragma once
#include <algorithm>

#include "engines/raster/geometry/front_end.h"

namespace rakelight::raster {

/// The depth keys of a triangle in one tile.
struct KeyPlane {
    int plane_x, plane_y;  ///< pixel about which they are given
    float depth_0, depth_x, depth_y;
    float depth_low, depth_high;  ///< of its corners
};

/// A triangle in one tile: which pixels may be covered, in px from the tile's corner, and what decides it. Fixed-point
/// edge functions with the top-left rule (Pineda 1988): a pixel center that lies exactly on an edge belongs to the
/// triangle whose top or left edge it is. So triangles that share an edge cover each pixel exactly once. From pixel to
/// pixel an edge function changes by multiples of 256, so only the integer part of its 256th counts: floor(e / 256) >=
/// 0 where e >= 0.
struct Coverage : KeyPlane {
    int left, top, right, bottom;                ///< inclusive
    std::int64_t edge[3], step_x[3], step_y[3];  ///< at (left, top), and its change per pixel; 0 where all pixels pass
};

/// The plane of the depth keys through the true corners, in double: its numerators are exact for small triangles,
/// whatever the order of the corners. Given about the first pixel of the triangle's box in the tile, not in the window.
inline void set_depth(const ScreenTriangle& s, int first_x, int first_y, KeyPlane& c) {
    constexpr double fine = 1 << fine_bits, pixel = 1 << (subpixel_bits + fine_bits);
    const double x0 = s.true_x(0), y0 = s.true_y(0);
    const double x1 = s.true_x(1) - x0, y1 = s.true_y(1) - y0, x2 = s.true_x(2) - x0, y2 = s.true_y(2) - y0;
    const double key_0 = s.key0, key_1 = s.key1 - key_0, key_2 = s.key2 - key_0;
    const double per_area = 1.0 / (x1 * y2 - x2 * y1);
    const double slope_x = (key_1 * y2 - key_2 * y1) * per_area, slope_y = (key_2 * x1 - key_1 * x2) * per_area;
    const double half = 1 << (subpixel_bits - 1);
    const double from_x = (double(first_x) * (1 << subpixel_bits) + half) * fine - x0,
                 from_y = (double(first_y) * (1 << subpixel_bits) + half) * fine - y0;
    c.depth_0 = float(key_0 + slope_x * from_x + slope_y * from_y);
    c.depth_x = float(slope_x * pixel);
    c.depth_y = float(slope_y * pixel);
    c.depth_low = s.farthest_key();
    c.depth_high = s.nearest_key();
}

/// set_depth() about the first pixel of the triangle's box in the tile. Also where no pixel center is covered.
inline void set_plane(const ScreenTriangle& s, int tile_x, int tile_y, KeyPlane& c) {
    c.plane_x = std::max(((std::min({s.x0, s.x1, s.x2}) + 127) >> subpixel_bits) - tile_x, 0);
    c.plane_y = std::max(((std::min({s.y0, s.y1, s.y2}) + 127) >> subpixel_bits) - tile_y, 0);
    set_depth(s, c.plane_x + tile_x, c.plane_y + tile_y, c);
}

/// The depth key that the plane has, also beyond the corners. x, y [px] from the center of the tile's first pixel.
inline float unlimited_depth_at(const KeyPlane& c, float x, float y) {
    const float depth_row = c.depth_0 + c.depth_y * (y - float(c.plane_y));
    return depth_row + c.depth_x * (x - float(c.plane_x));
}

/// The same within those of the corners.
inline float depth_at(const KeyPlane& c, float x, float y) {
    const float plane = unlimited_depth_at(c, x, y);
    const float from_below = plane > c.depth_low ? plane : c.depth_low;
    return from_below < c.depth_high ? from_below : c.depth_high;
}

/// Of every triangle what kernels/nearest_kernel.h finds for small ones.
/// @param area  pixels of the picture that count; lies in the tile
/// @return false: no pixel is covered
inline bool set_coverage(const ScreenTriangle& s, const Window& area, int tile_x, int tile_y, Coverage& c) {
    const auto [x_low, x_high] = std::minmax({s.x0, s.x1, s.x2});
    const auto [y_low, y_high] = std::minmax({s.y0, s.y1, s.y2});
    const int first_x = (x_low + 127) >> subpixel_bits, first_y = (y_low + 127) >> subpixel_bits;
    const int left = std::max(first_x, area.x);
    const int right = std::min((x_high - 128) >> subpixel_bits, area.x + area.width - 1);
    const int top = std::max(first_y, area.y);
    const int bottom = std::min((y_high - 128) >> subpixel_bits, area.y + area.height - 1);
    if (left > right || top > bottom) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t n = (k + 1) % 3;
        const std::int64_t dx = s.x(n) - s.x(k), dy = s.y(n) - s.y(k);
        const std::int64_t px = (std::int64_t(left) << subpixel_bits) + 128,
                           py = (std::int64_t(top) << subpixel_bits) + 128;
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
    set_plane(s, tile_x, tile_y, c);
    return true;
}

/// Calls pixel(x, y, depth) for each pixel that is covered; x, y count from the tile's corner. Depth: the key of ScreenTriangle,
/// greater is nearer.
template <class Pixel>
void for_each_covered(const Coverage& c, const Pixel& pixel) {
    std::int64_t row[3] = {c.edge[0], c.edge[1], c.edge[2]};
    for (int y = c.top; y <= c.bottom; ++y) {
        std::int64_t e0 = row[0], e1 = row[1], e2 = row[2];
        const float depth_row = c.depth_0 + c.depth_y * float(y - c.plane_y);
        for (int x = c.left; x <= c.right; ++x) {
            if ((e0 | e1 | e2) >= 0) {
                const float plane = depth_row + c.depth_x * float(x - c.plane_x);
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
