// SPDX-License-Identifier: Apache-2.0
#include "bake/low/map_charts.h"

#include <algorithm>
#include <cmath>

#include "base/cancel_check.h"
#include "geometry/input/union_find.h"

namespace rakelight::bake {
namespace {

double in_range(float v) { return v > -1e5f && v < 1e5f ? double(v) : 0.0; }

/// With v down, counter-clockwise faces have negative signed area.
bool is_mirrored(const dvec2 (&p)[3]) {
    const dvec2 a = p[1] - p[0], b = p[2] - p[0];
    return a.x * b.y - a.y * b.x > 0;
}

struct Edge {
    std::uint32_t a, b, triangle;
    auto operator<=>(const Edge&) const = default;
};

}  // namespace

MapTriangle on_map(const LowSurface& surface, std::uint32_t triangle, int width, int height) {
    const std::array<vec2, 3> texcoords = surface.texcoords(triangle);
    MapTriangle out;
    dvec2 low{1e300, 1e300};
    for (std::size_t k = 0; k < 3; ++k) {
        out.at[k] = {in_range(texcoords[k].x), in_range(texcoords[k].y)};
        low = {std::min(low.x, out.at[k].x), std::min(low.y, out.at[k].y)};
    }
    out.is_mirrored = is_mirrored(out.at) != surface.is_turned(triangle);
    low = {std::floor(low.x), std::floor(low.y)};
    for (dvec2& at : out.at) at = {(at.x - low.x) * width, (at.y - low.y) * height};
    return out;
}

MapCharts find_map_charts(const LowSurface& low, Context& context) {
    const std::uint32_t count = low.triangle_count();
    context.memory().check(std::uint64_t(count) * (3 * sizeof(Edge) + 3 * 64 + 24), "charts of the map");
    const std::vector<std::uint32_t> vertices = low.map_vertices();
    std::vector<Edge> edges;
    edges.reserve(vertices.size());
    for (std::size_t c = 0; c < vertices.size(); ++c) {
        const std::uint32_t a = vertices[c], b = vertices[c % 3 == 2 ? c - 2 : c + 1];
        edges.push_back({std::min(a, b), std::max(a, b), std::uint32_t(c / 3)});
    }
    std::ranges::sort(edges);
    geometry::UnionFind pieces;
    pieces.reset(count);
    for (std::size_t i = 1; i < edges.size(); ++i)
        if (edges[i].a == edges[i - 1].a && edges[i].b == edges[i - 1].b)
            pieces.join(edges[i].triangle, edges[i - 1].triangle);
    MapCharts charts;
    charts.of_triangle.resize(count);
    std::vector<std::uint32_t> number(count, no_index);
    std::vector<std::int64_t> turn;
    CancelCheck check(context);
    for (std::uint32_t t = 0; t < count; ++t, check()) {
        std::uint32_t& chart = number[pieces.root(t)];
        if (chart == no_index) chart = std::uint32_t(turn.size()), turn.push_back(0);
        charts.of_triangle[t] = chart;
        turn[chart] += on_map(low, t, 1, 1).is_mirrored ? 1 : -1;
    }
    for (const std::int64_t t : turn) charts.is_mirrored.push_back(t > 0);
    return charts;
}

}  // namespace rakelight::bake
