// SPDX-License-Identifier: Apache-2.0
// x * 2 / pi modulo 4 by integers. x is an integer of 53 bits times a power of two, so the bits of 2 / pi that make a
// multiple of 4 are left out, and of those after them 192 suffice: no double is nearer to a multiple of pi / 2 than
// 2^-61 (Muller, "Elementary Functions", 3rd edition, 11.2), and what is left out there is less than 2^-126.
#include "math/reduce_angle.h"

#include <bit>
#include <cstdint>

namespace rakelight::math {
namespace {

// 2 / pi in fixed point, after 64 zeros (tools/make/make_function_tables.py).
constexpr std::uint64_t two_over_pi[] = {
    0,
    0xa2f9836e4e441529,
    0xfc2757d1f534ddc0,
    0xdb6295993c439041,
    0xfe5163abdebbc561,
    0xb7246e3a424dd2e0,
    0x06492eea09d1921c,
    0xfe1deb1cb129a73e,
    0xe88235f52ebb4484,
    0xe99c7026b45f7e41,
    0x3991d639835339f4,
    0x9c845f8bbdf9283b,
    0x1ff897ffde05980f,
    0xef2f118b5a0a6d1f,
    0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b,
    0x3d0739f78a5292ea,
    0x6bfb5fb11f8d5d08,
    0x56033046fc7b6bab,
};

struct Bits128 {
    std::uint64_t high, low;
};

Bits128 product_of(std::uint64_t a, std::uint64_t b) {
    constexpr std::uint64_t half = 0xffffffff;
    const std::uint64_t low = (a & half) * (b & half), cross = (a >> 32) * (b & half) + (low >> 32);
    const std::uint64_t middle = (a & half) * (b >> 32) + (cross & half);
    return {(a >> 32) * (b >> 32) + (cross >> 32) + (middle >> 32), (middle << 32) | (low & half)};
}

/// 64 bits of two_over_pi from the given one on.
std::uint64_t bits_from(unsigned bit) {
    const unsigned word = bit / 64, shift = bit % 64;
    return shift == 0 ? two_over_pi[word] : (two_over_pi[word] << shift) | (two_over_pi[word + 1] >> (64 - shift));
}

/// |x| * 2 / pi modulo 4, in units of 2^-126.
Bits128 quarters_of(double x) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x), mantissa = (bits & 0xfffffffffffff) | 1ull << 52;
    const unsigned first = unsigned(bits >> 52 & 0x7ff) - 1013;  // of weight 2 in the product
    const Bits128 low = product_of(mantissa, bits_from(first + 128)),
                  middle = product_of(mantissa, bits_from(first + 64));
    const std::uint64_t sum = middle.low + low.high;
    return {mantissa * bits_from(first) + middle.high + (sum < low.high ? 1 : 0), sum};
}

/// -2^125 <= bits < 2^125
DoubleDouble to_double(Bits128 bits, double unit) {
    const double high = double(std::int64_t(bits.high) >> 16);
    const double middle = double((bits.high & 0xffff) << 32 | bits.low >> 32), low = double(bits.low & 0xffffffff);
    const DoubleDouble sum = fast_two_sum(high * 0x1p80, middle * 0x1p32);
    const DoubleDouble all = fast_two_sum(sum.high, sum.low + low);
    return {all.high * unit, all.low * unit};
}

}  // namespace

ReducedAngle reduce_angle(double x) {
    if (-0x1.9p-1 < x && x < 0x1.9p-1) return {0, {x, 0}};
    Bits128 quarters = quarters_of(x);
    unsigned quarter = unsigned((quarters.high + (1ull << 61)) >> 62);
    quarters.high -= std::uint64_t(quarter) << 62;
    const DoubleDouble rest = multiply(to_double(quarters, x < 0 ? -0x1p-126 : 0x1p-126), half_pi);
    return {(x < 0 ? 4 - quarter : quarter) & 3, rest};
}

}  // namespace rakelight::math
