// SPDX-License-Identifier: Apache-2.0
// Functions of the wide types, one text for all flavours, so that scalar == wide to the bit. No libm: it picks its
// variant by processor. exp2, log2 and pow_positive take arguments below 2^-126 as 0 and return 0 in place of denormal
// results, so their answers do not depend on whether the processor flushes denormals.
#pragma once

namespace rakelight::wide::RL_ISA {

inline real abs(real x) { return real_from_bits(bits_of(x) & integer(INT32_MAX)); }
/// Magnitude of x, sign bit of s.
inline real copy_sign(real x, real s) {
    return real_from_bits((bits_of(x) & integer(INT32_MAX)) | (bits_of(s) & integer(INT32_MIN)));
}
inline real clamp(real x, real lo, real hi) { return min(max(x, lo), hi); }
inline integer clamp(integer x, integer lo, integer hi) { return min(max(x, lo), hi); }
inline real mix(real a, real b, real t) { return a + (b - a) * t; }
inline real reciprocal(real x) { return real(1.0f) / x; }           ///< by true division
inline real safe_sqrt(real x) { return sqrt(max(x, real(0.0f))); }  ///< 0 for negative x and NaN

#if !defined(RL_WIDE_NATIVE_ROUNDING)
// From 2^23 on every float is whole. xsimd 8.1's own SSE2 floor and ceil lose the sign of zero.
inline real trunc(real x) {
    const mask has_fraction = abs(x) < real(8388608.0f);
    const real whole = copy_sign(to_real(to_int(select(has_fraction, x, real(0.0f)))), x);
    return select(has_fraction, whole, x);
}
inline real floor(real x) {
    const real t = trunc(x);
    return select(t > x, t - real(1.0f), t);
}
inline real ceil(real x) { return -floor(-x); }  // ceil(-0.3) is -0
#endif
inline real fract(real x) { return x - floor(x); }  ///< 0..1; 1 only where x is a tiny negative number
inline integer to_int_floor(real x) { return to_int(floor(x)); }

/// 2^x. Relative error under 2e-7; whole x exact; 0 for x < -126, infinity from 128 on; NaN gives 0.
/// x = n + f, f in -0.5..0.5; 2^f = 1 + f q(f) with q interpolating (2^f - 1) / f at the 6 Chebyshev nodes.
inline real exp2(real x) {
    const mask in_range = x >= real(-126.0f);
    const real c = clamp(x, real(-126.0f), real(128.0f));
    const integer n = to_int_floor(c + real(0.5f));
    const real f = c - to_real(n);
    real q = real(0.000154531634f);
    q = q * f + real(0.00133908633f);
    q = q * f + real(0.00961808302f);
    q = q * f + real(0.0555035695f);
    q = q * f + real(0.240226507f);
    q = q * f + real(0.693147182f);
    const real power_of_f = real(1.0f) + f * q;
    const integer half = n >> 1;  // two factors: 2^128 alone has no exponent bits
    const real scale_a = real_from_bits((half + integer(127)) << 23);
    const real scale_b = real_from_bits((n - half + integer(127)) << 23);
    return select(in_range, power_of_f * scale_a * scale_b, real(0.0f));
}

inline real exp(real x) { return exp2(x * real(1.44269504f)); }  ///< e^x; relative error grows with |x| to about 6e-6

/// log2(x). Relative error under 4e-7, also near x = 1. Below 2^-126, for negative x and NaN: -127; infinity counts as
/// FLT_MAX. x = m 2^e with m in sqrt(1/2)..sqrt(2), s = (m - 1) / (m + 1): log2 m = 2 / ln 2 atanh s, an odd series in
/// s.
inline real log2(real x) {
    const mask is_normal = x >= real(1.17549435e-38f);
    const integer bits = bits_of(min(select(is_normal, x, real(1.0f)), real(3.40282347e38f)));
    const integer above_root_half = bits - integer(0x3f3504f3);  // the bits of sqrt(1/2)
    const integer e = above_root_half >> 23;
    const real m = real_from_bits(bits - (e << 23));
    const real s = (m - real(1.0f)) / (m + real(1.0f));
    const real z = s * s;
    real series = real(0.431717694f);
    series = series * z + real(0.576715171f);
    series = series * z + real(0.961798847f);
    series = series * z + real(2.88539004f);
    return select(is_normal, to_real(e) + s * series, real(-127.0f));
}

/// x^y for x > 0; 0 for x <= 0 and NaN, whatever y (so pow_positive(0, 0) is 0); 1 for x = 1 and finite y.
/// For y log2 x in -20..0 the relative error is under 6e-6: the product's rounding times ln 2.
inline real pow_positive(real x, real y) {
    const mask is_positive = x >= real(1.17549435e-38f);
    return select(is_positive, exp2(y * log2(x)), real(0.0f));
}

}  // namespace rakelight::wide::RL_ISA
