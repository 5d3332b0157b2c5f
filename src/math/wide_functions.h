// SPDX-License-Identifier: Apache-2.0
// Functions of the wide types, one source for all flavors, so scalar and wide are bit-identical. No libm, which
// dispatches by processor. exp2, log2 and pow_positive treat arguments below 2^-126 as 0 and return 0 instead of
// denormals, so results do not depend on flushing of denormals.
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
// From 2^23 on every float is an integer. floor and ceil of xsimd 8.1 for SSE2 lose the sign of zero.
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
    const real f2 = f * f;
    const real q01 = real(0.693147182f) + real(0.240226507f) * f, q23 = real(0.0555035695f) + real(0.00961808302f) * f;
    const real q45 = real(0.00133908633f) + real(0.000154531634f) * f;
    const real q = q01 + f2 * (q23 + f2 * q45);
    const real power_of_f = real(1.0f) + f * q;
    const integer half = n >> 1;  // two factors: 2^128 alone has no exponent bits
    const real scale_a = real_from_bits((half + integer(127)) << 23);
    const real scale_b = real_from_bits((n - half + integer(127)) << 23);
    return select(in_range, power_of_f * scale_a * scale_b, real(0.0f));
}

inline real exp(real x) { return exp2(x * real(1.44269504f)); }  ///< e^x; relative error grows with |x| to about 6e-6

/// log2(x). Relative error under 3e-7, also near x = 1. Below 2^-126, for negative x and NaN: -127; infinity counts as
/// FLT_MAX. x = m 2^e with m in sqrt(1/2)..sqrt(2): log2 m = f q(f), f = m - 1, q at the 9 Chebyshev nodes: no
/// division.
inline real log2(real x) {
    const mask is_normal = x >= real(1.17549435e-38f);
    const integer bits = bits_of(min(select(is_normal, x, real(1.0f)), real(3.40282347e38f)));
    const integer above_root_half = bits - integer(0x3f3504f3);  // the bits of sqrt(1/2)
    const integer e = above_root_half >> 23;
    const real f = real_from_bits(bits - (e << 23)) - real(1.0f);
    // Estrin's scheme (1960): Horner's dependency chain would take twice as long.
    const real f2 = f * f, f4 = f2 * f2;
    const real q01 = real(1.442695f) - real(0.721347468f) * f, q23 = real(0.480910753f) - real(0.360693268f) * f;
    const real q45 = real(0.287903261f) - real(0.239169881f) * f, q67 = real(0.216078225f) - real(0.205861881f) * f;
    const real q = (q01 + q23 * f2) + f4 * ((q45 + q67 * f2) + f4 * real(0.123109685f));
    return select(is_normal, to_real(e) + f * q, real(-127.0f));
}

/// log2(x) for levels of detail, x >= 0: error under 4e-4, exact and without a step at powers of two, growing
/// everywhere; below 2^-126 something under -126, for infinity and NaN something over 127. x = m 2^e with m in 1..2:
/// log2 m = f + f (1 - f) q(f), f = m - 1, q at the 3 Chebyshev nodes.
inline real log2_coarse(real x) {
    const integer bits = bits_of(x);
    const real e = to_real((bits >> 23) - integer(127));
    const real f = real_from_bits((bits & integer(0x007fffff)) | integer(0x3f800000)) - real(1.0f);
    const real q = (real(0.0816157439f) * f - real(0.242669458f)) * f + real(0.440780796f);
    return e + (f + f * (real(1.0f) - f) * q);
}

/// x^y for x > 0; 0 for x <= 0 and NaN, for any y (so pow_positive(0, 0) is 0); 1 for x = 1 and finite y. For y log2 x
/// in -20..0 the relative error is under 6e-6: the product's rounding times ln 2.
inline real pow_positive(real x, real y) {
    const mask is_positive = x >= real(1.17549435e-38f);
    return select(is_positive, exp2(y * log2(x)), real(0.0f));
}

}  // namespace rakelight::wide::RL_ISA
