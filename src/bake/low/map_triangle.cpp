// SPDX-License-Identifier: Apache-2.0
#include "bake/low/map_triangle.h"

#include <algorithm>
#include <cmath>

namespace rakelight::bake {
namespace {

double cross2(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

bool is_before(dvec2 a, dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// Twice the signed area of a, b, p; exactly antisymmetric in a and b.
double side_of(dvec2 a, dvec2 b, dvec2 p) { return is_before(a, b) ? cross2(b - a, p - a) : -cross2(a - b, p - b); }

/// Parameter of the point on a-b nearest to p.
double nearest_share(dvec2 a, dvec2 b, dvec2 p) {
    const dvec2 way = b - a;
    const double square = dot(way, way);
    return square > 0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0;
}

/// Weights of the point on the triangle's border nearest to p.
CornerWeights nearest_weights(const dvec2 (&at)[3], dvec2 p) {
    CornerWeights best{1, 0, 0};
    double least = 1e300;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const double share = nearest_share(at[k], at[next], p);
        const dvec2 off = at[k] + (at[next] - at[k]) * share - p;
        if (dot(off, off) >= least) continue;
        least = dot(off, off);
        best = {0, 0, 0};
        best[k] = 1 - share, best[next] = share;
    }
    return best;
}

}  // namespace

double signed_area(const dvec2 (&at)[3]) { return cross2(at[1] - at[0], at[2] - at[0]); }

bool is_covered(const dvec2 (&at)[3], double turn, dvec2 p) {
    for (std::size_t k = 0; k < 3; ++k) {
        const dvec2 a = at[k], b = at[(k + 1) % 3];
        const double side = turn * side_of(a, b, p);
        if (side < 0 || (side == 0 && is_before(a, b) != (turn > 0))) return false;
    }
    return true;
}

dvec2 blend(const dvec2 (&at)[3], const CornerWeights& w) { return at[0] * w[0] + at[1] * w[1] + at[2] * w[2]; }

CornerWeights weights_at(const dvec2 (&at)[3], dvec2 p) {
    const double area = signed_area(at);
    if (area == 0) return nearest_weights(at, p);
    const CornerWeights w{cross2(at[1] - p, at[2] - p) / area, cross2(at[2] - p, at[0] - p) / area,
                          cross2(at[0] - p, at[1] - p) / area};
    return w[0] >= 0 && w[1] >= 0 && w[2] >= 0 ? w : nearest_weights(at, p);
}

Extent width_of(const MapTriangle& triangle) {
    Extent out;
    for (const dvec2 at : triangle.at) out.add(at.x);
    return out;
}

Extent height_of(const MapTriangle& triangle) {
    Extent out;
    for (const dvec2 at : triangle.at) out.add(at.y);
    return out;
}

Extent extent_between(const dvec2 (&at)[3], double low, double high) {
    Extent out;
    for (std::size_t k = 0; k < 3; ++k) {
        dvec2 a = at[k], b = at[(k + 1) % 3];
        if (a.y > b.y) std::swap(a, b);
        if (a.y > high || b.y < low) continue;
        const auto x_at = [&](double y) {
            return std::clamp(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)), std::min(a.x, b.x), std::max(a.x, b.x));
        };
        out.add(a.y >= low ? a.x : x_at(low));
        out.add(b.y <= high ? b.x : x_at(high));
    }
    return out;
}

Range places_of(const Extent& extent, int scale, int begin, int end) {
    if (extent.low > extent.high) return {begin, begin};
    return {int(std::clamp(std::floor(extent.low * scale) - 1, double(begin), double(end))),
            int(std::clamp(std::floor(extent.high * scale) + 2, double(begin), double(end)))};
}

}  // namespace rakelight::bake
