// SPDX-License-Identifier: Apache-2.0
// A second look at small hard bends where the strips of fillets end at round corners.
#pragma once
#include <vector>

#include "geometry/crease_rule.h"

namespace rakelight::geometry {

/// A hard edge of at most 25 degrees becomes soft if the edges beside it, at its two ends and on both sides, are soft, and
/// if on one side both bend as much as the edge itself: a strip of a round shape that ends at a corner as round. A chamfer
/// bends more, and at a flat face the edges beside it are hard.
void soften_round_corners(const BentEdges& bent, std::vector<CreaseDecision>& decisions, Context& context);

}  // namespace rakelight::geometry
