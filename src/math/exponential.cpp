// SPDX-License-Identifier: Apache-2.0
// exp and exp2: a power of two, one of 16 tabulated powers of the 16th root of 2 (in double-double), and Taylor's
// series of exp(r), |r| <= ln 2 / 32. Source: Tang 1989, "Table-Driven Implementation of the Exponential Function in
// IEEE Floating-Point Arithmetic".
#include "math/exponential.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/functions.h"

namespace rakelight::math {
namespace {

// 2^(k / 16), and ln 2, by tools/make/make_function_tables.py. The high part of ln 2 / 16 has 37 bits: its products
// with integers of 15 bits are exact.
constexpr DoubleDouble powers_of_root[] = {
    {0x1.0000000000000p+0, 0},
    {0x1.0b5586cf9890fp+0, 0x1.8a62e4adc610bp-54},
    {0x1.172b83c7d517bp+0, -0x1.19041b9d78a76p-55},
    {0x1.2387a6e756238p+0, 0x1.9b07eb6c70573p-54},
    {0x1.306fe0a31b715p+0, 0x1.6f46ad23182e4p-55},
    {0x1.3dea64c123422p+0, 0x1.ada0911f09ebcp-55},
    {0x1.4bfdad5362a27p+0, 0x1.d4397afec42e2p-56},
    {0x1.5ab07dd485429p+0, 0x1.6324c054647adp-54},
    {0x1.6a09e667f3bcdp+0, -0x1.bdd3413b26456p-54},
    {0x1.7a11473eb0187p+0, -0x1.41577ee04992fp-55},
    {0x1.8ace5422aa0dbp+0, 0x1.6e9f156864b27p-54},
    {0x1.9c49182a3f090p+0, 0x1.c7c46b071f2bep-56},
    {0x1.ae89f995ad3adp+0, 0x1.7a1cd345dcc81p-54},
    {0x1.c199bdd85529cp+0, 0x1.11065895048ddp-55},
    {0x1.d5818dcfba487p+0, 0x1.2ed02d75b3707p-55},
    {0x1.ea4afa2a490dap+0, -0x1.e9c23179c2893p-54},
};
constexpr DoubleDouble sixteenth_ln2{0x1.62e42fefa0000p-5, 0x1.cf79abc9e3b3ap-44};
constexpr DoubleDouble ln2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

double power_of_two(int exponent) { return std::bit_cast<double>(std::uint64_t(exponent + 1023) << 52); }

int nearest_integer(double x) { return int(x < 0 ? x - 0.5 : x + 0.5); }

/// x * 2^exponent, rounded once. 1/2 <= x.high < 4, -1078 <= exponent <= 1025
double scale(DoubleDouble x, int exponent) {
    if (exponent > -1022 || (exponent == -1022 && x.high >= 1)) {
        const int half = exponent / 2;  // 2^1024 is no double
        return (x.high + x.low) * power_of_two(half) * power_of_two(exponent - half);
    }
    // The result is subnormal: adding a number whose ulp becomes the least subnormal rounds x there.
    const double rounder = power_of_two(-1022 - exponent);
    const DoubleDouble sum = two_sum(rounder, x.high);
    return (sum.high + (sum.low + x.low) - rounder) * power_of_two(-1022) * power_of_two(exponent + 1022);
}

/// 2^(sixteenths / 16) * exp(r), |r| <= ln 2 / 32
double scaled_exp(int sixteenths, DoubleDouble r) {
    const double t = r.high;
    double series = 1.0 / 5040;
    series = series * t + 1.0 / 720;
    series = series * t + 1.0 / 120;
    series = series * t + 1.0 / 24;
    series = series * t + 1.0 / 6;
    series = series * t + 1.0 / 2;
    const double rest = t + (r.low + t * t * series);
    const DoubleDouble power = powers_of_root[sixteenths & 15];
    return scale(fast_two_sum(power.high, power.low + power.high * rest), sixteenths >> 4);
}

}  // namespace

double exp_of(DoubleDouble x) {
    if (x.high > 710) return std::numeric_limits<double>::infinity();
    if (x.high < -746) return 0;
    const int n = nearest_integer(x.high / sixteenth_ln2.high);
    const double rest = x.high - n * sixteenth_ln2.high;
    return scaled_exp(n, two_sum(rest, x.low - n * sixteenth_ln2.low));
}

double exp(double x) {
    if (std::isnan(x)) return x;
    return exp_of({x, 0});
}

double exp2(double x) {
    if (std::isnan(x)) return x;
    if (x >= 1024) return std::numeric_limits<double>::infinity();
    if (x < -1076) return 0;
    const int n = nearest_integer(x * 16);
    const double rest = x - n / 16.0;
    const DoubleDouble product = two_product(rest, ln2.high);
    return scaled_exp(n, {product.high, product.low + rest * ln2.low});
}

}  // namespace rakelight::math
