// SPDX-License-Identifier: Apache-2.0
#include "math/functions.h"
#include "math/linear.h"

namespace rakelight {

dmat4 perspective(double vertical_fov_rad, double aspect, double near, double far) {
    const double half = vertical_fov_rad / 2;
    const double f = math::cos(half) / math::sin(half);
    // Written with near / far, so that an infinite far plane is no special case: its ratio is 0.
    const double ratio = near / far;
    return {{{f / aspect, 0, 0, 0},
             {0, f, 0, 0},
             {0, 0, -(1 + ratio) / (1 - ratio), -1},
             {0, 0, -2 * near / (1 - ratio), 0}}};
}

}  // namespace rakelight
