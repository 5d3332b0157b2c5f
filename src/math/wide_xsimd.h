// SPDX-License-Identifier: Apache-2.0
// The sse2, avx2 and avx512 flavors of the wide types on xsimd 8.1. Wrapper structs around its batches restrict the
// vocabulary: operations not defined here do not compile, so all edge cases are verified.
#pragma once
#include <stdint.h>
#pragma GCC diagnostic push
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wuninitialized"  // GCC 12 warns of its own _mm512_undefined_ps (GCC bug 105593)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <xsimd/xsimd.hpp>
#pragma GCC diagnostic pop

static_assert(XSIMD_VERSION_MAJOR == 8, "names and edge cases below were checked against xsimd 8.1");

namespace rakelight::wide::RL_WIDE_PART {

#if defined(RL_ISA_avx512)
using arch = xsimd::avx512bw;
#elif defined(RL_ISA_avx2)
using arch = xsimd::avx2;
#else
using arch = xsimd::sse2;
#endif
using RealBatch = xsimd::batch<float, arch>;
using IntegerBatch = xsimd::batch<int32_t, arch>;
using UnsignedBatch = xsimd::batch<uint32_t, arch>;
using MaskBatch = xsimd::batch_bool<float, arch>;
using IntegerMaskBatch = xsimd::batch_bool<int32_t, arch>;
constexpr int lanes = int(RealBatch::size);

struct mask {
    MaskBatch v;
    mask() = default;
    template <class T>
    requires(__is_same(T, bool))  // no implicit float -> mask
        mask(T b)
        : v(b) {}
    explicit mask(MaskBatch b) : v(b) {}
#if defined(RL_ISA_avx512)  // one bit per lane for both types
    explicit mask(IntegerMaskBatch b) : v(MaskBatch(b.data)) {}
#elif defined(RL_ISA_avx2)
    explicit mask(IntegerMaskBatch b) : v(MaskBatch(_mm256_castsi256_ps(b.data))) {}
#else
    explicit mask(IntegerMaskBatch b) : v(MaskBatch(_mm_castsi128_ps(b.data))) {}
#endif
};

struct real {
    RealBatch v;
    real() = default;
    real(float s) : v(s) {}
    explicit real(RealBatch b) : v(b) {}
};

struct integer {
    IntegerBatch v;
    integer() = default;
    template <class T>
    requires(__is_same(T, int32_t))  // no implicit float -> integer
        integer(T s)
        : v(s) {}
    explicit integer(IntegerBatch b) : v(b) {}
};

// --- masks
// && and || evaluate both sides, as everything wide does.

inline mask operator&(mask a, mask b) { return mask(a.v & b.v); }
inline mask operator|(mask a, mask b) { return mask(a.v | b.v); }
inline mask operator&&(mask a, mask b) { return mask(a.v & b.v); }
inline mask operator||(mask a, mask b) { return mask(a.v | b.v); }
inline mask operator!(mask a) { return mask(!a.v); }
inline mask& operator&=(mask& a, mask b) { return a = a & b; }
inline mask& operator|=(mask& a, mask b) { return a = a | b; }

/// Bit i is lane i.
inline uint32_t lane_bits(mask m) {
#if defined(RL_ISA_avx512)
    return uint32_t(m.v.data);
#elif defined(RL_ISA_avx2)
    return uint32_t(_mm256_movemask_ps(m.v.data));
#else
    return uint32_t(_mm_movemask_ps(m.v.data));
#endif
}
inline bool any_lane(mask m) { return lane_bits(m) != 0; }
inline bool no_lane(mask m) { return lane_bits(m) == 0; }
inline bool all_lanes(mask m) { return lane_bits(m) == (uint32_t(1) << lanes) - 1; }

// --- arithmetic and comparisons

inline real operator+(real a, real b) { return real(a.v + b.v); }
inline real operator-(real a, real b) { return real(a.v - b.v); }
inline real operator*(real a, real b) { return real(a.v * b.v); }
inline real operator/(real a, real b) { return real(a.v / b.v); }
inline real& operator+=(real& a, real b) { return a = a + b; }
inline real& operator-=(real& a, real b) { return a = a - b; }
inline real& operator*=(real& a, real b) { return a = a * b; }
inline real& operator/=(real& a, real b) { return a = a / b; }
inline mask operator<(real a, real b) { return mask(a.v < b.v); }
inline mask operator<=(real a, real b) { return mask(a.v <= b.v); }
inline mask operator>(real a, real b) { return mask(a.v > b.v); }
inline mask operator>=(real a, real b) { return mask(a.v >= b.v); }
inline mask operator==(real a, real b) { return mask(a.v == b.v); }
inline mask operator!=(real a, real b) { return !(a == b); }  // xsimd's own is false for NaN with AVX and wider
inline real min(real a, real b) { return real(xsimd::min(a.v, b.v)); }
inline real max(real a, real b) { return real(xsimd::max(a.v, b.v)); }
inline real sqrt(real x) { return real(xsimd::sqrt(x.v)); }

inline integer operator+(integer a, integer b) { return integer(a.v + b.v); }
inline integer operator-(integer a, integer b) { return integer(a.v - b.v); }
inline integer operator*(integer a, integer b) { return integer(a.v * b.v); }
inline integer operator-(integer a) { return integer(0) - a; }
inline integer operator&(integer a, integer b) { return integer(a.v & b.v); }
inline integer operator|(integer a, integer b) { return integer(a.v | b.v); }
inline integer operator^(integer a, integer b) { return integer(a.v ^ b.v); }
inline integer operator~(integer a) { return integer(~a.v); }
inline integer operator<<(integer a, int count) { return integer(a.v << count); }
inline integer operator>>(integer a, int count) { return integer(a.v >> count); }  ///< arithmetic: keeps the sign
inline integer& operator+=(integer& a, integer b) { return a = a + b; }
inline integer& operator-=(integer& a, integer b) { return a = a - b; }
inline mask operator<(integer a, integer b) { return mask(a.v < b.v); }
inline mask operator<=(integer a, integer b) { return mask(a.v <= b.v); }
inline mask operator>(integer a, integer b) { return mask(a.v > b.v); }
inline mask operator>=(integer a, integer b) { return mask(a.v >= b.v); }
inline mask operator==(integer a, integer b) { return mask(a.v == b.v); }
inline mask operator!=(integer a, integer b) { return mask(a.v != b.v); }
inline integer min(integer a, integer b) { return integer(xsimd::min(a.v, b.v)); }
inline integer max(integer a, integer b) { return integer(xsimd::max(a.v, b.v)); }

// --- conversions and choice

inline integer bits_of(real x) { return integer(xsimd::bitwise_cast<IntegerBatch>(x.v)); }
inline real real_from_bits(integer i) { return real(xsimd::bitwise_cast<RealBatch>(i.v)); }
inline integer to_int(real x) { return integer(xsimd::to_int(x.v)); }
inline real to_real(integer i) { return real(xsimd::to_float(i.v)); }
inline integer shift_right_logical(integer i, int count) {
    return integer(xsimd::bitwise_cast<IntegerBatch>(xsimd::bitwise_cast<UnsignedBatch>(i.v) >> count));
}
/// Flips the sign bit, as the scalar minus does (0 - x would give +0 for +0).
inline real operator-(real x) { return real_from_bits(bits_of(x) ^ integer(INT32_MIN)); }

inline real select(mask m, real a, real b) { return real(xsimd::select(m.v, a.v, b.v)); }
inline integer select(mask m, integer a, integer b) { return bits_of(select(m, real_from_bits(a), real_from_bits(b))); }
inline mask select(mask m, mask a, mask b) { return (m && a) || (!m && b); }

// --- two 16-bit numbers per lane. Sums wrap round.

#if defined(RL_ISA_avx512)
inline integer low_in_both_halves(integer x) {
    const __m512i order = _mm512_set4_epi32(0x0d0c0d0c, 0x09080908, 0x05040504, 0x01000100);
    return integer(IntegerBatch(_mm512_shuffle_epi8(x.v, order)));
}
inline integer add16(integer a, integer b) { return integer(IntegerBatch(_mm512_add_epi16(a.v, b.v))); }
inline integer sub16(integer a, integer b) { return integer(IntegerBatch(_mm512_sub_epi16(a.v, b.v))); }
/// a times b / 32768, rounded to the nearest, halves up; b not -32768.
inline integer scale16(integer a, integer b) { return integer(IntegerBatch(_mm512_mulhrs_epi16(a.v, b.v))); }
#elif defined(RL_ISA_avx2)
inline integer low_in_both_halves(integer x) {
    const __m128i order = _mm_set_epi32(0x0d0c0d0c, 0x09080908, 0x05040504, 0x01000100);
    return integer(IntegerBatch(_mm256_shuffle_epi8(x.v, _mm256_broadcastsi128_si256(order))));
}
inline integer add16(integer a, integer b) { return integer(IntegerBatch(_mm256_add_epi16(a.v, b.v))); }
inline integer sub16(integer a, integer b) { return integer(IntegerBatch(_mm256_sub_epi16(a.v, b.v))); }
inline integer scale16(integer a, integer b) { return integer(IntegerBatch(_mm256_mulhrs_epi16(a.v, b.v))); }
#else
inline integer low_in_both_halves(integer x) {
    return integer(IntegerBatch(_mm_shufflehi_epi16(_mm_shufflelo_epi16(x.v, 0xa0), 0xa0)));
}
inline integer add16(integer a, integer b) { return integer(IntegerBatch(_mm_add_epi16(a.v, b.v))); }
inline integer sub16(integer a, integer b) { return integer(IntegerBatch(_mm_sub_epi16(a.v, b.v))); }
inline integer scale16(integer a, integer b) {  // _mm_mulhrs_epi16 came with SSSE3
    const __m128i low = _mm_mullo_epi16(a.v, b.v), high = _mm_mulhi_epi16(a.v, b.v);
    const __m128i half = _mm_and_si128(_mm_srli_epi16(low, 14), _mm_set1_epi16(1));
    const __m128i whole = _mm_or_si128(_mm_slli_epi16(high, 1), _mm_srli_epi16(low, 15));
    return integer(IntegerBatch(_mm_add_epi16(whole, half)));
}
#endif

// --- rounding where the processor has it; wide_functions.h has the text for the others

#if defined(RL_ISA_avx512) || defined(RL_ISA_avx2)
#define RL_WIDE_NATIVE_ROUNDING 1
#if defined(RL_ISA_avx512)
inline real trunc(real x) { return real(RealBatch(_mm512_roundscale_ps(x.v, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC))); }
inline real floor(real x) {
    return real(RealBatch(_mm512_roundscale_ps(x.v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)));
}
inline real ceil(real x) {
    return real(RealBatch(_mm512_roundscale_ps(x.v, _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC)));
}
#else
inline real trunc(real x) { return real(RealBatch(_mm256_round_ps(x.v, _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC))); }
inline real floor(real x) { return real(RealBatch(_mm256_round_ps(x.v, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC))); }
inline real ceil(real x) { return real(RealBatch(_mm256_round_ps(x.v, _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC))); }
#endif
#endif

}  // namespace rakelight::wide::RL_WIDE_PART

#include "math/wide_xsimd_memory.h"
