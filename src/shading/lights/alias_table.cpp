// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/alias_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/assert.h"

namespace rakelight::shading {
namespace {

constexpr double below_one = 1 - std::numeric_limits<double>::epsilon() / 2;

double positive_or_none(double weight) { return std::isfinite(weight) && weight > 0 ? weight : 0; }

}  // namespace

AliasTable::AliasTable(std::span<const double> weights) {
    const std::size_t n = weights.size();
    RL_ASSERT(n < ~std::uint32_t(0), "elements are numbered by 32 bits");
    std::size_t heaviest = 0;
    for (std::size_t i = 1; i < n; ++i)
        if (positive_or_none(weights[i]) > positive_or_none(weights[heaviest])) heaviest = i;
    if (n == 0 || positive_or_none(weights[heaviest]) == 0) return;
    std::vector<double> scaled(n);  // by the largest first, so that no sum overflows
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += scaled[i] = positive_or_none(weights[i]) / weights[heaviest];
    cells_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        cells_[i].probability = float(scaled[i] / sum);
        scaled[i] *= double(n) / sum;
    }
    share_out(scaled);
}

/// @param scaled  weights whose mean is 1
void AliasTable::share_out(std::vector<double>& scaled) {
    const auto n = std::uint32_t(scaled.size());
    std::vector<std::uint32_t> order(n);  // small ones grow from the front, large ones from the back
    std::uint32_t small = 0, large = n;
    for (std::uint32_t i = 0; i < n; ++i) order[scaled[i] < 1 ? small++ : --large] = i;
    while (small > 0 && large < n) {
        const std::uint32_t less = order[--small], more = order[large];
        cells_[less].own = float(scaled[less]);
        cells_[less].other = more;
        scaled[more] = (scaled[more] + scaled[less]) - 1;  // Vose: it rounds less than in the other order
        if (scaled[more] >= 1) continue;
        ++large;
        order[small++] = more;
    }
    // What is left would be 1 without rounding: by far not an element of weight 0.
    while (large < n) cells_[order[large++]].own = 1;
    while (small > 0) cells_[order[--small]].own = 1;
}

AliasTable::Sample AliasTable::sample(double u) const noexcept {
    RL_ASSERT(!cells_.empty(), "there is nothing to choose from");
    const double place = u * double(cells_.size());
    const auto i = std::uint32_t(std::clamp(place, 0.0, double(cells_.size() - 1)));
    const double within = std::clamp(place - i, 0.0, below_one), own = double(cells_[i].own);
    if (within < own) return {i, cells_[i].probability, std::min(within / own, below_one)};
    const std::uint32_t other = cells_[i].other;
    return {other, cells_[other].probability, std::min((within - own) / (1 - own), below_one)};
}

}  // namespace rakelight::shading
