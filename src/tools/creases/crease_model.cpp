// SPDX-License-Identifier: Apache-2.0
#include "tools/creases/crease_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "math/functions.h"
#include "math/linear.h"
#include "tools/bench/normal_shapes.h"

namespace rakelight {
namespace {

using Step = std::array<std::int64_t, 3>;

/// An edge bent less than this is not meant hard, whatever its surfaces.
constexpr double least_bend_deg = 2;

double largest_extent(const Solid& solid) {
    dvec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    for (const Solid::Polygon& polygon : solid.polygons())
        for (const dvec3& p : polygon.points) {
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
    return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

/// Rounds, welds and cuts polygons into triangles.
class Mesher {
public:
    Mesher(const Solid& solid, const Making& making) : making_(making), random_(1) {
        per_unit_ = making.bits > 0 ? double((std::int64_t(1) << making.bits) - 1) / largest_extent(solid)
                                    : std::round(math::pow(10, making.digits));
        out_.step = 1 / per_unit_, out_.is_quantized = making.bits > 0, out_.is_decidable = making.is_decidable;
    }
    void add(const Solid::Polygon& polygon) {
        std::vector<std::uint32_t> corners;
        for (const dvec3& p : polygon.points)
            if (const std::uint32_t v = vertex(p); std::ranges::find(corners, v) == corners.end()) corners.push_back(v);
        if (corners.size() == 4 && begins_at_second()) std::ranges::rotate(corners, corners.begin() + 1);
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
            out_.triangles.push_back({corners[0], corners[i], corners[i + 1]});
            out_.surfaces.push_back(polygon.surface);
        }
    }
    std::optional<std::uint32_t> find(dvec3 p) const {
        const auto at = vertices_.find(rounded(p));
        return at == vertices_.end() ? std::nullopt : std::optional(at->second);
    }
    CreaseModel& out() { return out_; }

private:
    Step rounded(dvec3 p) const {
        return {std::llround(p.x * per_unit_), std::llround(p.y * per_unit_), std::llround(p.z * per_unit_)};
    }
    std::uint32_t vertex(dvec3 p) {
        const Step at = rounded(p);
        const auto [known, is_new] = vertices_.try_emplace(at, std::uint32_t(out_.positions.size()));
        if (is_new) {
            out_.positions.push_back({double(at[0]) / per_unit_, double(at[1]) / per_unit_, double(at[2]) / per_unit_});
            out_.exact.push_back(p);
        }
        return known->second;
    }
    bool begins_at_second() {
        switch (making_.diagonals) {
            case Diagonals::second:
                return true;
            case Diagonals::alternating:
                return (count_++ & 1) != 0;
            case Diagonals::random:
                return random_.next() < 0.5;
            case Diagonals::first:
                break;
        }
        return false;
    }

    Making making_;
    Random random_;
    double per_unit_ = 1;
    std::uint32_t count_ = 0;
    std::map<Step, std::uint32_t> vertices_;
    CreaseModel out_;
};

using VertexPair = std::pair<std::uint32_t, std::uint32_t>;
VertexPair pair_of(std::uint32_t a, std::uint32_t b) { return {std::min(a, b), std::max(a, b)}; }

dvec3 doubled_area(const CreaseModel& model, std::uint32_t triangle) {
    const auto& t = model.triangles[triangle];
    return cross(model.exact[t[1]] - model.exact[t[0]], model.exact[t[2]] - model.exact[t[0]]);
}

double bend_deg(const CreaseModel& model, const ModelEdge& edge) {
    const dvec3 n = doubled_area(model, edge.triangles[0]), m = doubled_area(model, edge.triangles[1]);
    const auto& other = model.triangles[edge.triangles[1]];
    const dvec3 apex = model.exact[other[(edge.corners[1] + 2) % 3]], start = model.exact[other[edge.corners[1]]];
    const double bend = degrees(math::atan2(length(cross(n, m)), dot(n, m)));
    return dot(n, apex - start) > 0 ? -bend : bend;
}

}  // namespace

CreaseModel make_model(std::string name, const Solid& solid, const Making& making) {
    Mesher mesher(solid, making);
    for (const Solid::Polygon& polygon : solid.polygons()) mesher.add(polygon);
    std::set<VertexPair> creases;
    for (const auto& [a, b] : solid.creases())
        if (const auto from = mesher.find(a), to = mesher.find(b); from && to) creases.insert(pair_of(*from, *to));
    CreaseModel model = std::move(mesher.out());
    model.name = std::move(name);
    model.hard.assign(model.triangles.size(), 0), model.objects.assign(model.triangles.size(), 0);
    for (const ModelEdge& edge : edges_of(model)) {
        const auto& t = model.triangles[edge.triangles[0]];
        const VertexPair ends = pair_of(t[edge.corners[0]], t[(edge.corners[0] + 1) % 3]);
        const bool is_hard =
            model.surfaces[edge.triangles[0]] != model.surfaces[edge.triangles[1]] || creases.contains(ends);
        if (!is_hard || std::fabs(edge.bend_deg) < least_bend_deg) continue;
        for (std::size_t side = 0; side < 2; ++side)
            model.hard[edge.triangles[side]] |= std::uint8_t(1u << edge.corners[side]);
    }
    return model;
}

void cut_into_objects(CreaseModel& model,
                      const std::function<std::uint32_t(dvec3 middle, Surface surface)>& object_of) {
    for (std::size_t t = 0; t < model.triangles.size(); ++t) {
        const auto& v = model.triangles[t];
        model.objects[t] =
            object_of((model.exact[v[0]] + model.exact[v[1]] + model.exact[v[2]]) * (1.0 / 3), model.surfaces[t]);
    }
}

std::vector<ModelEdge> edges_of(const CreaseModel& model) {
    struct Use {
        std::uint32_t triangle, corner;
    };
    std::map<VertexPair, std::vector<Use>> uses;
    std::vector<VertexPair> order;
    for (std::uint32_t t = 0; t < model.triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const VertexPair ends = pair_of(model.triangles[t][k], model.triangles[t][(k + 1) % 3]);
            auto& known = uses[ends];
            if (known.empty()) order.push_back(ends);
            known.push_back({t, k});
        }
    std::vector<ModelEdge> out;
    for (const VertexPair& ends : order) {
        const std::vector<Use>& two = uses[ends];
        if (two.size() != 2) continue;
        ModelEdge edge{.triangles = {two[0].triangle, two[1].triangle}, .corners = {two[0].corner, two[1].corner}};
        edge.length = length(model.exact[ends.first] - model.exact[ends.second]);
        edge.bend_deg = bend_deg(model, edge);
        edge.is_hard = !model.hard.empty() && ((model.hard[edge.triangles[0]] >> edge.corners[0]) & 1) != 0;
        out.push_back(edge);
    }
    return out;
}

}  // namespace rakelight
