// SPDX-License-Identifier: Apache-2.0
// Models that stand far from zero: from where their positions count, so that floats hold them.
#pragma once
#include <rakelight/vector.h>

namespace rakelight::io {

/// Zero, unless the largest error of a coordinate as a float is more than 2^-22 of the diagonal of the box (so where the model
/// stands at more than about 8 times its size from zero, with digits that float does not hold). Then it is the middle of the box,
/// rounded to a multiple of the largest power of two that is at most a quarter of the diagonal.
/// @param low, high  of the box about all finite coordinates that are used; low > high where there are none
/// @param error      the largest |float(x) - x|
dvec3 position_origin(dvec3 low, dvec3 high, double error);

}  // namespace rakelight::io
