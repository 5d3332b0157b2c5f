// SPDX-License-Identifier: Apache-2.0
// SIMD type of `lanes` doubles in two halves. Few functions, for setup code that needs double; bit-identical in every
// flavor. Only for sources compiled per instruction set.
#pragma once
#include "math/wide.h"

namespace rakelight::wide::RL_ISA {

#if defined(RL_ISA_scalar)

using real_double = double;
inline real_double to_double(float x) { return x; }
inline real_double to_double(int32_t x) { return x; }
inline real to_real(real_double x) { return real(x); }
inline integer to_int(real_double x) { return int32_t(x); }  ///< truncates; x must fit
inline real_double min(real_double a, real_double b) { return a < b ? a : b; }
inline real_double max(real_double a, real_double b) { return a > b ? a : b; }

#else

using DoubleBatch = xsimd::batch<double, arch>;

struct real_double {
    DoubleBatch low, high;  ///< lanes 0..lanes / 2 - 1, and the rest
    real_double() = default;
    real_double(double s) : low(s), high(s) {}
    real_double(DoubleBatch l, DoubleBatch h) : low(l), high(h) {}
};

inline real_double operator+(real_double a, real_double b) { return {a.low + b.low, a.high + b.high}; }
inline real_double operator-(real_double a, real_double b) { return {a.low - b.low, a.high - b.high}; }
inline real_double operator*(real_double a, real_double b) { return {a.low * b.low, a.high * b.high}; }
inline real_double operator/(real_double a, real_double b) { return {a.low / b.low, a.high / b.high}; }
/// a < b ? a : b and a > b ? a : b, as those of `real`.
inline real_double min(real_double a, real_double b) { return {xsimd::min(a.low, b.low), xsimd::min(a.high, b.high)}; }
inline real_double max(real_double a, real_double b) { return {xsimd::max(a.low, b.low), xsimd::max(a.high, b.high)}; }

#if defined(RL_ISA_avx512)
inline real_double to_double(real x) {
    const __m256 low = _mm512_castps512_ps256(x.v), high = _mm512_extractf32x8_ps(x.v, 1);
    return {DoubleBatch(_mm512_cvtps_pd(low)), DoubleBatch(_mm512_cvtps_pd(high))};
}
inline real_double to_double(integer x) {
    const __m256i low = _mm512_castsi512_si256(x.v), high = _mm512_extracti32x8_epi32(x.v, 1);
    return {DoubleBatch(_mm512_cvtepi32_pd(low)), DoubleBatch(_mm512_cvtepi32_pd(high))};
}
inline real to_real(real_double x) {
    return real(
        RealBatch(_mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps(x.low)), _mm512_cvtpd_ps(x.high), 1)));
}
inline integer to_int(real_double x) {
    return integer(IntegerBatch(
        _mm512_inserti32x8(_mm512_castsi256_si512(_mm512_cvttpd_epi32(x.low)), _mm512_cvttpd_epi32(x.high), 1)));
}
#elif defined(RL_ISA_avx2)
inline real_double to_double(real x) {
    const __m128 low = _mm256_castps256_ps128(x.v), high = _mm256_extractf128_ps(x.v, 1);
    return {DoubleBatch(_mm256_cvtps_pd(low)), DoubleBatch(_mm256_cvtps_pd(high))};
}
inline real_double to_double(integer x) {
    const __m128i low = _mm256_castsi256_si128(x.v), high = _mm256_extracti128_si256(x.v, 1);
    return {DoubleBatch(_mm256_cvtepi32_pd(low)), DoubleBatch(_mm256_cvtepi32_pd(high))};
}
inline real to_real(real_double x) {
    return real(
        RealBatch(_mm256_insertf128_ps(_mm256_castps128_ps256(_mm256_cvtpd_ps(x.low)), _mm256_cvtpd_ps(x.high), 1)));
}
inline integer to_int(real_double x) {
    return integer(IntegerBatch(
        _mm256_inserti128_si256(_mm256_castsi128_si256(_mm256_cvttpd_epi32(x.low)), _mm256_cvttpd_epi32(x.high), 1)));
}
#else
inline real_double to_double(real x) {
    return {DoubleBatch(_mm_cvtps_pd(x.v)), DoubleBatch(_mm_cvtps_pd(_mm_movehl_ps(x.v, x.v)))};
}
inline real_double to_double(integer x) {
    const __m128i high = _mm_shuffle_epi32(x.v, 0xee);
    return {DoubleBatch(_mm_cvtepi32_pd(x.v)), DoubleBatch(_mm_cvtepi32_pd(high))};
}
inline real to_real(real_double x) { return real(RealBatch(_mm_movelh_ps(_mm_cvtpd_ps(x.low), _mm_cvtpd_ps(x.high)))); }
inline integer to_int(real_double x) {
    return integer(IntegerBatch(_mm_unpacklo_epi64(_mm_cvttpd_epi32(x.low), _mm_cvttpd_epi32(x.high))));
}
#endif

#endif

}  // namespace rakelight::wide::RL_ISA
