// SPDX-License-Identifier: Apache-2.0
// How the engine finds depth: the plane of a triangle's depth keys, stepped from pixel to pixel.
#pragma once
#include "engines/raster/inspect/explanation.h"
#include "engines/raster/visibility/coverage.h"

namespace rakelight::raster {

/// [key] of the plane through the triangle's true corners at a pixel's center, in double.
inline double exact_key(const ScreenTriangle& s, int x, int y) {
    constexpr double fine = 1 << fine_bits, half = 1 << (subpixel_bits - 1);
    const double x0 = s.true_x(0), y0 = s.true_y(0), key_1 = double(s.key1) - double(s.key0),
                 key_2 = double(s.key2) - double(s.key0);
    const double x1 = s.true_x(1) - x0, y1 = s.true_y(1) - y0, x2 = s.true_x(2) - x0, y2 = s.true_y(2) - y0;
    const double px = (double(x) * (1 << subpixel_bits) + half) * fine - x0,
                 py = (double(y) * (1 << subpixel_bits) + half) * fine - y0;
    const double area = x1 * y2 - x2 * y1;  // weights of corners 1 and 2 by the parts of it
    return double(s.key0) + (key_1 * (px * y2 - x2 * py) + key_2 * (x1 * py - px * y1)) / area;
}

/// @param x,y  a pixel of the picture that the triangle covers  @param tile_x,tile_y  [px] its tile's corner
inline DepthPlane depth_plane(const ScreenTriangle& s, int x, int y, int tile_x, int tile_y) {
    Coverage c;
    DepthPlane plane;
    if (!set_coverage(s, {x, y, 1, 1}, tile_x, tile_y, c)) return plane;
    plane.x = c.plane_x + tile_x, plane.y = c.plane_y + tile_y;
    plane.key = c.depth_0, plane.slope_x = c.depth_x, plane.slope_y = c.depth_y;
    const float row = c.depth_0 + c.depth_y * float(y - plane.y);  // as for_each_covered()
    plane.by_steps = row + c.depth_x * float(x - plane.x);
    plane.exact = exact_key(s, x, y);
    return plane;
}

}  // namespace rakelight::raster
