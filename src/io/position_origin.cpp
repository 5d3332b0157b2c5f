// SPDX-License-Identifier: Apache-2.0
#include "io/position_origin.h"

#include <algorithm>
#include <cmath>

namespace rakelight::io {

dvec3 position_origin(dvec3 low, dvec3 high, double error) {
    dvec3 origin, extent;
    for (std::size_t axis = 0; axis < 3; ++axis) extent[axis] = std::max(0.0, high[axis] - low[axis]);
    const double diagonal = std::sqrt(extent.x * extent.x + extent.y * extent.y + extent.z * extent.z);
    if (!(diagonal > 0) || error <= std::ldexp(diagonal, -22)) return origin;
    int exponent = 0;
    std::frexp(diagonal, &exponent);  // diagonal is in [2^(exponent - 1), 2^exponent)
    const double unit = std::ldexp(1.0, exponent - 3);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (low[axis] <= high[axis]) origin[axis] = std::floor((low[axis] + high[axis]) / 2 / unit + 0.5) * unit;
    return origin;
}

}  // namespace rakelight::io
