// SPDX-License-Identifier: Apache-2.0
// Elementary functions for angles by arithmetic only, so that the attributes can be linked without SLEEF (functions.h).
// Bit-identical on all machines; error at most 2 ulps.
#pragma once

namespace rakelight::math {

double arc_tangent(double y,
                   double x);  ///< [rad] -pi..pi: of the direction (x, y); 0 for (0, 0), NaN where one is not finite
double arc_cosine(double x);   ///< [rad] 0..pi; NaN outside -1..1
double cosine(double angle);   ///< @param angle  [rad] -pi..pi

}  // namespace rakelight::math
