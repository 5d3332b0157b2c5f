// SPDX-License-Identifier: Apache-2.0
// A second look at hard edges among soft ones: where fillets end at round corners, and in coarse curves of turned shapes.
#pragma once
#include <vector>

#include "geometry/creases/crease_rule.h"

namespace rakelight::geometry {

/// Hard edges that become soft. The edges beside an edge are the four that follow it around its ends, on both sides.
/// - At most 25 degrees: all beside it are soft, and on one side both bend as much as the edge itself. That is a strip of a
///   round shape that ends at a corner as round. A chamfer bends more, and at a flat face the edges beside it are hard.
/// - Turned shapes: all beside it are soft, and so are those at the far sides of both planes. Then it is alone in a smooth
///   surface, and up to 25 degrees this is reason enough. Up to 50 degrees, both planes must be of similar widths and bend
///   on in the same direction at their far sides by 0.3 of its bend at least: a wave of few points. Or it bends up to 25
///   degrees, by 1.5 times as much beyond one side, and back at the other: there, a wave turns.
/// Edges of which this may hold support each other, as the rings of a wave do; one that stays hard lets others drop out. But
/// the edges across a ring, and the two of a strip, must be soft in the first place: all bevels of a panel stay hard.
void soften_round_corners(const BentEdges& bent, const std::vector<PlaneSide>& widths,
                          std::vector<CreaseDecision>& decisions, Context& context);

}  // namespace rakelight::geometry
