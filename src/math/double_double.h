// SPDX-License-Identifier: Apache-2.0
// Double-double arithmetic: a number as the sum of two doubles, some 106 bits, by + - * / of double alone.
// Sources: Dekker 1971, "A Floating-Point Technique for Extending the Available Precision"; Knuth, "The Art of Computer
// Programming", volume 2, 4.2.2. Nothing here may overflow or underflow: callers scale by powers of two.
#pragma once

namespace rakelight::math {

/// high + low, where |low| is at most about an ulp of high.
struct DoubleDouble {
    double high, low;
};

/// The exact sum. |a| >= |b|, or a is 0.
inline DoubleDouble fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// The exact sum.
inline DoubleDouble two_sum(double a, double b) {
    const double sum = a + b, of_b = sum - a;
    return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// The exact product. |a| and |b| < 2^996.
inline DoubleDouble two_product(double a, double b) {
    constexpr double splitter = 0x1p27 + 1;  // halves of 26 bits, whose products are exact
    const double a_scaled = a * splitter, a_high = a_scaled - (a_scaled - a), a_low = a - a_high;
    const double b_scaled = b * splitter, b_high = b_scaled - (b_scaled - b), b_low = b - b_high;
    const double product = a * b;
    return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

/// Error at most 2^-102 of |a| + |b|.
inline DoubleDouble add(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble sum = two_sum(a.high, b.high);
    return fast_two_sum(sum.high, sum.low + (a.low + b.low));
}

/// Relative error at most 2^-101.
inline DoubleDouble multiply(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble product = two_product(a.high, b.high);
    return fast_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

/// Relative error at most 2^-100.
inline DoubleDouble divide(DoubleDouble a, DoubleDouble b) {
    const double quotient = a.high / b.high;
    const DoubleDouble back = two_product(quotient, b.high);
    const double rest = ((a.high - back.high) - back.low) + (a.low - quotient * b.low);
    return fast_two_sum(quotient, rest / b.high);
}

/// factor * x^3, whose high part is exact, at less cost than by products.
/// @param x        less than 2^10 ulps of the rounder
/// @param rounder  3/2 * 2^52 times the unit to which x is rounded first
/// @param factor   the high part has 23 bits
inline DoubleDouble scaled_cube(double x, double rounder, DoubleDouble factor) {
    const double coarse = (x + rounder) - rounder, rest = x - coarse, cube = coarse * coarse * coarse;
    const double to_whole = rest * (x * x + x * coarse + coarse * coarse);
    return {cube * factor.high, cube * factor.low + to_whole * (factor.high + factor.low)};
}

constexpr DoubleDouble half_pi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54};

}  // namespace rakelight::math
