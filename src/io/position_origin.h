// SPDX-License-Identifier: Apache-2.0
// The origin of positions for models far from zero, so that floats can represent them.
#pragma once
#include <rakelight/math/vector.h>

namespace rakelight::io {

/// Zero, unless the largest error of a coordinate as a float is more than 2^-22 of the box's diagonal. That happens if
/// the model is farther from zero than about 8 times its size and its digits do not fit in a float. Then it is the
/// middle of the box, rounded to a multiple of the largest power of two that is at most a quarter of the diagonal.
/// @param low, high  of the box about all finite coordinates that are used; low > high where there are none
/// @param error      the largest |float(x) - x|
dvec3 position_origin(dvec3 low, dvec3 high, double error);

}  // namespace rakelight::io
