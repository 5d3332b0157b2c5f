// SPDX-License-Identifier: Apache-2.0
// Statistics of the samples of matched borders, over all of them or one pair of objects.
#pragma once
#include <vector>

#include <rakelight/geometry/matching_borders.h>

namespace rakelight::geometry {

/// A value with the length of border it applies to.
struct Weighted {
    double value, length;
};

/// The weighted quantile.
double weighted_quantile(std::vector<Weighted> values, double share);

/// Accumulates `samples` into the result. Open length and edges_not_searched are not changed.
void sum_up(BorderMeasure& measure);

}  // namespace rakelight::geometry
