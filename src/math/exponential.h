// SPDX-License-Identifier: Apache-2.0
// The exponential function of a number that is more exact than a double: the last step of pow.
#pragma once

#include "math/double_double.h"

namespace rakelight::math {

/// exp(x.high + x.low), rounded once, where it is subnormal too.
/// @param x  -1000..1000; |x.low| at most about an ulp of x.high
double exp_of(DoubleDouble x);

}  // namespace rakelight::math
