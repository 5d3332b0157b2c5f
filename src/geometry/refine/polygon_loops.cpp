// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine/polygon_loops.h"

#include <algorithm>
#include <array>

namespace rakelight::geometry {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// The boundary of some triangles: their edges without pairs of opposite direction. False: not one simple loop.
bool find_rim(std::span<const std::uint32_t> triangles, std::vector<Edge>& edges, std::vector<std::uint32_t>& rim) {
    edges.clear();
    for (std::size_t i = 0; i < triangles.size(); ++i)
        edges.push_back({triangles[i], triangles[i % 3 == 2 ? i - 2 : i + 1]});
    std::sort(edges.begin(), edges.end());
    if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
    const auto is_rim = [&](const Edge& e) {
        return !std::binary_search(edges.begin(), edges.end(), Edge{e[1], e[0]});
    };
    std::vector<Edge> outer;
    std::copy_if(edges.begin(), edges.end(), std::back_inserter(outer), is_rim);
    if (outer.size() != triangles.size() / 3 + 2) return false;
    for (std::size_t i = 0; i + 1 < outer.size(); ++i)
        if (outer[i][0] == outer[i + 1][0]) return false;
    rim.clear();
    const auto from = [&](std::uint32_t v) { return std::lower_bound(outer.begin(), outer.end(), Edge{v, 0}); };
    auto at = from(triangles[0]);
    while (rim.size() < outer.size() && at != outer.end() && (rim.empty() || (*at)[0] != rim[0])) {
        rim.push_back((*at)[0]);
        const std::uint32_t end = (*at)[1];
        at = from(end);
        if (at != outer.end() && (*at)[0] != end) return false;
    }
    return rim.size() == outer.size();
}

}  // namespace

PolygonLoops polygon_loops(std::span<const std::uint32_t> indices, std::span<const std::uint32_t> numbers) {
    PolygonLoops out;
    std::vector<Edge> edges;
    std::vector<std::uint32_t> rim;
    const auto add = [&](std::span<const std::uint32_t> corners, std::size_t first) {
        out.faces.corners.insert(out.faces.corners.end(), corners.begin(), corners.end());
        out.faces.end_face();
        out.first_triangle.push_back(std::uint32_t(first));
    };
    const std::size_t triangles = indices.size() / 3;
    for (std::size_t first = 0, end; first < triangles; first = end) {
        end = first + 1;
        while (end < triangles && !numbers.empty() && numbers[end] == numbers[first]) ++end;
        const auto part = indices.subspan(3 * first, 3 * (end - first));
        if (end - first > 1 && find_rim(part, edges, rim)) {
            add(rim, first);
            continue;
        }
        for (std::size_t t = first; t < end; ++t) add(indices.subspan(3 * t, 3), t);
    }
    out.first_triangle.push_back(std::uint32_t(triangles));
    return out;
}

}  // namespace rakelight::geometry
