// SPDX-License-Identifier: Apache-2.0
// Two native vectors as one: `lanes` is doubled. Latency-bound kernels can overlap two dependency chains. Included by
// wide.h where RL_WIDE_PAIRS is defined; no rows (wide_rows.h).
#pragma once

namespace rakelight::wide::RL_ISA {

constexpr int lanes = 2 * half::lanes;

struct mask {
    half::mask a, b;
    mask() = default;
    template <class T>
    requires(__is_same(T, bool))  // no implicit float -> mask
        mask(T s)
        : a(s), b(s) {}
    mask(half::mask x, half::mask y) : a(x), b(y) {}
};
struct real {
    half::real a, b;
    real() = default;
    real(float s) : a(s), b(s) {}
    real(half::real x, half::real y) : a(x), b(y) {}
};
struct integer {
    half::integer a, b;
    integer() = default;
    template <class T>
    requires(__is_same(T, int32_t))  // no implicit float -> integer
        integer(T s)
        : a(s), b(s) {}
    integer(half::integer x, half::integer y) : a(x), b(y) {}
};

inline mask operator&(mask x, mask y) { return mask(x.a & y.a, x.b & y.b); }
inline mask operator|(mask x, mask y) { return mask(x.a | y.a, x.b | y.b); }
inline mask operator&&(mask x, mask y) { return mask(x.a && y.a, x.b && y.b); }
inline mask operator||(mask x, mask y) { return mask(x.a || y.a, x.b || y.b); }
inline real operator+(real x, real y) { return real(x.a + y.a, x.b + y.b); }
inline real operator-(real x, real y) { return real(x.a - y.a, x.b - y.b); }
inline real operator*(real x, real y) { return real(x.a * y.a, x.b * y.b); }
inline real operator/(real x, real y) { return real(x.a / y.a, x.b / y.b); }
inline mask operator<(real x, real y) { return mask(x.a < y.a, x.b < y.b); }
inline mask operator<=(real x, real y) { return mask(x.a <= y.a, x.b <= y.b); }
inline mask operator>(real x, real y) { return mask(x.a > y.a, x.b > y.b); }
inline mask operator>=(real x, real y) { return mask(x.a >= y.a, x.b >= y.b); }
inline mask operator==(real x, real y) { return mask(x.a == y.a, x.b == y.b); }
inline mask operator!=(real x, real y) { return mask(x.a != y.a, x.b != y.b); }
inline integer operator+(integer x, integer y) { return integer(x.a + y.a, x.b + y.b); }
inline integer operator-(integer x, integer y) { return integer(x.a - y.a, x.b - y.b); }
inline integer operator*(integer x, integer y) { return integer(x.a * y.a, x.b * y.b); }
inline integer operator&(integer x, integer y) { return integer(x.a & y.a, x.b & y.b); }
inline integer operator|(integer x, integer y) { return integer(x.a | y.a, x.b | y.b); }
inline integer operator^(integer x, integer y) { return integer(x.a ^ y.a, x.b ^ y.b); }
inline mask operator<(integer x, integer y) { return mask(x.a < y.a, x.b < y.b); }
inline mask operator<=(integer x, integer y) { return mask(x.a <= y.a, x.b <= y.b); }
inline mask operator>(integer x, integer y) { return mask(x.a > y.a, x.b > y.b); }
inline mask operator>=(integer x, integer y) { return mask(x.a >= y.a, x.b >= y.b); }
inline mask operator==(integer x, integer y) { return mask(x.a == y.a, x.b == y.b); }
inline mask operator!=(integer x, integer y) { return mask(x.a != y.a, x.b != y.b); }
inline integer operator<<(integer x, int count) { return integer(x.a << count, x.b << count); }
inline integer operator>>(integer x, int count) { return integer(x.a >> count, x.b >> count); }
inline mask operator!(mask x) { return mask(!x.a, !x.b); }
inline real operator-(real x) { return real(-x.a, -x.b); }
inline integer operator-(integer x) { return integer(-x.a, -x.b); }
inline integer operator~(integer x) { return integer(~x.a, ~x.b); }
inline real& operator+=(real& x, real y) { return x = x + y; }
inline real& operator-=(real& x, real y) { return x = x - y; }
inline real& operator*=(real& x, real y) { return x = x * y; }
inline real& operator/=(real& x, real y) { return x = x / y; }
inline integer& operator+=(integer& x, integer y) { return x = x + y; }
inline integer& operator-=(integer& x, integer y) { return x = x - y; }
inline mask& operator&=(mask& x, mask y) { return x = x & y; }
inline mask& operator|=(mask& x, mask y) { return x = x | y; }

inline real sqrt(real x) { return real(half::sqrt(x.a), half::sqrt(x.b)); }
inline real trunc(real x) { return real(half::trunc(x.a), half::trunc(x.b)); }
inline real floor(real x) { return real(half::floor(x.a), half::floor(x.b)); }
inline real ceil(real x) { return real(half::ceil(x.a), half::ceil(x.b)); }
inline integer bits_of(real x) { return integer(half::bits_of(x.a), half::bits_of(x.b)); }
inline real real_from_bits(integer x) { return real(half::real_from_bits(x.a), half::real_from_bits(x.b)); }
inline integer to_int(real x) { return integer(half::to_int(x.a), half::to_int(x.b)); }
inline real to_real(integer x) { return real(half::to_real(x.a), half::to_real(x.b)); }
inline real min(real x, real y) { return real(half::min(x.a, y.a), half::min(x.b, y.b)); }
inline integer min(integer x, integer y) { return integer(half::min(x.a, y.a), half::min(x.b, y.b)); }
inline real max(real x, real y) { return real(half::max(x.a, y.a), half::max(x.b, y.b)); }
inline integer max(integer x, integer y) { return integer(half::max(x.a, y.a), half::max(x.b, y.b)); }
inline integer low_in_both_halves(integer x) {
    return integer(half::low_in_both_halves(x.a), half::low_in_both_halves(x.b));
}
inline integer add16(integer x, integer y) { return integer(half::add16(x.a, y.a), half::add16(x.b, y.b)); }
inline integer sub16(integer x, integer y) { return integer(half::sub16(x.a, y.a), half::sub16(x.b, y.b)); }
inline integer scale16(integer x, integer y) { return integer(half::scale16(x.a, y.a), half::scale16(x.b, y.b)); }
inline real select(mask m, real x, real y) { return real(half::select(m.a, x.a, y.a), half::select(m.b, x.b, y.b)); }
inline integer select(mask m, integer x, integer y) {
    return integer(half::select(m.a, x.a, y.a), half::select(m.b, x.b, y.b));
}
inline mask select(mask m, mask x, mask y) { return mask(half::select(m.a, x.a, y.a), half::select(m.b, x.b, y.b)); }
inline integer shift_right_logical(integer x, int count) {
    return integer(half::shift_right_logical(x.a, count), half::shift_right_logical(x.b, count));
}

/// Bit i is lane i.
inline uint32_t lane_bits(mask m) { return half::lane_bits(m.a) | half::lane_bits(m.b) << half::lanes; }
inline bool any_lane(mask m) { return half::any_lane(m.a | m.b); }
inline bool no_lane(mask m) { return !any_lane(m); }
inline bool all_lanes(mask m) { return half::all_lanes(m.a & m.b); }

inline half::real& part_of(real& x, int i) { return i == 0 ? x.a : x.b; }
inline const half::real& part_of(const real& x, int i) { return i == 0 ? x.a : x.b; }
inline real broadcast(float s) { return real(s); }
inline integer broadcast_i(int32_t s) { return integer(s); }
inline integer lane_indices() {
    return integer(half::lane_indices(), half::lane_indices() + half::integer(int32_t(half::lanes)));
}
inline float lane(real x, int i) { return i < half::lanes ? half::lane(x.a, i) : half::lane(x.b, i - half::lanes); }
inline int32_t lane(integer x, int i) {
    return i < half::lanes ? half::lane(x.a, i) : half::lane(x.b, i - half::lanes);
}
inline bool lane(mask m, int i) { return ((lane_bits(m) >> i) & 1u) != 0; }

inline real load(const float* p) { return real(half::load(p), half::load(p + half::lanes)); }
inline integer load_i(const int32_t* p) { return integer(half::load_i(p), half::load_i(p + half::lanes)); }
inline void store(float* p, real x) {
    half::store(p, x.a);
    half::store(p + half::lanes, x.b);
}
inline void store(int32_t* p, integer x) {
    half::store(p, x.a);
    half::store(p + half::lanes, x.b);
}
/// Inactive lanes are 0 and their memory is not accessed.
inline real load_masked(const float* p, mask m) {
    return real(half::load_masked(p, m.a), half::load_masked(p + half::lanes, m.b));
}
inline integer load_i_masked(const int32_t* p, mask m) {
    return integer(half::load_i_masked(p, m.a), half::load_i_masked(p + half::lanes, m.b));
}
inline void store_masked(float* p, real x, mask m) {
    half::store_masked(p, x.a, m.a);
    half::store_masked(p + half::lanes, x.b, m.b);
}
inline void store_masked(int32_t* p, integer x, mask m) {
    half::store_masked(p, x.a, m.a);
    half::store_masked(p + half::lanes, x.b, m.b);
}
/// Stores the lanes of m contiguously and returns their number. Writes up to `lanes` values.
inline int32_t store_compressed(int32_t* p, integer x, mask m) {
    const int32_t first = half::store_compressed(p, x.a, m.a);
    return first + half::store_compressed(p + first, x.b, m.b);
}
inline real gather(const float* base, integer i) { return real(half::gather(base, i.a), half::gather(base, i.b)); }
inline integer gather_i(const int32_t* base, integer i) {
    return integer(half::gather_i(base, i.a), half::gather_i(base, i.b));
}
inline integer gather_i(const uint32_t* base, integer i) {
    return integer(half::gather_i(base, i.a), half::gather_i(base, i.b));
}
/// Numbers index and index + 1.
inline void gather_pairs(const uint32_t* base, integer i, integer& first, integer& second) {
    half::gather_pairs(base, i.a, first.a, second.a);
    half::gather_pairs(base, i.b, first.b, second.b);
}
/// Numbers 2 index to 2 index + 3.
[[gnu::always_inline]] inline void gather_quads(const uint32_t* base, integer i, integer (&out)[4]) {
    half::integer a[4], b[4];
    half::gather_quads(base, i.a, a);
    half::gather_quads(base, i.b, b);
    for (int k = 0; k < 4; ++k) out[k] = integer(a[k], b[k]);
}
/// One of 16 numbers; index in 0..15.
inline integer look_up(const int32_t* table, integer i) {
    return integer(half::look_up(table, i.a), half::look_up(table, i.b));
}

}  // namespace rakelight::wide::RL_ISA
