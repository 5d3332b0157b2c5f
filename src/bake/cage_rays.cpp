// SPDX-License-Identifier: Apache-2.0
#include "bake/cage_rays.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rakelight::bake {
namespace {

constexpr int max_layers = 64;           ///< hits along a ray
constexpr double step_on = 1e-6;         ///< of HIGH's diagonal: offset of a continued ray
constexpr std::uint32_t probes = 65536;  ///< sample points on LOW of proposed_distance()

bool faces(const HighPoint& point, dvec3 outward) {
    return dot(point.face, outward) > 0 || dot(point.normal, outward) > 0;
}

/// The first hit along a ray that faces `outward`.
/// @param any not null: gets the first hit of all
std::optional<HighPoint> first_facing(const HighSurface& high, dvec3 from, dvec3 direction, double most, dvec3 outward,
                                      std::optional<HighPoint>* any) {
    double least = 0;
    for (int layer = 0; layer < max_layers; ++layer) {
        const auto hit = high.first(from, direction, least, most);
        if (!hit) break;
        const HighPoint point = high.point(*hit);
        if (faces(point, outward)) return point;
        if (any && !*any) *any = point;
        least = std::max(hit->t, least) + step_on * high.diagonal();
    }
    return std::nullopt;
}

}  // namespace

std::optional<CageHit> meet_from_cage(const HighSurface& high, const LowPoint& low, double distance) {
    std::optional<HighPoint> any;
    std::optional<HighPoint> found =
        first_facing(high, low.place + low.cage * distance, -low.cage, 2 * distance, low.cage, &any);
    if (!found) found = any;
    if (!found) return std::nullopt;
    return CageHit{*found, distance - found->hit.t};
}

namespace {

/// Evenly distributed points on a surface.
class SpreadPlaces {
public:
    SpreadPlaces(const LowSurface& low, Context& context)
        : low_(low), charge_(context.memory(), low.triangle_count() * sizeof(double), "areas") {
        double sum = 0;
        for (std::uint32_t t = 0; t < low.triangle_count(); ++t) {
            const LowTriangle triangle = low.triangle(t);
            const double area =
                length(cross(triangle.place[1] - triangle.place[0], triangle.place[2] - triangle.place[0]));
            upto_.push_back(sum += area < 1e300 ? area : 0);
        }
    }
    /// @param share 0..1: cumulative area of the point.
    /// @param number index of the point in its sequence
    LowPoint operator()(double share, std::uint32_t number) const {
        const auto found = std::ranges::lower_bound(upto_, share * upto_.back());
        const auto triangle = std::min(std::uint32_t(found - upto_.begin()), low_.triangle_count() - 1);
        // low-discrepancy sequence of the plastic number (Roberts 2018)
        double u = 0.5 + 0.7548776662466927 * number, v = 0.5 + 0.5698402909980532 * number;
        u -= std::floor(u), v -= std::floor(v);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        return point_of(low_.triangle(triangle), {1 - u - v, u, v});
    }

private:
    const LowSurface& low_;
    MemoryCharge charge_;
    std::vector<double> upto_;  ///< [T] cumulative twice the area
};

}  // namespace

double proposed_distance(const HighSurface& high, const LowSurface& low, Context& context) {
    const SpreadPlaces places(low, context);
    const double most = high.diagonal() / 4, none = -1;
    std::vector<double> distances(probes, none);
    context.parallel_for(probes, [&](std::size_t i) {
        const LowPoint from = places((double(i) + 0.5) / probes, std::uint32_t(i));
        const auto out = first_facing(high, from.place, from.cage, most, from.cage, nullptr),
                   in = first_facing(high, from.place, -from.cage, most, from.cage, nullptr);
        if (out) distances[i] = out->hit.t;
        if (in && (!out || in->hit.t < out->hit.t)) distances[i] = in->hit.t;
    });
    std::erase(distances, none);
    if (distances.empty()) return high.diagonal() / 100;
    std::ranges::sort(distances);
    const double needed = distances[(distances.size() - 1) * 99 / 100];
    return std::max(1.25 * needed, 1e-4 * high.diagonal());
}

}  // namespace rakelight::bake
