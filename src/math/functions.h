// SPDX-License-Identifier: Apache-2.0
// Elementary functions in double with bit-identical results on every processor, for setup code (cameras, lights,
// angles). libm dispatches by processor; these are SLEEF's deterministic forms (Shibata & Petrogalli 2020), 1.0 ulp.
// The wide float forms that shading uses are in the lighting preludes.
#pragma once

namespace rakelight::math {

double sin(double x);
double cos(double x);
double tan(double x);
double acos(double x);  ///< [rad] 0..pi; NaN outside -1..1
double atan2(double y, double x);
double exp(double x);
double exp2(double x);
double log(double x);
double log2(double x);
double pow(double x, double y);

}  // namespace rakelight::math
