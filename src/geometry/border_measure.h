// SPDX-License-Identifier: Apache-2.0
// What the samples of matched borders come to: of all of them, or of those of one pair of objects.
#pragma once
#include <vector>

#include <rakelight/matching_borders.h>

namespace rakelight::geometry {

/// A number that a piece of border of some length has.
struct Weighted {
    double value, length;
};

/// The least value that a share of all length is not above.
double weighted_quantile(std::vector<Weighted> values, double share);

/// Sums up `samples`; what was there before is added to. Open length and edges that were not searched stay.
void sum_up(BorderMeasure& measure);

}  // namespace rakelight::geometry
