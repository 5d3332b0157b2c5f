// SPDX-License-Identifier: Apache-2.0
#include "fbx_smoothing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace rakelight::import_helper {
namespace {

std::uint32_t point_of(std::int32_t corner) { return std::uint32_t(corner < 0 ? -1 - corner : corner); }

/// Sets of corners that grow together.
class Sets {
public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
    std::uint32_t find(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a), b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> parent_;
};

/// One side of an edge: its points, lower first, and the corners of one polygon there.
struct Side {
    std::uint32_t low, high, at_low, at_high;
    bool operator<(const Side& b) const { return std::tie(low, high, at_low) < std::tie(b.low, b.high, b.at_low); }
};

/// Each corner of a polygon with the next one.
std::vector<Side> sides_of(const std::vector<std::int32_t>& corners) {
    std::vector<Side> sides(corners.size());
    for (std::uint32_t begin = 0, i = 0; i < corners.size(); ++i) {
        const bool is_last = corners[i] < 0;
        const std::uint32_t next = is_last ? begin : std::min<std::uint32_t>(i + 1, std::uint32_t(corners.size()) - 1);
        const std::uint32_t a = point_of(corners[i]), b = point_of(corners[next]);
        sides[i] = a < b ? Side{a, b, i, next} : Side{b, a, next, i};
        if (is_last) begin = i + 1;
    }
    return sides;
}

/// A vector for each corner. Those of two corners at one point are equal if smooth edges lead from one to the other.
std::vector<vec3> fans_of(const FbxGeometry& g) {
    std::vector<Side> sides = sides_of(g.corners);
    std::vector<bool> is_smooth(g.corners.size(), false);  // by the corner where the listed side of an edge begins
    for (std::size_t e = 0; e < g.edges.size() && e < g.smoothing.size(); ++e)
        if (g.smoothing[e] != 0 && g.edges[e] >= 0 && std::size_t(g.edges[e]) < is_smooth.size())
            is_smooth[std::size_t(g.edges[e])] = true;
    std::vector<std::uint32_t> order(sides.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return sides[a] < sides[b]; });
    Sets sets(g.corners.size());
    for (std::size_t first = 0; first < order.size();) {
        const Side& edge = sides[order[first]];
        std::size_t last = first;
        bool smooth = false;
        for (; last < order.size() && sides[order[last]].low == edge.low && sides[order[last]].high == edge.high;
             ++last)
            smooth = smooth || is_smooth[order[last]];
        for (std::size_t i = first + 1; smooth && i < last; ++i) {
            sets.join(edge.at_low, sides[order[i]].at_low);
            sets.join(edge.at_high, sides[order[i]].at_high);
        }
        first = last;
    }
    std::vector<vec3> fans(g.corners.size());
    for (std::uint32_t i = 0; i < fans.size(); ++i) {
        const std::uint32_t set = sets.find(i);
        fans[i] = {float(set & 0xFFFF), float(set >> 16), 1};
    }
    return fans;
}

}  // namespace

FbxSmoothing::FbxSmoothing(std::vector<FbxGeometry> geometries) {
    for (FbxGeometry& g : geometries) {
        Polygons polygons;
        const std::size_t points = g.points.size() / 3;
        const bool is_fine = std::ranges::all_of(g.corners, [&](std::int32_t c) { return point_of(c) < points; });
        for (const std::int32_t corner : g.corners) {
            polygons.of_corner.push_back(polygons.count);
            polygons.count += corner < 0;
        }
        const bool is_by_polygon = g.kind == FbxGeometry::Kind::by_polygon && g.smoothing.size() >= polygons.count;
        const bool is_by_edge = g.kind == FbxGeometry::Kind::by_edge && !g.edges.empty();
        if (!is_fine || g.corners.back() >= 0 || (!is_by_polygon && !is_by_edge)) {
            has_unknown_ = true;
            continue;
        }
        if (is_by_edge) polygons.fans = fans_of(g);
        geometries_.push_back(std::move(g));
        polygons_.push_back(std::move(polygons));
        add_choices(geometries_.size() - 1);
    }
}

void FbxSmoothing::add_choices(std::size_t geometry) {
    const FbxGeometry& g = geometries_[geometry];
    const Polygons& p = polygons_[geometry];
    by_count_.insert({g.corners.size(), {geometry, 0, true}});
    if (g.materials.size() < p.count) return;
    std::map<std::int32_t, std::size_t> counts;
    for (const std::uint32_t polygon : p.of_corner) ++counts[g.materials[polygon]];
    if (counts.size() < 2) return;
    for (const auto& [material, count] : counts) by_count_.insert({count, {geometry, material, false}});
}

std::vector<std::uint32_t> FbxSmoothing::corners_of(const Choice& choice) const {
    const Polygons& p = polygons_[choice.geometry];
    std::vector<std::uint32_t> corners;
    for (std::uint32_t c = 0; c < p.of_corner.size(); ++c)
        if (choice.is_all || geometries_[choice.geometry].materials[p.of_corner[c]] == choice.material)
            corners.push_back(c);
    return corners;
}

/// To the rounding of text that is read as float.
bool FbxSmoothing::lies_at(const aiMesh& mesh, std::size_t geometry, const std::vector<std::uint32_t>& corners) const {
    const FbxGeometry& g = geometries_[geometry];
    double largest = 0;
    for (const double x : g.points) largest = std::max(largest, std::isfinite(x) ? std::fabs(x) : 0);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const double* const at = g.points.data() + 3 * std::size_t(point_of(g.corners[corners[v]]));
        const aiVector3D& p = mesh.mVertices[v];
        for (const double d : {double(p.x) - at[0], double(p.y) - at[1], double(p.z) - at[2]})
            if (!(std::fabs(d) <= 1e-5 * largest)) return false;
    }
    return true;
}

MeshSmoothing FbxSmoothing::of(const aiMesh& mesh) const {
    MeshSmoothing out;
    if (mesh.HasNormals() || !mesh.HasPositions()) return out;
    const auto [first, last] = by_count_.equal_range(mesh.mNumVertices);
    for (auto choice = first; choice != last; ++choice) {
        const std::size_t number = choice->second.geometry;
        const std::vector<std::uint32_t> corners = corners_of(choice->second);
        if (!lies_at(mesh, number, corners)) continue;
        const FbxGeometry& g = geometries_[number];
        const Polygons& p = polygons_[number];
        for (const std::uint32_t c : corners)
            if (p.fans.empty())
                out.masks.push_back(std::uint32_t(g.smoothing[p.of_corner[c]]));
            else
                out.fans.push_back(p.fans[c]);
        return out;
    }
    return out;
}

}  // namespace rakelight::import_helper
