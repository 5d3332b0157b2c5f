// SPDX-License-Identifier: Apache-2.0
// Loads, stores and gathers of the sse2, avx2 and avx512 flavors. Second part of wide_xsimd.h.
#pragma once

namespace rakelight::wide::RL_WIDE_PART {

inline real& part_of(real& x, int) { return x; }  ///< wide_pair.h has two
inline const real& part_of(const real& x, int) { return x; }
inline real broadcast(float s) { return real(s); }
inline integer broadcast_i(int32_t s) { return integer(s); }
inline real load(const float* p) { return real(RealBatch::load_unaligned(p)); }
inline integer load_i(const int32_t* p) { return integer(IntegerBatch::load_unaligned(p)); }
inline void store(float* p, real x) { x.v.store_unaligned(p); }
inline void store(int32_t* p, integer x) { x.v.store_unaligned(p); }

/// 0, 1, 2, ...
inline integer lane_indices() {
    alignas(64) static constexpr int32_t counting[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    return load_i(counting);
}
inline float lane(real x, int i) {
    float all[lanes];
    store(all, x);
    return all[i];
}
inline int32_t lane(integer x, int i) {
    int32_t all[lanes];
    store(all, x);
    return all[i];
}
inline bool lane(mask m, int i) { return ((lane_bits(m) >> i) & 1u) != 0; }

/// Inactive lanes are 0 and their memory is not accessed.
inline real load_masked(const float* p, mask m) {
#if defined(RL_ISA_avx512)
    return real(RealBatch(_mm512_maskz_loadu_ps(m.v.data, p)));
#elif defined(RL_ISA_avx2)
    return real(RealBatch(_mm256_maskload_ps(p, _mm256_castps_si256(m.v.data))));
#else
    float all[lanes];
    for (int i = 0; i < lanes; ++i) all[i] = lane(m, i) ? p[i] : 0.0f;
    return load(all);
#endif
}
inline void store_masked(float* p, real x, mask m) {
#if defined(RL_ISA_avx512)
    _mm512_mask_storeu_ps(p, m.v.data, x.v);
#elif defined(RL_ISA_avx2)
    _mm256_maskstore_ps(p, _mm256_castps_si256(m.v.data), x.v);
#else
    for (int i = 0; i < lanes; ++i)
        if (lane(m, i)) p[i] = lane(x, i);
#endif
}
inline integer load_i_masked(const int32_t* p, mask m) {
    return bits_of(load_masked(reinterpret_cast<const float*>(p), m));
}
inline void store_masked(int32_t* p, integer x, mask m) {
    store_masked(reinterpret_cast<float*>(p), real_from_bits(x), m);
}

/// Stores the lanes of m contiguously and returns their number. Writes up to `lanes` values.
inline int32_t store_compressed(int32_t* p, integer x, mask m) {
#if defined(RL_ISA_avx512)
    _mm512_storeu_si512(p, _mm512_maskz_compress_epi32(m.v.data, x.v));
    return int32_t(__builtin_popcount(lane_bits(m)));
#else
    int32_t all[lanes];
    store(all, x);
    int32_t count = 0;
    for (uint32_t bits = lane_bits(m); bits != 0; bits &= bits - 1) p[count++] = all[__builtin_ctz(bits)];
    return count;
#endif
}

inline real gather(const float* base, integer index) {
#if defined(RL_ISA_avx512)
    return real(RealBatch(_mm512_i32gather_ps(index.v, base, 4)));
#elif defined(RL_ISA_avx2)
    return real(RealBatch(_mm256_i32gather_ps(base, index.v, 4)));
#else
    int32_t i[lanes];
    store(i, index);
    return real(RealBatch(_mm_setr_ps(base[i[0]], base[i[1]], base[i[2]], base[i[3]])));
#endif
}
inline integer gather_i(const int32_t* base, integer index) {
    return bits_of(gather(reinterpret_cast<const float*>(base), index));
}
inline integer gather_i(const uint32_t* base, integer index) {
    return bits_of(gather(reinterpret_cast<const float*>(base), index));
}

/// One of 16 numbers; index in 0..15.
inline integer look_up(const int32_t* table, integer index) {
#if defined(RL_ISA_avx512)
    return integer(IntegerBatch(_mm512_permutexvar_epi32(index.v, _mm512_loadu_si512(table))));
#else
    return gather_i(table, index);
#endif
}

/// Numbers index and index + 1.
inline void gather_pairs(const uint32_t* base, integer index, integer& first, integer& second) {
#if defined(RL_ISA_avx512)
    const __m512i low = _mm512_i32gather_epi64(_mm512_castsi512_si256(index.v), base, 4);
    const __m512i high = _mm512_i32gather_epi64(_mm512_extracti64x4_epi64(index.v, 1), base, 4);
    const __m512i even = (lane_indices() << 1).v;
    first = integer(IntegerBatch(_mm512_permutex2var_epi32(low, even, high)));
    second = integer(IntegerBatch(_mm512_permutex2var_epi32(low, _mm512_or_si512(even, _mm512_set1_epi32(1)), high)));
#elif defined(RL_ISA_avx2)
    const auto gathered = [base](__m128i i) {
        return _mm256_castsi256_ps(_mm256_i32gather_epi64(reinterpret_cast<const long long*>(base), i, 4));
    };
    const __m256 low = gathered(_mm256_castsi256_si128(index.v)), high = gathered(_mm256_extracti128_si256(index.v, 1));
    const auto ordered = [](__m256 v) { return IntegerBatch(_mm256_permute4x64_epi64(_mm256_castps_si256(v), 0xd8)); };
    first = integer(ordered(_mm256_shuffle_ps(low, high, 0x88)));
    second = integer(ordered(_mm256_shuffle_ps(low, high, 0xdd)));
#else
    int32_t i[lanes];
    store(i, index);
    const auto pair = [&](int k) { return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(base + i[k])); };
    const __m128 low = _mm_castsi128_ps(_mm_unpacklo_epi64(pair(0), pair(1)));
    const __m128 high = _mm_castsi128_ps(_mm_unpacklo_epi64(pair(2), pair(3)));
    first = integer(IntegerBatch(_mm_castps_si128(_mm_shuffle_ps(low, high, 0x88))));
    second = integer(IntegerBatch(_mm_castps_si128(_mm_shuffle_ps(low, high, 0xdd))));
#endif
}

/// Numbers 2 index to 2 index + 3.
[[gnu::always_inline]] inline void gather_quads(const uint32_t* base, integer index, integer (&out)[4]) {
    // One load per lane followed by a transpose: gathers are slower, even with hardware support. Row k holds the
    // numbers of lanes k, 4 + k, ...
    int32_t i[lanes];
    store(i, index);
    const auto quad = [&](int k) {
        return _mm_loadu_si128(reinterpret_cast<const __m128i*>(base + 2 * int64_t(i[k])));
    };
#if defined(RL_ISA_avx512)
    const auto row = [&](int k) {
        const __m512i two = _mm512_inserti32x4(_mm512_castsi128_si512(quad(k)), quad(4 + k), 1);
        return _mm512_inserti32x4(_mm512_inserti32x4(two, quad(8 + k), 2), quad(12 + k), 3);
    };
#define RL_UNPACK(which, a, b) _mm512_unpack##which(a, b)
#elif defined(RL_ISA_avx2)
    const auto row = [&](int k) { return _mm256_inserti128_si256(_mm256_castsi128_si256(quad(k)), quad(4 + k), 1); };
#define RL_UNPACK(which, a, b) _mm256_unpack##which(a, b)
#else
    const auto& row = quad;
#define RL_UNPACK(which, a, b) _mm_unpack##which(a, b)
#endif
    const auto r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
    const auto low01 = RL_UNPACK(lo_epi32, r0, r1), low23 = RL_UNPACK(lo_epi32, r2, r3);
    const auto high01 = RL_UNPACK(hi_epi32, r0, r1), high23 = RL_UNPACK(hi_epi32, r2, r3);
    out[0] = integer(IntegerBatch(RL_UNPACK(lo_epi64, low01, low23)));
    out[1] = integer(IntegerBatch(RL_UNPACK(hi_epi64, low01, low23)));
    out[2] = integer(IntegerBatch(RL_UNPACK(lo_epi64, high01, high23)));
    out[3] = integer(IntegerBatch(RL_UNPACK(hi_epi64, high01, high23)));
#undef RL_UNPACK
}

}  // namespace rakelight::wide::RL_WIDE_PART
