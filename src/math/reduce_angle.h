// SPDX-License-Identifier: Apache-2.0
// An angle without its multiples of pi / 2.
#pragma once

#include "math/double_double.h"

namespace rakelight::math {

/// An angle as quarter * pi / 2 + rest.
struct ReducedAngle {
    unsigned quarter;   ///< 0..3, as a whole turn more or less does not matter
    DoubleDouble rest;  ///< -pi/4..pi/4, with a relative error of at most 2^-62
};

/// @param x  [rad] any finite number
/// Source: Payne & Hanek 1983, "Radian Reduction for Trigonometric Functions".
ReducedAngle reduce_angle(double x);

}  // namespace rakelight::math
