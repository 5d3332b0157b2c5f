// SPDX-License-Identifier: Apache-2.0
#include "geometry/sums/tangent_groups.h"

#include <cmath>

#include "geometry/input/circular_order.h"
#include "geometry/input/face_vote.h"

namespace rakelight::geometry {
namespace {

constexpr double cos_45 = 0.70710678118654752440 - 1e-9;  // inclusive
constexpr double vanished_share = 1e-3;
constexpr std::size_t few = 16;

}  // namespace

void TangentGroups::join(std::span<const std::uint32_t> members, const TangentRow* rows, bool right) {
    list_.clear();
    for (std::uint32_t i = 0; i < members.size(); ++i) {
        const double hand = rows[members[i]].hand;
        if ((right ? hand > 0 : hand < 0) && direction_[i] != dvec3{}) list_.push_back(i);
    }
    const auto join_pair = [&](std::uint32_t a, std::uint32_t b) {
        if (dot(direction_[a], direction_[b]) >= cos_45) sets_.join(a, b);
    };
    if (list_.size() <= few) {
        for (std::size_t a = 0; a < list_.size(); ++a)
            for (std::size_t b = a + 1; b < list_.size(); ++b) join_pair(list_[a], list_[b]);
        return;
    }
    std::vector<dvec3> directions;
    for (const std::uint32_t i : list_) directions.push_back(direction_[i]);
    const std::vector<std::uint32_t> order = circular_order(directions);
    for (std::size_t i = 0; i < order.size(); ++i) join_pair(list_[order[i]], list_[order[(i + 1) % order.size()]]);
}

void TangentGroups::average(dvec3 normal, std::span<const std::uint32_t> members, TangentRow* rows) {
    if (normal == dvec3{}) return;
    const auto across = [&](dvec3 t) { return t - normal * dot(normal, t); };
    const std::size_t count = members.size();
    sets_.reset(count);
    direction_.resize(count);
    for (std::size_t i = 0; i < count; ++i) direction_[i] = direction_of(across(rows[members[i]].tangent)).unit;
    join(members, rows, true);
    join(members, rows, false);
    sum_.assign(count, dvec3{});
    hand_.assign(count, 0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t root = sets_.root(i);
        sum_[root] += rows[members[i]].tangent;
        hand_[root] += rows[members[i]].hand;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t root = sets_.root(i);
        if (!(length(across(sum_[root])) > vanished_share * std::fabs(hand_[root]))) continue;
        rows[members[i]].tangent = sum_[root];
        rows[members[i]].hand = hand_[root];
    }
}

}  // namespace rakelight::geometry
