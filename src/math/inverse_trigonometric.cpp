// SPDX-License-Identifier: Apache-2.0
// atan2 and acos: the addition theorem with the nearest of 17 tabulated angles, then Taylor's series of an angle of at
// most 1 / 32. The quotients are in double-double.
#include <cmath>
#include <limits>

#include "math/double_double.h"
#include "math/functions.h"

namespace rakelight::math {
namespace {

// atan(k / 16) (tools/make/make_function_tables.py)
constexpr DoubleDouble angles_of_sixteenths[] = {
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

DoubleDouble minus(DoubleDouble a, DoubleDouble b) { return add(a, {-b.high, -b.low}); }

/// c * x, c of few bits: the high part of x is that of half its bits, so that nothing is rounded.
DoubleDouble times_few_bits(double c, DoubleDouble x) {
    const double scaled = x.high * (0x1p27 + 1), coarse = scaled - (scaled - x.high);
    return {c * coarse, c * (x.high - coarse) + c * x.low};
}

/// Arc tangent of y / x, 0 <= y <= x, x > 0.
DoubleDouble angle_in_octant(DoubleDouble y, DoubleDouble x) {
    const int k = int(y.high / x.high * 16 + 0.5);
    const double c = k / 16.0;
    const DoubleDouble t = divide(minus(y, times_few_bits(c, x)), add(x, times_few_bits(c, y)));
    const double square = t.high * t.high;
    double series = -1.0 / 11;
    series = series * square + 1.0 / 9;
    series = series * square - 1.0 / 7;
    series = series * square + 1.0 / 5;
    series = series * square - 1.0 / 3;
    const DoubleDouble angle = angles_of_sixteenths[k], sum = fast_two_sum(angle.high, t.high);
    return fast_two_sum(sum.high, sum.low + (angle.low + t.low + t.high * square * series));
}

/// The angle of the direction (x, y), x and y >= 0, not both 0.
DoubleDouble angle_in_quadrant(DoubleDouble y, DoubleDouble x) {
    return y.high <= x.high ? angle_in_octant(y, x) : minus(half_pi, angle_in_octant(x, y));
}

double mirrored(DoubleDouble angle) { return minus({2 * half_pi.high, 2 * half_pi.low}, angle).high; }

}  // namespace

double atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
    double a = std::fabs(y), b = std::fabs(x);
    if (a == b) a = b = a == 0 ? 0 : 1;  // both may be infinite
    const bool is_steep = a > b;
    const double ratio = a == 0 ? 0 : is_steep ? b / a : a / b;
    DoubleDouble angle{ratio, 0};
    if (ratio < 0x1p-60) {
        if (is_steep) angle = minus(half_pi, angle);
    } else {
        const double larger = is_steep ? a : b, scale = larger > 0x1p500 ? 0x1p-600 : larger < 0x1p-400 ? 0x1p600 : 1;
        angle = angle_in_quadrant({a * scale, 0}, {b * scale, 0});
    }
    return std::copysign(std::signbit(x) ? mirrored(angle) : angle.high, y);
}

double acos(double x) {
    if (!(std::fabs(x) <= 1)) return std::numeric_limits<double>::quiet_NaN();
    if (std::fabs(x) == 1) return x > 0 ? 0 : 2 * half_pi.high;
    const DoubleDouble square = two_product(x, x), rest = minus({1, 0}, square);  // sine and cosine
    const double root = std::sqrt(rest.high);
    const DoubleDouble back = two_product(root, root);
    const DoubleDouble sine = fast_two_sum(root, ((rest.high - back.high) - back.low + rest.low) / (2 * root));
    const DoubleDouble angle = angle_in_quadrant(sine, {std::fabs(x), 0});
    return x < 0 ? mirrored(angle) : angle.high;
}

}  // namespace rakelight::math
