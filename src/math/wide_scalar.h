// SPDX-License-Identifier: Apache-2.0
// The scalar flavor of the wide types: one lane of plain float, int32_t and bool. The reference for the other flavors.
#pragma once
#include <stdint.h>

namespace rakelight::wide::RL_ISA {

using real = float;
using integer = int32_t;
using mask = bool;
constexpr int lanes = 1;

inline real& part_of(real& x, int) { return x; }  ///< wide_pair.h has two
inline const real& part_of(const real& x, int) { return x; }
inline real broadcast(float s) { return s; }
inline integer broadcast_i(int32_t s) { return s; }
inline integer lane_indices() { return 0; }  ///< 0, 1, 2, ...
inline float lane(real x, int) { return x; }
inline int32_t lane(integer x, int) { return x; }
inline bool lane(mask m, int) { return m; }

inline real load(const float* p) { return *p; }
inline integer load_i(const int32_t* p) { return *p; }
inline void store(float* p, real x) { *p = x; }
inline void store(int32_t* p, integer x) { *p = x; }
/// Inactive lanes are 0 and their memory is not accessed.
inline real load_masked(const float* p, mask m) { return m ? *p : 0.0f; }
inline integer load_i_masked(const int32_t* p, mask m) { return m ? *p : 0; }
inline void store_masked(float* p, real x, mask m) {
    if (m) *p = x;
}
inline void store_masked(int32_t* p, integer x, mask m) {
    if (m) *p = x;
}
/// Stores the lanes of m contiguously and returns their number. Writes up to `lanes` values.
inline int32_t store_compressed(int32_t* p, integer x, mask m) {
    *p = x;
    return m ? 1 : 0;
}
inline real gather(const float* base, integer index) { return base[index]; }
inline integer gather_i(const int32_t* base, integer index) { return base[index]; }
inline integer gather_i(const uint32_t* base, integer index) { return int32_t(base[index]); }

/// Numbers index and index + 1.
inline void gather_pairs(const uint32_t* base, integer index, integer& first, integer& second) {
    first = int32_t(base[index]);
    second = int32_t(base[int64_t(index) + 1]);
}
/// Numbers 2 index to 2 index + 3.
inline void gather_quads(const uint32_t* base, integer index, integer (&out)[4]) {
    for (int k = 0; k < 4; ++k) out[k] = int32_t(base[2 * int64_t(index) + k]);
}
/// One of 16 numbers; index in 0..15.
inline integer look_up(const int32_t* table, integer index) { return table[index]; }

// Two 16-bit numbers per lane. Sums wrap round.
inline integer join16(int32_t low, int32_t high) { return int32_t((uint32_t(low) & 0xffffu) | (uint32_t(high) << 16)); }
inline integer low_in_both_halves(integer x) { return join16(x, x); }
inline integer add16(integer a, integer b) { return join16(int32_t(uint32_t(a) + uint32_t(b)), (a >> 16) + (b >> 16)); }
inline integer sub16(integer a, integer b) { return join16(int32_t(uint32_t(a) - uint32_t(b)), (a >> 16) - (b >> 16)); }
/// a times b / 32768, rounded to the nearest, halves up; b not -32768.
inline integer scale16(integer a, integer b) {
    return join16((int32_t(int16_t(a)) * int16_t(b) + 0x4000) >> 15, ((a >> 16) * (b >> 16) + 0x4000) >> 15);
}

inline integer bits_of(real x) { return __builtin_bit_cast(int32_t, x); }
inline real real_from_bits(integer i) { return __builtin_bit_cast(float, i); }
inline integer shift_right_logical(integer i, int count) { return int32_t(uint32_t(i) >> count); }
/// Out of range and NaN give INT32_MIN, like the processor's conversion.
inline integer to_int(real x) { return x >= -2147483648.0f && x < 2147483648.0f ? int32_t(x) : INT32_MIN; }
inline real to_real(integer i) { return float(i); }

inline real select(mask m, real a, real b) { return m ? a : b; }
inline integer select(mask m, integer a, integer b) { return m ? a : b; }
inline mask select(mask m, mask a, mask b) { return m ? a : b; }
inline bool any_lane(mask m) { return m; }
inline bool all_lanes(mask m) { return m; }
inline bool no_lane(mask m) { return !m; }
inline uint32_t lane_bits(mask m) { return m ? 1u : 0u; }  ///< bit i is lane i

inline real min(real a, real b) { return a < b ? a : b; }
inline real max(real a, real b) { return a > b ? a : b; }
inline integer min(integer a, integer b) { return a < b ? a : b; }
inline integer max(integer a, integer b) { return a > b ? a : b; }
inline real sqrt(real x) { return __builtin_sqrtf(x); }

}  // namespace rakelight::wide::RL_ISA
