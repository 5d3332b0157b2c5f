// SPDX-License-Identifier: Apache-2.0
#include "tools/creases/path.h"

#include <algorithm>
#include <cmath>

#include <rakelight/base/error.h>

#include "math/functions.h"

namespace rakelight {

Path& Path::to(dvec2 point, int label) {
    const dvec2 last = points_.back();
    if (std::fabs(point.x - last.x) + std::fabs(point.y - last.y) < 1e-12) return *this;
    points_.push_back(point), labels_.push_back(label);
    return *this;
}

Path& Path::arc(dvec2 center, double radius, double from_deg, double to_deg, int steps, int label) {
    for (int i = 1; i <= steps; ++i) to(polar(center, radius, from_deg + (to_deg - from_deg) * i / steps), label);
    return *this;
}

Path& Path::close(int label) {
    labels_.push_back(label);
    return *this;
}

dvec2 polar(dvec2 center, double radius, double deg) {
    const double a = radians(deg);
    return {center.x + radius * math::cos(a), center.y + radius * math::sin(a)};
}

Path circle(dvec2 center, double radius, int steps, int label, double first_deg) {
    Path path(polar(center, radius, first_deg));
    return path.arc(center, radius, first_deg, first_deg + 360.0 * (steps - 1) / steps, steps - 1, label).close(label);
}

Path polygon(const std::vector<dvec2>& points) {
    Path path(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) path.to(points[i], int(i - 1));
    return path.close(int(points.size() - 1));
}

Path regular(int sides, double radius, double first_deg, dvec2 center) {
    return polygon(circle(center, radius, sides, 0, first_deg).points());
}

Path rectangle(double x0, double y0, double x1, double y1) { return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}); }

Path rounded_rectangle(double half_x, double half_y, double radius, int steps, bool soft) {
    const double x = half_x - radius, y = half_y - radius;
    Path path(half_x, -y);
    const dvec2 centers[] = {{x, y}, {-x, y}, {-x, -y}, {x, -y}};
    for (int k = 0; k < 4; ++k) {
        path.to(polar(centers[k], radius, 90 * k), soft ? 0 : 2 * k);
        const int steps_here = k == 3 ? steps - 1 : steps;  // the last arc ends where the path begins
        path.arc(centers[k], radius, 90 * k, 90 * (k + double(steps_here) / steps), steps_here, soft ? 0 : 2 * k + 1);
    }
    return path.close(soft ? 0 : 7);
}

namespace {

double doubled_area(dvec2 a, dvec2 b, dvec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }
double distance(dvec2 a, dvec2 b) { return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)); }
bool is_same(dvec2 a, dvec2 b) { return a.x == b.x && a.y == b.y; }

/// One loop out of several: indices of points, holes joined to the outer loop by bridges that are walked twice.
class Loops {
public:
    Loops(const std::vector<dvec2>& outer, const std::vector<std::vector<dvec2>>& holes) : points_(outer) {
        for (std::uint32_t i = 0; i < outer.size(); ++i) loop_.push_back(i);
        std::vector<std::vector<std::uint32_t>> open;
        for (const auto& hole : holes) {
            open.emplace_back();
            for (const dvec2& p : hole) open.back().push_back(std::uint32_t(points_.size())), points_.push_back(p);
            std::ranges::reverse(open.back());
        }
        while (!open.empty()) bridge(open);
    }
    std::vector<std::array<std::uint32_t, 3>> cut_ears() {
        std::vector<std::array<std::uint32_t, 3>> out;
        while (loop_.size() > 2) {
            std::size_t best = loop_.size();
            double quality = 0;
            for (std::size_t i = 0; i < loop_.size(); ++i)
                if (const double q = quality_of_ear(i); q > quality) quality = q, best = i;
            if (best == loop_.size()) throw Error(ErrorCode::failed, "a flat polygon of a model crosses itself");
            out.push_back({before(best), loop_[best], after(best)});
            loop_.erase(loop_.begin() + std::ptrdiff_t(best));
        }
        return out;
    }

private:
    std::uint32_t before(std::size_t i) const { return loop_[(i + loop_.size() - 1) % loop_.size()]; }
    std::uint32_t after(std::size_t i) const { return loop_[(i + 1) % loop_.size()]; }

    /// Height over the longest side; 0: no ear.
    double quality_of_ear(std::size_t i) const {
        const dvec2 a = points_[before(i)], b = points_[loop_[i]], c = points_[after(i)];
        const double area = doubled_area(a, b, c), longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
        if (!(area > 1e-9 * longest * longest)) return 0;
        for (const std::uint32_t v : loop_) {
            const dvec2 p = points_[v];
            if (is_same(p, a) || is_same(p, b) || is_same(p, c)) continue;
            if (doubled_area(a, b, p) > -1e-12 && doubled_area(b, c, p) > -1e-12 && doubled_area(c, a, p) > -1e-12)
                return 0;
        }
        return area / (longest * longest);
    }

    static bool cross(dvec2 a, dvec2 b, dvec2 c, dvec2 d) {
        if (is_same(a, c) || is_same(a, d) || is_same(b, c) || is_same(b, d)) return false;
        return doubled_area(a, b, c) * doubled_area(a, b, d) <= 0 && doubled_area(c, d, a) * doubled_area(c, d, b) <= 0;
    }
    bool meets(dvec2 a, dvec2 b, const std::vector<std::uint32_t>& loop) const {
        for (std::size_t i = 0; i < loop.size(); ++i)
            if (cross(a, b, points_[loop[i]], points_[loop[(i + 1) % loop.size()]])) return true;
        return false;
    }
    bool is_free(dvec2 a, dvec2 b, const std::vector<std::vector<std::uint32_t>>& open) const {
        return !meets(a, b, loop_) && std::ranges::none_of(open, [&](const auto& hole) { return meets(a, b, hole); });
    }
    /// Joins one hole by the shortest segment that meets no side.
    void bridge(std::vector<std::vector<std::uint32_t>>& open) {
        double shortest = 1e300;
        std::size_t from = 0, which = 0, to = 0;
        for (std::size_t i = 0; i < loop_.size(); ++i)
            for (std::size_t h = 0; h < open.size(); ++h)
                for (std::size_t k = 0; k < open[h].size(); ++k) {
                    const dvec2 a = points_[loop_[i]], b = points_[open[h][k]];
                    if (!(distance(a, b) < shortest) || !is_free(a, b, open)) continue;
                    shortest = distance(a, b), from = i, which = h, to = k;
                }
        if (shortest == 1e300) throw Error(ErrorCode::failed, "a hole of a model lies outside of its polygon");
        std::vector<std::uint32_t> hole = open[which];
        std::ranges::rotate(hole, hole.begin() + std::ptrdiff_t(to));
        hole.push_back(hole.front()), hole.push_back(loop_[from]);
        loop_.insert(loop_.begin() + std::ptrdiff_t(from + 1), hole.begin(), hole.end());
        open.erase(open.begin() + std::ptrdiff_t(which));
    }

    std::vector<dvec2> points_;
    std::vector<std::uint32_t> loop_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulated(const std::vector<dvec2>& outer,
                                                       const std::vector<std::vector<dvec2>>& holes) {
    return Loops(outer, holes).cut_ears();
}

}  // namespace rakelight
