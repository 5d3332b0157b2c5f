// SPDX-License-Identifier: Apache-2.0
#include "geometry/points/point_spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/linear.h"

namespace rakelight::geometry {
namespace {

constexpr std::size_t max_in_group = 16;
constexpr std::size_t smallest_task = 1 << 15;

struct Box {
    vec3 low{std::numeric_limits<float>::max(), std::numeric_limits<float>::max(), std::numeric_limits<float>::max()};
    vec3 high{-low.x, -low.y, -low.z};
};

/// Point indices, sorted to the order of the tree.
class Groups {
public:
    Groups(std::span<const vec3> points, std::vector<float>& out) : points_(points), out_(out) {
        for (std::size_t i = 0; i < points.size(); ++i)
            if (is_finite(points[i])) order_.push_back(std::uint32_t(i));
    }

    void run(Context& context) {
        std::vector<std::pair<std::size_t, std::size_t>> tasks{{0, order_.size()}}, next;
        // Halves, level by level, until there is work for all threads; the tree does not depend on how many there are.
        for (bool goes_on = true; goes_on;) {
            next.assign(tasks.size() * 2, {0, 0});
            context.parallel_for(tasks.size(), [&](std::size_t t) {
                const auto [first, end] = tasks[t];
                if (end - first <= smallest_task)
                    next[2 * t] = tasks[t];
                else
                    next[2 * t] = {first, split(first, end)}, next[2 * t + 1] = {next[2 * t].second, end};
            });
            std::erase_if(next, [](const auto& range) { return range.first == range.second; });
            goes_on = next.size() > tasks.size();
            tasks.swap(next);
        }
        context.parallel_for(tasks.size(), [&](std::size_t t) { descend(tasks[t].first, tasks[t].second); });
    }

private:
    Box box_of(std::size_t first, std::size_t end) const {
        Box box;
        for (std::size_t i = first; i < end; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                const float x = points_[order_[i]][k];
                box.low[k] = std::min(box.low[k], x), box.high[k] = std::max(box.high[k], x);
            }
        return box;
    }
    static vec3 sides(const Box& box) { return box.high - box.low; }

    /// Ties are ordered by index, so that equal points are distributed to both sides.
    std::size_t split(std::size_t first, std::size_t end) {
        const vec3 s = sides(box_of(first, end));
        const std::size_t axis = s.x >= s.y && s.x >= s.z ? 0 : s.y >= s.z ? 1 : 2;
        const std::size_t middle = first + (end - first) / 2;
        const auto at = [this](std::size_t i) { return order_.begin() + std::ptrdiff_t(i); };
        std::nth_element(at(first), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
            const float x = points_[a][axis], y = points_[b][axis];
            return x < y || (x == y && a < b);
        });
        return middle;
    }

    void descend(std::size_t first, std::size_t end) {
        if (end - first > max_in_group) {
            const std::size_t middle = split(first, end);
            descend(first, middle), descend(middle, end);
            return;
        }
        const float s = spacing_of(first, end);
        for (std::size_t i = first; i < end; ++i) out_[order_[i]] = s;
    }

    float spacing_of(std::size_t first, std::size_t end) const {
        const double m = double(end - first);
        if (m < 2) return 0;
        const vec3 s = sides(box_of(first, end));
        double side[3] = {double(s.x), double(s.y), double(s.z)};
        std::sort(side, side + 3);
        const double sum = side[2] + side[1], product = side[2] * side[1];
        return float((sum + std::sqrt(sum * sum + 4 * (m - 1) * product)) / (2 * (m - 1)));
    }

    std::span<const vec3> points_;
    std::vector<float>& out_;
    std::vector<std::uint32_t> order_;
};

}  // namespace

std::vector<float> point_spacing(std::span<const vec3> points, Context& context) {
    context.memory().check(points.size() * (sizeof(float) + sizeof(std::uint32_t)), "the spacing of points");
    std::vector<float> out(points.size(), 0.0f);
    Groups(points, out).run(context);
    return out;
}

float median_spacing(std::span<const float> spacing) {
    std::vector<float> some;
    for (const float s : spacing)
        if (s > 0 && std::isfinite(s)) some.push_back(s);
    if (some.empty()) return 0;
    const auto middle = some.begin() + std::ptrdiff_t(some.size() / 2);
    std::nth_element(some.begin(), middle, some.end());
    return *middle;
}

}  // namespace rakelight::geometry
