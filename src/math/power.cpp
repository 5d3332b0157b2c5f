// SPDX-License-Identifier: Apache-2.0
// pow: exp(y * log |x|), whose logarithm has 15 bits more than double. The other cases are those of C99, Annex F.9.4.4.
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/exponential.h"
#include "math/functions.h"
#include "math/logarithm.h"

namespace rakelight::math {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_integer(double x) { return std::fabs(x) >= 0x1p52 || x == double(std::int64_t(x)); }
bool is_odd(double x) { return std::fabs(x) < 0x1p53 && is_integer(x) && std::int64_t(x) % 2 != 0; }

/// x^y for positive finite x and finite y.
double positive_power(double x, double y) {
    const DoubleDouble logarithm = log_of(x);
    const double product = y * logarithm.high;
    if (std::fabs(product) > 800) return product > 0 ? infinity : 0;
    if (std::fabs(product) < 0x1p-60) return 1;
    const DoubleDouble exact = two_product(y, logarithm.high);
    return exp_of(fast_two_sum(exact.high, exact.low + y * logarithm.low));
}

}  // namespace

double pow(double x, double y) {
    if (y == 0 || x == 1) return 1;
    if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
    const double size = std::fabs(x);
    if (std::fabs(y) == infinity) return size == 1 ? 1 : (size > 1) == (y > 0) ? infinity : 0;
    const double sign = std::signbit(x) && is_odd(y) ? -1 : 1;
    if (size == 0 || size == infinity) return sign * ((size == 0) == (y > 0) ? 0 : infinity);
    if (x < 0 && !is_integer(y)) return std::numeric_limits<double>::quiet_NaN();
    return sign * positive_power(size, y);
}

}  // namespace rakelight::math
