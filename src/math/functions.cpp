// SPDX-License-Identifier: Apache-2.0
// SLEEF's "cinz_..._purec" forms: plain C without fused multiply-add and without CPU dispatch, so results are
// bit-identical everywhere. Sleef_sin_u10 and similar functions dispatch by CPUID and differ.
#include "math/functions.h"

#include <sleef.h>

namespace rakelight::math {

double sin(double x) { return Sleef_cinz_sind1_u10purec(x); }
double cos(double x) { return Sleef_cinz_cosd1_u10purec(x); }
double tan(double x) { return Sleef_cinz_tand1_u10purec(x); }
double acos(double x) { return Sleef_cinz_acosd1_u10purec(x); }
double atan2(double y, double x) { return Sleef_cinz_atan2d1_u10purec(y, x); }
double exp(double x) { return Sleef_cinz_expd1_u10purec(x); }
double exp2(double x) { return Sleef_cinz_exp2d1_u10purec(x); }
double log(double x) { return Sleef_cinz_logd1_u10purec(x); }
double log2(double x) { return Sleef_cinz_log2d1_u10purec(x); }
double pow(double x, double y) { return Sleef_cinz_powd1_u10purec(x, y); }

}  // namespace rakelight::math
