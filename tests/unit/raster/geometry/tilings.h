// SPDX-License-Identifier: Apache-2.0
// Random triangle meshes that tile a region of the screen without gap or overlap, in exact integers, and what pixel
// belongs to which triangle by the definition of the rule, slowly.
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace rakelight::test {

struct GridPoint {
    std::int64_t x, y;  ///< [1/256 px], y down
    friend bool operator==(const GridPoint&, const GridPoint&) = default;
};
using Tile3 = std::array<GridPoint, 3>;  ///< one triangle
using Tiling = std::vector<Tile3>;

/// Twice the signed area; positive: a, b, c turn clockwise as seen, since y is down.
inline __int128 doubled_area(GridPoint a, GridPoint b, GridPoint c) {
    return __int128(b.x - a.x) * (c.y - a.y) - __int128(c.x - a.x) * (b.y - a.y);
}

/// Whether a pixel's center belongs to a triangle: the center moved by an infinitely small step to the right, and by
/// one infinitely smaller yet downwards, lies strictly inside. Then no center lies on an edge, so a tiling has it
/// exactly once.
inline bool owns(Tile3 t, std::int64_t pixel_x, std::int64_t pixel_y) {
    if (doubled_area(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
    if (doubled_area(t[0], t[1], t[2]) == 0) return false;
    const GridPoint p{pixel_x * 256 + 128, pixel_y * 256 + 128};
    for (std::size_t k = 0; k < 3; ++k) {
        const GridPoint a = t[k], b = t[(k + 1) % 3];
        const __int128 e = doubled_area(a, b, p);
        const std::int64_t change_x = a.y - b.y, change_y = b.x - a.x;  // of e, by a step to the right or down
        if (!(e > 0 || (e == 0 && (change_x > 0 || (change_x == 0 && change_y > 0))))) return false;
    }
    return true;
}

using Random = std::mt19937;

inline std::int64_t between(Random& random, std::int64_t low, std::int64_t high) {  // both included
    const std::uint64_t number = std::uint64_t(random()) << 32 | random();
    return low + std::int64_t(number % std::uint64_t(high - low + 1));
}

inline Tiling rectangle(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
    const GridPoint a{x0, y0}, b{x1, y0}, c{x1, y1}, d{x0, y1};
    return {{a, b, c}, {a, c, d}};
}

/// p lies strictly inside of the circle through a triangle of positive area.
inline bool is_in_circle(const Tile3& t, GridPoint p) {
    __int128 m[3][3];
    for (std::size_t i = 0; i < 3; ++i) {
        const __int128 x = t[i].x - p.x, y = t[i].y - p.y;
        m[i][0] = x, m[i][1] = y, m[i][2] = x * x + y * y;
    }
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) >
           0;
}

/// The Delaunay triangulation of a rectangle's corners and points strictly inside of it (Bowyer 1981, Watson 1981).
inline Tiling delaunay(Tiling tiling, const std::vector<GridPoint>& points) {
    for (const GridPoint p : points) {
        Tiling kept, cavity;
        bool is_there = false;
        for (const Tile3& t : tiling) {
            (is_in_circle(t, p) ? cavity : kept).push_back(t);
            for (const GridPoint corner : t) is_there |= corner == p;
        }
        if (is_there) continue;
        for (const Tile3& t : cavity)
            for (std::size_t k = 0; k < 3; ++k) {
                const GridPoint a = t[k], b = t[(k + 1) % 3];
                bool is_inner = false;  // another triangle of the cavity has the edge the other way round
                for (const Tile3& o : cavity)
                    for (std::size_t i = 0; i < 3; ++i) is_inner |= o[i] == b && o[(i + 1) % 3] == a;
                if (!is_inner) kept.push_back({a, b, p});
            }
        tiling = std::move(kept);
    }
    return tiling;
}

/// Each triangle cut into three about a random point of the grid strictly inside of it, again and again: thinner and
/// thinner slivers, down to parts of a pixel.
inline Tiling subdivided(const Tiling& start, int depth, Random& random) {
    Tiling tiling;
    const std::function<void(const Tile3&, int)> split = [&](const Tile3& t, int left) {
        if (left > 0)
            for (int attempt = 0; attempt < 8; ++attempt) {
                const std::int64_t n = 1 << 20, u = between(random, 0, n), v = between(random, 0, n - u);
                const GridPoint p{t[0].x + ((t[1].x - t[0].x) * u + (t[2].x - t[0].x) * v) / n,
                                  t[0].y + ((t[1].y - t[0].y) * u + (t[2].y - t[0].y) * v) / n};
                if (!(doubled_area(t[0], t[1], p) > 0 && doubled_area(t[1], t[2], p) > 0 &&
                      doubled_area(t[2], t[0], p) > 0))
                    continue;
                for (std::size_t k = 0; k < 3; ++k) split({t[k], t[(k + 1) % 3], p}, left - 1);
                return;
            }
        tiling.push_back(t);
    };
    for (const Tile3& t : start) split(t, depth);
    return tiling;
}

/// A rectangle as a fan about a point inside, with `spokes` corners along each side: where the rectangle is much larger
/// than the screen, blades that are long, thin, and cross all of it.
inline Tiling fan(std::int64_t half_x, std::int64_t half_y, GridPoint middle, int spokes) {
    std::vector<GridPoint> rim;
    const std::int64_t grain =
        std::max<std::int64_t>(half_x >> 16, 1);  // so that corners are exact in single precision
    const auto at = [=](std::int64_t from, std::int64_t to, int i) {
        return from + (to - from) / spokes / grain * grain * i;
    };
    for (int i = 0; i < spokes; ++i) rim.push_back({at(-half_x, half_x, i), -half_y});
    for (int i = 0; i < spokes; ++i) rim.push_back({half_x, at(-half_y, half_y, i)});
    for (int i = 0; i < spokes; ++i) rim.push_back({at(half_x, -half_x, i), half_y});
    for (int i = 0; i < spokes; ++i) rim.push_back({-half_x, at(half_y, -half_y, i)});
    Tiling tiling;
    for (std::size_t i = 0; i < rim.size(); ++i) tiling.push_back({rim[i], rim[(i + 1) % rim.size()], middle});
    return tiling;
}

}  // namespace rakelight::test
