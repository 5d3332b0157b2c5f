// SPDX-License-Identifier: Apache-2.0
#include "geometry/points/point_normals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/points/point_spacing.h"
#include "math/linear.h"

namespace rakelight::geometry {
namespace {

constexpr float reach = 2.5f;  ///< in spacings
constexpr std::size_t max_neighbors = 48, min_neighbors = 4;
constexpr std::size_t max_looks = 1024;  ///< neighbors examined: a file may put any number of points into a cell
constexpr std::size_t points_per_task = 1 << 12;
constexpr double flat = 0.2;                 ///< minimum of the middle eigenvalue
constexpr std::int64_t max_cells = 1 << 20;  ///< along an axis

/// Points by cells of a cubic grid, cell after cell.
class Grid {
public:
    Grid(std::span<const vec3> points, float cell) : points_(points), cell_(cell) {
        low_ = {1e30f, 1e30f, 1e30f};
        for (const vec3& p : points)
            for (std::size_t k = 0; k < 3 && is_finite(p); ++k) low_[k] = std::min(low_[k], p[k]);
        for (std::uint32_t i = 0; i < points.size(); ++i)
            if (is_finite(points[i])) entries_.push_back({key(cell_of(points[i])), i});
        std::ranges::sort(entries_);
    }

    /// Calls f(point) for points of the 27 cells around a place, until it returns false.
    template <class F>
    void around(vec3 place, const F& f) const {
        const std::array<std::int64_t, 3> c = cell_of(place);
        for (std::int64_t z = c[2] - 1; z <= c[2] + 1; ++z)
            for (std::int64_t y = c[1] - 1; y <= c[1] + 1; ++y) {
                // Three cells in a row have consecutive keys.
                const std::uint64_t first = key({std::max<std::int64_t>(c[0] - 1, 0), y, z}),
                                    last = key({c[0] + 1, y, z});
                if (y < 0 || z < 0) continue;
                for (auto e = std::ranges::lower_bound(entries_, Entry{first, 0});
                     e != entries_.end() && e->key <= last; ++e)
                    if (!f(e->point)) return;
            }
    }

private:
    struct Entry {
        std::uint64_t key;
        std::uint32_t point;
        auto operator<=>(const Entry&) const = default;
    };
    std::array<std::int64_t, 3> cell_of(vec3 p) const {
        std::array<std::int64_t, 3> c{};
        for (std::size_t k = 0; k < 3; ++k)
            c[k] = std::int64_t(
                std::min(std::max((double(p[k]) - double(low_[k])) / double(cell_), 0.0), double(max_cells)));
        return c;
    }
    static std::uint64_t key(std::array<std::int64_t, 3> c) {
        return std::uint64_t(c[2]) << 42 | std::uint64_t(c[1]) << 21 | std::uint64_t(c[0]);
    }

    std::span<const vec3> points_;
    float cell_;
    vec3 low_;
    std::vector<Entry> entries_;
};

/// Eigenvalues, ascending, and the eigenvector of the least, of a symmetric matrix xx xy xz yy yz zz: cyclic Jacobi rotations.
struct LeastSpread {
    double values[3];
    dvec3 direction;
};
LeastSpread min_spread(const double (&s)[6]) {
    double a[3][3] = {{s[0], s[1], s[2]}, {s[1], s[3], s[4]}, {s[2], s[4], s[5]}},
           v[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int sweep = 0; sweep < 8; ++sweep)
        for (int p = 0; p < 2; ++p)
            for (int q = p + 1; q < 3; ++q) {
                if (a[p][q] == 0) continue;
                const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
                const double t = (theta >= 0 ? 1 : -1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
                const double c = 1 / std::sqrt(t * t + 1), r = t * c;
                for (int k = 0; k < 3; ++k) {
                    const double x = a[k][p], y = a[k][q];
                    a[k][p] = c * x - r * y, a[k][q] = r * x + c * y;
                }
                for (int k = 0; k < 3; ++k) {
                    const double x = a[p][k], y = a[q][k];
                    a[p][k] = c * x - r * y, a[q][k] = r * x + c * y;
                }
                for (int k = 0; k < 3; ++k) {
                    const double x = v[k][p], y = v[k][q];
                    v[k][p] = c * x - r * y, v[k][q] = r * x + c * y;
                }
            }
    const int least = a[0][0] <= a[1][1] && a[0][0] <= a[2][2] ? 0 : a[1][1] <= a[2][2] ? 1 : 2;
    LeastSpread out{{a[0][0], a[1][1], a[2][2]}, {v[0][least], v[1][least], v[2][least]}};
    std::sort(out.values, out.values + 3);
    return out;
}

/// @return the eigenvalues and direction of a point's neighborhood; all 0 where it has too few neighbors
LeastSpread spread_about(std::span<const vec3> points, std::uint32_t point, float radius, const Grid& grid) {
    std::size_t count = 0, looks = 0;
    dvec3 sum;
    double squares[6] = {};
    const vec3 center = points[point];
    grid.around(center, [&](std::uint32_t other) {
        const vec3 to = points[other] - center;
        if (++looks > max_looks) return false;
        if (!(dot(to, to) <= radius * radius)) return true;
        const dvec3 d = cast<double>(to);
        sum = sum + d;
        const double products[6] = {d.x * d.x, d.x * d.y, d.x * d.z, d.y * d.y, d.y * d.z, d.z * d.z};
        for (std::size_t k = 0; k < 6; ++k) squares[k] += products[k];
        return ++count < max_neighbors;
    });
    if (count < min_neighbors) return {};
    const double n = double(count);
    const dvec3 m = sum / n;
    const double means[6] = {m.x * m.x, m.x * m.y, m.x * m.z, m.y * m.y, m.y * m.z, m.z * m.z};
    for (std::size_t k = 0; k < 6; ++k) squares[k] = squares[k] / n - means[k];
    return min_spread(squares);
}

}  // namespace

std::vector<vec3> point_normals(std::span<const vec3> points, std::span<const float> spacing, Context& context) {
    const float median = median_spacing(spacing);
    if (!(median > 0)) return {};
    context.memory().check(points.size() * (16 + sizeof(vec3) + 1), "the normals of points");
    const Grid grid(points, reach * median);
    std::vector<vec3> normals(points.size());
    std::vector<std::uint8_t> is_flat(points.size());
    context.parallel_for((points.size() + points_per_task - 1) / points_per_task, [&](std::size_t task) {
        const std::size_t end = std::min(points.size(), (task + 1) * points_per_task);
        for (std::size_t i = task * points_per_task; i < end; ++i) {
            if (!is_finite(points[i])) continue;
            const float radius = reach * std::min(std::max(spacing[i], 0.5f * median), median);
            const LeastSpread s = spread_about(points, std::uint32_t(i), radius, grid);
            is_flat[i] = s.values[1] > 0 && s.values[0] <= flat * s.values[1];
            if (s.values[1] > 0) normals[i] = cast<float>(normalize_or(s.direction, dvec3{}));
        }
    });
    const auto flat_ones = std::ranges::count(is_flat, 1);
    return 2 * std::size_t(flat_ones) >= points.size() ? normals : std::vector<vec3>();
}

}  // namespace rakelight::geometry
