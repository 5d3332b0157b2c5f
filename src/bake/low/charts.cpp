// SPDX-License-Identifier: Apache-2.0
#include "bake/low/charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/cancel_check.h"
#include "geometry/input/union_find.h"
#include "math/linear.h"

namespace rakelight::bake {
namespace {

/// The axis with the largest component of the normal; the first of equal ones. Triangles without area face +x.
std::uint8_t axis_of(dvec3 n) {
    const double size[3] = {std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
        if (size[k] > size[axis]) axis = k;
    return std::uint8_t(2 * axis + (n[axis] < 0));
}

/// An edge of a triangle, with the lower vertex first.
struct Edge {
    std::uint32_t a, b, triangle;
    auto operator<=>(const Edge&) const = default;
};

std::vector<Edge> sorted_edges(std::span<const std::uint32_t> triangles) {
    std::vector<Edge> edges;
    edges.reserve(triangles.size());
    for (std::size_t c = 0; c < triangles.size(); ++c) {
        const std::uint32_t a = triangles[c], b = triangles[c % 3 == 2 ? c - 2 : c + 1];
        edges.push_back({std::min(a, b), std::max(a, b), std::uint32_t(c / 3)});
    }
    std::ranges::sort(edges);
    return edges;
}

}  // namespace

dvec2 flattened(dvec3 p, std::uint8_t axis) {
    switch (axis) {
        case 0:
            return {-p.z, -p.y};
        case 1:
            return {p.z, -p.y};
        case 2:
            return {p.x, p.z};
        case 3:
            return {p.x, -p.z};
        case 4:
            return {p.x, -p.y};
        default:
            return {-p.x, -p.y};
    }
}

Charts find_charts(std::span<const dvec3> places, std::span<const std::uint32_t> triangles, Context& context) {
    const std::size_t count = triangles.size() / 3;
    context.memory().check(triangles.size() * sizeof(Edge) + count * 16, "charts");
    std::vector<std::uint8_t> axes(count);
    CancelCheck check(context);
    for (std::size_t t = 0; t < count; ++t, check()) {
        const dvec3 a = places[triangles[3 * t]], b = places[triangles[3 * t + 1]], c = places[triangles[3 * t + 2]];
        axes[t] = axis_of(cross(b - a, c - a));
    }
    geometry::UnionFind pieces;
    pieces.reset(count);
    const std::vector<Edge> edges = sorted_edges(triangles);
    for (std::size_t i = 1; i < edges.size(); ++i, check()) {
        const Edge &one = edges[i - 1], &other = edges[i];
        if (one.a == other.a && one.b == other.b && axes[one.triangle] == axes[other.triangle])
            pieces.join(one.triangle, other.triangle);
    }
    Charts charts;
    charts.of_triangle.resize(count);
    std::vector<std::uint32_t> number(count, ~0u);  // index of the piece of a triangle
    for (std::size_t t = 0; t < count; ++t, check()) {
        std::uint32_t& chart = number[pieces.root(std::uint32_t(t))];
        if (chart == ~0u) {
            chart = std::uint32_t(charts.axis.size());
            charts.axis.push_back(axes[t]);
            charts.low.push_back({1e300, 1e300}), charts.high.push_back({-1e300, -1e300});
        }
        charts.of_triangle[t] = chart;
        for (std::size_t k = 0; k < 3; ++k) {
            const dvec2 at = flattened(places[triangles[3 * t + k]], axes[t]);
            dvec2 &low = charts.low[chart], &high = charts.high[chart];
            low = {std::min(low.x, at.x), std::min(low.y, at.y)};
            high = {std::max(high.x, at.x), std::max(high.y, at.y)};
        }
    }
    return charts;
}

}  // namespace rakelight::bake
