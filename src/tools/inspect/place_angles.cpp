// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect/place_angles.h"

#include <rakelight/tools/inspect.h>

#include <algorithm>

#include "math/functions.h"
#include "math/linear.h"

namespace rakelight {
namespace {

double angle_deg(dvec3 a, dvec3 b) { return a == b ? 0 : degrees(math::atan2(length(cross(a, b)), dot(a, b))); }

bool is_continuous(dvec3 a, dvec3 b) {
    constexpr double sine = radians(continuous_deg);  // of so small an angle
    const dvec3 c = cross(a, b);
    return dot(c, c) <= sine * sine && dot(a, b) > 0;
}

/// Two normals and the cosine between them; none yet when it is below -1.
struct Nearest {
    double cosine = -2;
    dvec3 a, b;
    void offer(dvec3 n, dvec3 m) {
        const double c = dot(n, m);
        if (c > cosine) cosine = c, a = n, b = m;
    }
};

/// The first corner with the same normal after: the name of the group.
std::size_t group_of(std::span<const CornerNormals> corners, std::size_t i) {
    std::size_t g = 0;
    while (g < i && !is_continuous(corners[g].after, corners[i].after)) ++g;
    return g;
}

}  // namespace

PairAngle pair_angle(const PartAtPlace& a, const PartAtPlace& b) {
    Nearest before, after, worst_group;
    std::vector<Nearest> groups(a.corners.size());
    for (std::size_t i = 0; i < a.corners.size(); ++i) {
        const std::size_t group = group_of(a.corners, i);
        for (const CornerNormals& other : b.corners) {
            before.offer(a.corners[i].before, other.before);
            after.offer(a.corners[i].after, other.after);
            if (is_continuous(a.corners[i].after, other.after)) groups[group].offer(a.corners[i].before, other.before);
        }
    }
    for (const Nearest& g : groups)
        if (g.cosine >= -1.5 && (worst_group.cosine < -1.5 || g.cosine < worst_group.cosine)) worst_group = g;
    PairAngle result;
    result.joined = worst_group.cosine >= -1.5;
    if (result.joined) before = worst_group;
    result.before_deg = angle_deg(before.a, before.b);
    result.after_deg = angle_deg(after.a, after.b);
    return result;
}

std::vector<PartAtPlace> most_different(std::span<const PartAtPlace> parts, std::size_t most) {
    if (parts.size() <= most) return {parts.begin(), parts.end()};
    dvec3 sum;
    for (const PartAtPlace& p : parts) sum += p.corners[0].before;
    const dvec3 mean = normalize_or(sum, parts[0].corners[0].before);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < parts.size(); ++i) order.emplace_back(dot(parts[i].corners[0].before, mean), i);
    std::sort(order.begin(), order.end());
    order[most - 1] = order.back();
    order.resize(most);
    std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    std::vector<PartAtPlace> chosen;
    for (const auto& [cosine, i] : order) chosen.push_back(parts[i]);
    return chosen;
}

}  // namespace rakelight
