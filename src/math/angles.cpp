// SPDX-License-Identifier: Apache-2.0
// Arc tangent: by the addition theorem with the nearest of 17 tabulated angles, then Taylor's series; the rounding
// errors of the table are added at the end. Cosine: Taylor's series about the nearest multiple of pi / 2.
#include "math/angles.h"

#include <cmath>
#include <limits>

namespace rakelight::math {
namespace {

/// A number as the sum of two doubles.
struct Sum {
    double high, low;
};

constexpr int steps = 16;
constexpr Sum angles[steps + 1] = {
    // atan(k / 16), computed with 200 bits
    {0, 0},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};
constexpr Sum half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

/// Arc tangent of y / x, 0 <= y <= x, x > 0.
Sum arc_tangent_of_ratio(double y, double x) {
    const int k = int(y / x * steps + 0.5);
    const double c = double(k) / steps;
    const double t = (y - c * x) / (x + c * y), t2 = t * t;  // |t| <= 1 / 32
    double series = 0;
    for (int n = 13; n >= 3; n -= 2) series = t2 * ((n / 2 % 2 ? -1.0 : 1.0) / n + series);
    const double small = t + t * series, high = angles[k].high + small;
    return {high, angles[k].high - high + small + angles[k].low};
}

/// Sine or cosine of |x| <= pi / 4 by the terms of Taylor's series from `first` on, in Horner's form.
double series(double x, int first, int last) {
    double sum = 0;
    for (int n = last; n > first; n -= 2) sum = -x * x / (double(n) * (n - 1)) * (1 + sum);
    return (first == 0 ? 1 : x) * (1 + sum);
}

}  // namespace

double arc_tangent(double y, double x) {
    const double a = std::fabs(y), b = std::fabs(x);
    if (!(a <= std::numeric_limits<double>::max() && b <= std::numeric_limits<double>::max()))
        return std::numeric_limits<double>::quiet_NaN();
    if (a == 0 && b == 0) return 0;
    // Scales up numbers whose product with 1 / 16 would be inexact.
    const double scale = a < 1e-290 && b < 1e-290 ? 0x1p200 : b > 1e300 || a > 1e300 ? 0x1p-10 : 1;
    Sum angle = a <= b ? arc_tangent_of_ratio(a * scale, b * scale) : arc_tangent_of_ratio(b * scale, a * scale);
    if (a > b) angle = {half_pi.high - angle.high, half_pi.low - angle.low};
    if (std::signbit(x)) angle = {2 * half_pi.high - angle.high, 2 * half_pi.low - angle.low};
    const double sum = angle.high + angle.low;
    return std::signbit(y) ? -sum : sum;
}

double arc_cosine(double x) { return x == 1 ? 0 : arc_tangent(std::sqrt((1 - x) * (1 + x)), x); }

double cosine(double angle) {
    const double x = std::fabs(angle);
    const int quarter = int(x / half_pi.high + 0.5);  // 0, 1, 2
    const double rest = x - quarter * half_pi.high - quarter * half_pi.low;
    if (quarter == 1) return -series(rest, 1, 19);
    return quarter == 0 ? series(rest, 0, 20) : -series(rest, 0, 20);
}

}  // namespace rakelight::math
