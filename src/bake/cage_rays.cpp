// SPDX-License-Identifier: Apache-2.0
#include "bake/cage_rays.h"

#include <algorithm>
#include <vector>

namespace rakelight::bake {
namespace {

constexpr int most_layers = 64;          ///< that a ray goes through
constexpr double step_on = 1e-6;         ///< of HIGH's diagonal: where a ray that goes on begins
constexpr std::uint32_t probes = 16384;  ///< triangles of LOW that proposed_distance() looks from

bool faces(const HighPoint& point, dvec3 outward) {
    return dot(point.face, outward) > 0 || dot(point.normal, outward) > 0;
}

/// The first triangle along a ray that looks `outward`. @param any  not null: the first of all
std::optional<HighPoint> first_facing(const HighSurface& high, dvec3 from, dvec3 direction, double most, dvec3 outward,
                                      std::optional<HighPoint>* any) {
    double least = 0;
    for (int layer = 0; layer < most_layers; ++layer) {
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

double proposed_distance(const HighSurface& high, const LowSurface& low, Context& context) {
    const std::uint32_t count = std::min(low.triangle_count(), probes);
    constexpr CornerWeights places[4] = {
        {1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.98, 0.01, 0.01}, {0.01, 0.98, 0.01}, {0.01, 0.01, 0.98}};
    const double most = high.diagonal() / 4, none = -1;
    std::vector<double> distances(4 * std::size_t(count), none);
    context.parallel_for(count, [&](std::size_t i) {
        const auto number = std::uint32_t(std::uint64_t(i) * low.triangle_count() / count);
        const LowTriangle triangle = low.triangle(number);
        for (std::size_t k = 0; k < 4; ++k) {
            const LowPoint from = point_of(triangle, places[k]);
            const auto out = first_facing(high, from.place, from.cage, most, from.cage, nullptr),
                       in = first_facing(high, from.place, -from.cage, most, from.cage, nullptr);
            double& distance = distances[4 * i + k];
            if (out) distance = out->hit.t;
            if (in && (!out || in->hit.t < out->hit.t)) distance = in->hit.t;
        }
    });
    std::erase(distances, none);
    if (distances.empty()) return high.diagonal() / 100;
    std::ranges::sort(distances);
    const double needed = distances[(distances.size() - 1) * 99 / 100];
    return std::max(1.25 * needed, 1e-4 * high.diagonal());
}

}  // namespace rakelight::bake
