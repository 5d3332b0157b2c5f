// SPDX-License-Identifier: Apache-2.0
// Colors as FLIP sees them: the space that is filtered, the space that is measured, and the distance there.
#pragma once
#include <rakelight/math/vector.h>

namespace rakelight::flip {

/// YyCxCz without its factors: Y, X - Y, Y - Z, each of the white's. (Yy = 116 Y - 16, Cx = 500 (X - Y), Cz = 200 (Y - Z); filters
/// whose weights sum to 1 commute with factors and offsets.)
dvec3 opponent_from_linear(dvec3 rgb);

/// CIELab of a filtered color, which is clamped to what a display has, with Hunt's effect: a and b times 0.01 L.
dvec3 lab_of_opponent(dvec3 opponent);

/// HyAB distance to the power of 0.7, mapped to 0..1 (Andersson et al. 2020).
double color_error(dvec3 lab_a, dvec3 lab_b);

}  // namespace rakelight::flip
