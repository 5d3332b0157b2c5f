// SPDX-License-Identifier: Apache-2.0
#include "io/obj/polygon.h"

#include <algorithm>
#include <cmath>

namespace rakelight::io::obj {
namespace {

double area2(dvec2 a, dvec2 b, dvec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// Newell's normal: twice the area vector. About the first corner, so that far-away polygons keep their digits.
dvec3 newell_normal(std::span<const dvec3> p) {
    dvec3 sum;
    const dvec3 o = p[0];
    for (std::size_t i = 0; i < p.size(); ++i) {
        const dvec3 a = p[i], b = p[i + 1 < p.size() ? i + 1 : 0];
        sum.x += ((a.y - o.y) - (b.y - o.y)) * ((a.z - o.z) + (b.z - o.z));
        sum.y += ((a.z - o.z) - (b.z - o.z)) * ((a.x - o.x) + (b.x - o.x));
        sum.z += ((a.x - o.x) - (b.x - o.x)) * ((a.y - o.y) + (b.y - o.y));
    }
    return sum;
}

/// Drops the axis in which the normal is largest, such that the polygon turns counter-clockwise. Affine, hence ears
/// stay ears; no coordinate is rounded.
std::vector<dvec2> project(std::span<const dvec3> p, dvec3 n) {
    const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    std::vector<dvec2> flat(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (z >= x && z >= y)
            flat[i] = n.z > 0 ? dvec2{p[i].x, p[i].y} : dvec2{p[i].y, p[i].x};
        else if (x >= y)
            flat[i] = n.x > 0 ? dvec2{p[i].y, p[i].z} : dvec2{p[i].z, p[i].y};
        else
            flat[i] = n.y > 0 ? dvec2{p[i].z, p[i].x} : dvec2{p[i].x, p[i].z};
    }
    return flat;
}

/// All turns to the left, and once round only (a pentagram turns left all the way, twice round).
bool is_strictly_convex(std::span<const dvec2> p) {
    const std::size_t n = p.size();
    int flips = 0, last = 0, first = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const dvec2 a = p[i], b = p[(i + 1) % n], c = p[(i + 2) % n];
        if (!(area2(a, b, c) > 0)) return false;
        const int sign = b.x > a.x ? 1 : b.x < a.x ? -1 : 0;
        if (sign == 0) continue;
        if (last == 0)
            first = sign;
        else if (sign != last)
            ++flips;
        last = sign;
    }
    if (last != first) ++flips;
    return flips <= 2;
}

void fan(std::span<const std::uint32_t> corners, std::vector<std::uint32_t>& triangles) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        triangles.insert(triangles.end(), {corners[0], corners[i - 1], corners[i]});
}

/// Corners that are not convex, by cell of a grid over the polygon's box.
class BlockerGrid {
public:
    BlockerGrid(std::span<const dvec2> p, std::span<const std::uint32_t> blockers) : next_(p.size(), none_) {
        low_ = high_ = p[0];
        for (const dvec2& q : p) {
            low_ = {std::min(low_.x, q.x), std::min(low_.y, q.y)};
            high_ = {std::max(high_.x, q.x), std::max(high_.y, q.y)};
        }
        side_ = std::clamp<std::int64_t>(std::int64_t(std::sqrt(double(blockers.size()))), 1, 1024);
        head_.assign(std::size_t(side_ * side_), none_);
        for (const std::uint32_t b : blockers) {
            std::uint32_t& head = head_[std::size_t(row(p[b].y) * side_ + column(p[b].x))];
            next_[b] = head;
            head = b;
        }
    }

    /// Calls blocks(corner) for all in the box until it says true. Adds the steps taken to `work`.
    template <class Blocks>
    bool any_in(dvec2 low, dvec2 high, std::uint64_t& work, const Blocks& blocks) const {
        for (std::int64_t y = row(low.y); y <= row(high.y); ++y)
            for (std::int64_t x = column(low.x); x <= column(high.x); ++x) {
                ++work;
                for (std::uint32_t b = head_[std::size_t(y * side_ + x)]; b != none_; b = next_[b], ++work)
                    if (blocks(b)) return true;
            }
        return false;
    }

private:
    std::int64_t cell(double value, double low, double high) const {
        const double extent = high - low;
        if (!(extent > 0)) return 0;
        return std::clamp<std::int64_t>(std::int64_t((value - low) / extent * double(side_)), 0, side_ - 1);
    }
    std::int64_t column(double x) const { return cell(x, low_.x, high_.x); }
    std::int64_t row(double y) const { return cell(y, low_.y, high_.y); }

    static constexpr std::uint32_t none_ = 0xFFFFFFFFu;
    dvec2 low_, high_;
    std::int64_t side_ = 1;
    std::vector<std::uint32_t> head_, next_;
};

class EarClipper {
public:
    EarClipper(std::span<const dvec2> p, std::vector<std::uint32_t>& triangles)
        : p_(p), triangles_(triangles), links_(p.size()), blockers_(find_blockers()), grid_(p, blockers_) {}

    PolygonCut run() {
        const std::uint64_t work_limit = 1'000'000 + 4000 * std::uint64_t(p_.size());
        // A polygon with a bridge to a hole touches itself: when no ear is left, corners on an ear's border no longer
        // block it.
        while (remaining_ > 3 && work_ < work_limit) {
            for (std::uint32_t i = 0; i < links_.size(); ++i)
                if (links_[i].is_alive) consider(i);
            work_ += links_.size();
            if (head_ == queue_.size() && !touching_blocks_) break;
            if (head_ == queue_.size()) touching_blocks_ = false;
            for (; head_ < queue_.size() && remaining_ > 3 && work_ < work_limit; ++head_)
                if (links_[queue_[head_]].is_ear && links_[queue_[head_]].is_alive) clip(queue_[head_]);
        }
        const bool is_done = remaining_ <= 3;
        finish();
        return is_done ? PolygonCut::good : work_ >= work_limit ? PolygonCut::complex : PolygonCut::crossed;
    }

private:
    struct Link {
        std::uint32_t before, after;
        bool is_alive = true, is_ear = false;
    };

    std::vector<std::uint32_t> find_blockers() {
        const std::size_t n = p_.size();
        std::vector<std::uint32_t> found;
        for (std::size_t i = 0; i < n; ++i) {
            links_[i] = {std::uint32_t(i ? i - 1 : n - 1), std::uint32_t(i + 1 < n ? i + 1 : 0)};
            if (!(turn(std::uint32_t(i)) > 0)) found.push_back(std::uint32_t(i));
        }
        remaining_ = n;
        return found;
    }

    double turn(std::uint32_t i) const { return area2(p_[links_[i].before], p_[i], p_[links_[i].after]); }

    bool is_ear(std::uint32_t i) {
        ++work_;
        if (!(turn(i) > 0)) return false;
        const std::uint32_t before = links_[i].before, after = links_[i].after;
        const dvec2 a = p_[before], b = p_[i], c = p_[after];
        const dvec2 low{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
        const dvec2 high{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
        return !grid_.any_in(low, high, work_, [&](std::uint32_t k) {
            const dvec2 q = p_[k];
            if (!links_[k].is_alive || k == before || k == i || k == after || q == a || q == b || q == c) return false;
            if (turn(k) > 0) return false;  // became convex meanwhile
            const double ab = area2(a, b, q), bc = area2(b, c, q), ca = area2(c, a, q);
            return touching_blocks_ ? ab >= 0 && bc >= 0 && ca >= 0 : ab > 0 && bc > 0 && ca > 0;
        });
    }

    void consider(std::uint32_t i) {
        const bool is = is_ear(i);
        if (is) queue_.push_back(i);
        links_[i].is_ear = is;
    }

    void clip(std::uint32_t i) {
        const std::uint32_t before = links_[i].before, after = links_[i].after;
        triangles_.insert(triangles_.end(), {before, i, after});
        links_[i].is_alive = false;
        links_[before].after = after;
        links_[after].before = before;
        --remaining_;
        consider(before);
        consider(after);
    }

    void finish() {
        std::uint32_t start = 0;
        while (!links_[start].is_alive) ++start;
        std::vector<std::uint32_t> rest;
        for (std::uint32_t i = start; rest.size() < remaining_; i = links_[i].after) rest.push_back(i);
        fan(rest, triangles_);
    }

    std::span<const dvec2> p_;
    std::vector<std::uint32_t>& triangles_;
    std::vector<Link> links_;
    std::size_t remaining_ = 0, head_ = 0;
    std::vector<std::uint32_t> blockers_, queue_;
    BlockerGrid grid_;
    std::uint64_t work_ = 0;
    bool touching_blocks_ = true;
};

}  // namespace

PolygonCut triangulate(std::span<const dvec3> corners, std::vector<std::uint32_t>& triangles) {
    const auto fan_all = [&] {
        for (std::uint32_t i = 2; i < corners.size(); ++i) triangles.insert(triangles.end(), {0u, i - 1, i});
    };
    if (corners.size() == 3) {
        fan_all();
        return PolygonCut::good;
    }
    const dvec3 n = newell_normal(corners);
    const double size = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    if (!(size > 0) || !std::isfinite(size)) {
        fan_all();
        return PolygonCut::degenerate;
    }
    const std::vector<dvec2> flat = project(corners, n);
    if (is_strictly_convex(flat)) {
        fan_all();
        return PolygonCut::good;
    }
    return EarClipper(flat, triangles).run();
}

}  // namespace rakelight::io::obj
