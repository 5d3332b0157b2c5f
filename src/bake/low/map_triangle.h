// SPDX-License-Identifier: Apache-2.0
// Triangles on the map [px]: samples that they cover, nearest points, and the columns of a row that they may touch.
#pragma once
#include <algorithm>

#include "bake/low/map_charts.h"

namespace rakelight::bake {

/// Twice the area.
double signed_area(const dvec2 (&at)[3]);

/// Whether a point lies inside. A point on an edge lies inside of exactly one of the two triangles at the edge.
/// @param turn  +1 or -1: the sign of the triangle's area
bool is_covered(const dvec2 (&at)[3], double turn, dvec2 p);

/// Weights at p, or at the nearest point of the triangle.
CornerWeights weights_at(const dvec2 (&at)[3], dvec2 p);

dvec2 blend(const dvec2 (&at)[3], const CornerWeights& w);

/// Bounds along an axis; low > high: empty.
struct Extent {
    double low = 1e300, high = -1e300;
    void add(double x) { low = std::min(low, x), high = std::max(high, x); }
};

Extent width_of(const MapTriangle& triangle);
Extent height_of(const MapTriangle& triangle);
/// The bounds in x of the part of a triangle with y from `low` to `high`.
Extent extent_between(const dvec2 (&at)[3], double low, double high);

/// Integers from low to high - 1.
struct Range {
    int low, high;
};

/// The places that an extent touches, and one more on each side, of `scale` places per pixel from `begin` to `end` - 1.
Range places_of(const Extent& extent, int scale, int begin, int end);

}  // namespace rakelight::bake
