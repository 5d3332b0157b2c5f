// SPDX-License-Identifier: Apache-2.0
// Elementary functions in double with the same bits on every processor: by + - * / of double, sqrt and integers alone,
// as libm chooses its code by processor. For every argument the error is at most 1 ulp; measured against MPFR it is
// below 0.6 ulp, and 0.5 ulp is the rounding itself (tests/unit/math/exact_functions_test.cpp). Zeros, infinities and
// NaN are those of C99, Annex F. The wide float forms that shading uses are in the lighting preludes.
// Sources: Payne & Hanek 1983 (reduce_angle.h), Tang 1989 and 1990 (exponential.cpp, logarithm.cpp), Dekker 1971
// (double_double.h).
#pragma once

namespace rakelight::math {

double sin(double x);              ///< @param x  [rad] any; NaN for infinity
double cos(double x);              ///< @param x  [rad] any; NaN for infinity
double tan(double x);              ///< @param x  [rad] any; NaN for infinity
double acos(double x);             ///< [rad] 0..pi; NaN outside -1..1
double atan2(double y, double x);  ///< [rad] -pi..pi, of the direction (x, y); pi with the sign of y for x = -0, y = 0
double exp(double x);
double exp2(double x);  ///< exact for integers
double log(double x);   ///< -infinity for 0, NaN below
double log2(double x);  ///< exact for powers of two; -infinity for 0, NaN below
double pow(double x, double y);

}  // namespace rakelight::math
