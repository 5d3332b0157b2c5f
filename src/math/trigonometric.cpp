// SPDX-License-Identifier: Apache-2.0
// sin, cos and tan: Taylor's series of the angle without its multiples of pi / 2. The first terms are in double-double,
// so what is left of the error is the last rounding and a few hundredths of an ulp.
#include <cmath>
#include <limits>

#include "math/double_double.h"
#include "math/functions.h"
#include "math/reduce_angle.h"

namespace rakelight::math {
namespace {

constexpr double rounder = 0x1.8p42;  // to multiples of 2^-10

/// |x| <= pi/4
DoubleDouble short_sine(DoubleDouble x) {
    if (std::fabs(x.high) < 0x1p-28) return x;
    constexpr DoubleDouble sixth{0x1.5555540000000p-3, 0x1.5555555555555p-27};
    const double t = x.high * x.high;
    double series = 1.0 / 355687428096000;  // 1 / 17!
    series = series * t - 1.0 / 1307674368000;
    series = series * t + 1.0 / 6227020800;
    series = series * t - 1.0 / 39916800;
    series = series * t + 1.0 / 362880;
    series = series * t - 1.0 / 5040;
    series = series * t + 1.0 / 120;
    const DoubleDouble cubic = scaled_cube(x.high, rounder, sixth), sum = fast_two_sum(x.high, -cubic.high);
    return fast_two_sum(sum.high, sum.low + (x.low * (1 - 0.5 * t) - cubic.low + t * t * x.high * series));
}

/// |x| <= pi/4
DoubleDouble short_cosine(DoubleDouble x) {
    const double t = x.high * x.high;
    double series = -1.0 / 6402373705728000;  // -1 / 18!
    series = series * t + 1.0 / 20922789888000;
    series = series * t - 1.0 / 87178291200;
    series = series * t + 1.0 / 479001600;
    series = series * t - 1.0 / 3628800;
    series = series * t + 1.0 / 40320;
    series = series * t - 1.0 / 720;
    series = series * t + 1.0 / 24;
    const double coarse = (x.high + rounder) - rounder;  // 1 - coarse^2 / 2 is exact
    const double to_whole = 0.5 * (x.high - coarse) * (x.high + coarse);
    return fast_two_sum(1 - 0.5 * coarse * coarse, t * t * series - (to_whole + x.high * x.low));
}

bool is_finite(double x) { return std::fabs(x) <= std::numeric_limits<double>::max(); }

/// sin(rest + quarter * pi / 2)
double turned_sine(DoubleDouble rest, unsigned quarter) {
    const double sine = (quarter % 2 == 0 ? short_sine(rest) : short_cosine(rest)).high;
    return quarter % 4 < 2 ? sine : -sine;
}

}  // namespace

double sin(double x) {
    if (!is_finite(x)) return std::numeric_limits<double>::quiet_NaN();
    const ReducedAngle angle = reduce_angle(x);
    return turned_sine(angle.rest, angle.quarter);
}

double cos(double x) {
    if (!is_finite(x)) return std::numeric_limits<double>::quiet_NaN();
    const ReducedAngle angle = reduce_angle(x);
    return turned_sine(angle.rest, angle.quarter + 1);
}

double tan(double x) {
    if (!is_finite(x)) return std::numeric_limits<double>::quiet_NaN();
    const ReducedAngle angle = reduce_angle(x);
    if (angle.quarter == 0 && std::fabs(x) < 0x1p-28) return x;
    const DoubleDouble sine = short_sine(angle.rest), cosine = short_cosine(angle.rest);
    return angle.quarter % 2 == 0 ? divide(sine, cosine).high : -divide(cosine, sine).high;
}

}  // namespace rakelight::math
