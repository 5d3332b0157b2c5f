// SPDX-License-Identifier: Apache-2.0
// The logarithm with more digits than a double has: the first step of pow.
#pragma once

#include "math/double_double.h"

namespace rakelight::math {

/// The natural logarithm with a relative error of at most 2^-68.
/// @param x  positive, finite; subnormal too
DoubleDouble log_of(double x);

}  // namespace rakelight::math
