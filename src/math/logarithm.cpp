// SPDX-License-Identifier: Apache-2.0
// log and log2: x = 2^exponent * mantissa, where 45/64 <= mantissa < 45/32, and the mantissa's logarithm is that of the
// nearest sixteenth c from a table plus 2 artanh(s), s = (mantissa - c) / (mantissa + c), |s| < 1/44. c is 1 next to 1,
// and its logarithm 0, so nothing cancels there. Source: Tang 1990, "Table-Driven Implementation of the Logarithm
// Function in IEEE Floating-Point Arithmetic".
#include "math/logarithm.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/functions.h"

namespace rakelight::math {
namespace {

// log(k / 16) for k = 11..23, and ln 2, by tools/make/make_function_tables.py. The high part of ln 2 has 42 bits: its
// products with exponents are exact.
constexpr int first_sixteenth = 11;
constexpr DoubleDouble logs_of_sixteenths[] = {
    {-0x1.7fafa3bd8151cp-2, 0x1.219024acd3b77p-58},  {-0x1.269621134db92p-2, -0x1.e0efadd9db02bp-56},
    {-0x1.a93ed3c8ad9e3p-3, -0x1.bcafa9de97203p-57}, {-0x1.1178e8227e47cp-3, 0x1.0e63a5f01c691p-58},
    {-0x1.08598b59e3a07p-4, 0x1.dd7009902bf32p-58},  {0, 0},
    {0x1.f0a30c01162a6p-5, 0x1.85f325c5bbacdp-59},   {0x1.e27076e2af2e6p-4, -0x1.61578001e0162p-60},
    {0x1.5ff3070a793d4p-3, -0x1.bc60efafc6f6ep-58},  {0x1.c8ff7c79a9a22p-3, -0x1.4f689f8434012p-57},
    {0x1.1675cababa60ep-2, 0x1.ce63eab883717p-61},   {0x1.4618bc21c5ec2p-2, 0x1.f42decdeccf1dp-56},
    {0x1.739d7f6bbd007p-2, -0x1.8c76ceb014b04p-56},
};
constexpr DoubleDouble ln2_by_steps{0x1.62e42fefa3800p-1, 0x1.ef35793c76730p-45};
constexpr DoubleDouble reciprocal_ln2{0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56};

struct BinaryNumber {
    int exponent;
    double mantissa;  ///< 45/64..45/32
};

BinaryNumber binary_number(double x) {
    const bool is_subnormal = x < 0x1p-1022;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(is_subnormal ? x * 0x1p54 : x);
    const int exponent = int(bits >> 52) - 1023 - (is_subnormal ? 54 : 0);
    const double mantissa = std::bit_cast<double>((bits & 0xfffffffffffff) | 1023ull << 52);
    return mantissa < 1.40625 ? BinaryNumber{exponent, mantissa} : BinaryNumber{exponent + 1, 0.5 * mantissa};
}

/// 45/64 <= x < 45/32
DoubleDouble log_of_mantissa(double x) {
    const int k = int(x * 16 + 0.5);
    const double c = k / 16.0;
    const DoubleDouble s = divide({x - c, 0}, two_sum(x, c));
    constexpr DoubleDouble two_thirds{0x1.5555540000000p-1, 0x1.5555555555555p-25};
    constexpr double rounder = 0x1.8p37;  // to multiples of 2^-15
    const double t = s.high * s.high;
    double series = 2.0 / 13;
    series = series * t + 2.0 / 11;
    series = series * t + 2.0 / 9;
    series = series * t + 2.0 / 7;
    series = series * t + 2.0 / 5;
    const DoubleDouble cubic = scaled_cube(s.high, rounder, two_thirds), artanh = fast_two_sum(2 * s.high, cubic.high);
    const double rest = artanh.low + (2 * s.low * (1 + t) + cubic.low + t * t * s.high * series);
    return add(logs_of_sixteenths[k - first_sixteenth], {artanh.high, rest});
}

/// What log and log2 give for arguments without a logarithm: -infinity, infinity or NaN.
bool has_log(double x) { return x > 0 && x <= std::numeric_limits<double>::max(); }
double log_at_edge(double x) {
    if (x == 0) return -std::numeric_limits<double>::infinity();
    return x > 0 ? x : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

DoubleDouble log_of(double x) {
    const BinaryNumber number = binary_number(x);
    const double e = number.exponent;
    return add(fast_two_sum(e * ln2_by_steps.high, e * ln2_by_steps.low), log_of_mantissa(number.mantissa));
}

double log(double x) { return has_log(x) ? log_of(x).high : log_at_edge(x); }

double log2(double x) {
    if (!has_log(x)) return log_at_edge(x);
    const BinaryNumber number = binary_number(x);
    return add({double(number.exponent), 0}, multiply(log_of_mantissa(number.mantissa), reciprocal_ln2)).high;
}

}  // namespace rakelight::math
