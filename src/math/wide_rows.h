// SPDX-License-Identifier: Apache-2.0
// Transposed loads and stores: eight (or four) values per lane, in memory one row of eight (four) floats per lane.
// Bit-identical in every flavor. Only for sources compiled per instruction set.
#pragma once
#include "math/wide.h"

namespace rakelight::wide::RL_ISA {

#if defined(RL_ISA_scalar)

inline void store_rows4(float* rows, const real* v) {
    for (int k = 0; k < 4; ++k) rows[k] = v[k];
}
inline void store_rows8(float* rows, const real* v) {
    for (int k = 0; k < 8; ++k) rows[k] = v[k];
}
inline void store_columns4(float* rows, int, const real* v) { store_rows4(rows, v); }
inline void load_rows4(const float* rows, real* v) {
    for (int k = 0; k < 4; ++k) v[k] = rows[k];
}
inline integer load_i_rows4(const int32_t* first, int) { return *first; }
inline void load_rows8(const float* rows, real* v) {
    for (int k = 0; k < 8; ++k) v[k] = rows[k];
}
inline void load_rows4_at(const float* const* rows, int first, real* v) {
    for (int k = 0; k < 4; ++k) v[k] = rows[0][first + k];
}
template <int width, int index_stride>
inline void load_vectors(const float* base, const uint32_t* index, real* v) {
    for (int k = 0; k < width; ++k) v[k] = base[width * uint64_t(*index) + uint64_t(k)];
}

#else

// Four lanes of four values <-> four rows. An involution: reading is the same shuffle.
inline void transpose4(__m128& a, __m128& b, __m128& c, __m128& d) {
    const __m128 ab_low = _mm_unpacklo_ps(a, b), ab_high = _mm_unpackhi_ps(a, b);
    const __m128 cd_low = _mm_unpacklo_ps(c, d), cd_high = _mm_unpackhi_ps(c, d);
    a = _mm_movelh_ps(ab_low, cd_low);
    b = _mm_movehl_ps(cd_low, ab_low);
    c = _mm_movelh_ps(ab_high, cd_high);
    d = _mm_movehl_ps(cd_high, ab_high);
}

inline constexpr int quads = lanes / 4;

inline __m128 quad(real x, int q) {
#if defined(RL_ISA_avx512)
    switch (q) {
        case 0:
            return _mm512_castps512_ps128(x.v);
        case 1:
            return _mm512_extractf32x4_ps(x.v, 1);
        case 2:
            return _mm512_extractf32x4_ps(x.v, 2);
        default:
            return _mm512_extractf32x4_ps(x.v, 3);
    }
#elif defined(RL_ISA_avx2)
    return q == 0 ? _mm256_castps256_ps128(x.v) : _mm256_extractf128_ps(x.v, 1);
#else
    (void)q;
    return x.v;
#endif
}

inline real from_quads(const __m128* q) {
#if defined(RL_ISA_avx512)
    const __m512 low = _mm512_insertf32x4(_mm512_castps128_ps512(q[0]), q[1], 1);
    return real(RealBatch(_mm512_insertf32x4(_mm512_insertf32x4(low, q[2], 2), q[3], 3)));
#elif defined(RL_ISA_avx2)
    return real(RealBatch(_mm256_insertf128_ps(_mm256_castps128_ps256(q[0]), q[1], 1)));
#else
    return real(RealBatch(q[0]));
#endif
}

/// Four numbers of one row, four of the next, ...: rows are `stride` numbers apart.
inline integer load_i_rows4(const int32_t* first, int stride) {
    __m128 row[quads];
    for (int q = 0; q < quads; ++q) row[q] = _mm_loadu_ps(reinterpret_cast<const float*>(first + q * stride));
    return bits_of(from_quads(row));
}

// Columns v[0..3] to floats 0..3 of rows that lie `stride` apart.
inline void store_columns4(float* rows, int stride, const real* v) {
    for (int q = 0; q < quads; ++q) {
        __m128 a = quad(v[0], q), b = quad(v[1], q), c = quad(v[2], q), d = quad(v[3], q);
        transpose4(a, b, c, d);
        float* row = rows + 4 * q * stride;
        _mm_storeu_ps(row, a);
        _mm_storeu_ps(row + stride, b);
        _mm_storeu_ps(row + 2 * stride, c);
        _mm_storeu_ps(row + 3 * stride, d);
    }
}
inline void load_columns4(const float* rows, int stride, real* v) {
    __m128 column[4][quads];
    for (int q = 0; q < quads; ++q) {
        const float* row = rows + 4 * q * stride;
        __m128 a = _mm_loadu_ps(row), b = _mm_loadu_ps(row + stride), c = _mm_loadu_ps(row + 2 * stride),
               d = _mm_loadu_ps(row + 3 * stride);
        transpose4(a, b, c, d);
        column[0][q] = a;
        column[1][q] = b;
        column[2][q] = c;
        column[3][q] = d;
    }
    for (int k = 0; k < 4; ++k) v[k] = from_quads(column[k]);
}

/// Lane i: `width` (2, 3 or 4) floats from at(i) on. Reads four.
template <int width, class At>
inline void load_from(const At& at, real* v) {
#if defined(RL_ISA_avx512)
    using Packed = __m512;
    const auto four = [&](int i) {  // vectors i, i + 4, i + 8, i + 12
        __m512 p = _mm512_castps128_ps512(_mm_loadu_ps(at(i)));
        p = _mm512_insertf32x4(p, _mm_loadu_ps(at(i + 4)), 1);
        p = _mm512_insertf32x4(p, _mm_loadu_ps(at(i + 8)), 2);
        return _mm512_insertf32x4(p, _mm_loadu_ps(at(i + 12)), 3);
    };
    const auto low = [](Packed a, Packed b) { return _mm512_unpacklo_ps(a, b); };
    const auto high = [](Packed a, Packed b) { return _mm512_unpackhi_ps(a, b); };
    const auto halves_low = [](Packed a, Packed b) { return _mm512_shuffle_ps(a, b, 0x44); };
    const auto halves_high = [](Packed a, Packed b) { return _mm512_shuffle_ps(a, b, 0xee); };
#elif defined(RL_ISA_avx2)
    using Packed = __m256;
    const auto four = [&](int i) {
        return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(at(i))), _mm_loadu_ps(at(i + 4)), 1);
    };
    const auto low = [](Packed a, Packed b) { return _mm256_unpacklo_ps(a, b); };
    const auto high = [](Packed a, Packed b) { return _mm256_unpackhi_ps(a, b); };
    const auto halves_low = [](Packed a, Packed b) { return _mm256_shuffle_ps(a, b, 0x44); };
    const auto halves_high = [](Packed a, Packed b) { return _mm256_shuffle_ps(a, b, 0xee); };
#else
    using Packed = __m128;
    const auto four = [&](int i) { return _mm_loadu_ps(at(i)); };
    const auto low = [](Packed a, Packed b) { return _mm_unpacklo_ps(a, b); };
    const auto high = [](Packed a, Packed b) { return _mm_unpackhi_ps(a, b); };
    const auto halves_low = [](Packed a, Packed b) { return _mm_shuffle_ps(a, b, 0x44); };
    const auto halves_high = [](Packed a, Packed b) { return _mm_shuffle_ps(a, b, 0xee); };
#endif
    const Packed a = four(0), b = four(1), c = four(2), d = four(3);
    const Packed ab = low(a, b), cd = low(c, d);
    v[0] = real(RealBatch(halves_low(ab, cd)));
    v[1] = real(RealBatch(halves_high(ab, cd)));
    if constexpr (width > 2) v[2] = real(RealBatch(halves_low(high(a, b), high(c, d))));
    if constexpr (width == 4) v[3] = real(RealBatch(halves_high(high(a, b), high(c, d))));
}

/// Lane i: the vector of `width` (2, 3 or 4) floats number index[i * index_stride]. Reads four floats from each one's
/// beginning.
template <int width, int index_stride>
inline void load_vectors(const float* base, const uint32_t* index, real* v) {
    load_from<width>([=](int i) { return base + width * uint64_t(index[i * index_stride]); }, v);
}

/// Lane i: floats first..first + 3 of rows[i].
inline void load_rows4_at(const float* const* rows, int first, real* v) {
    load_from<4>([=](int i) { return rows[i] + first; }, v);
}

inline void store_rows4(float* rows, const real* v) { store_columns4(rows, 4, v); }
inline void load_rows4(const float* rows, real* v) { load_columns4(rows, 4, v); }
inline void store_rows8(float* rows, const real* v) {
    store_columns4(rows, 8, v);
    store_columns4(rows + 4, 8, v + 4);
}
inline void load_rows8(const float* rows, real* v) {
    load_columns4(rows, 8, v);
    load_columns4(rows + 4, 8, v + 4);
}

#endif

}  // namespace rakelight::wide::RL_ISA
