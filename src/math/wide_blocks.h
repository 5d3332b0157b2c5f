// SPDX-License-Identifier: Apache-2.0
// Lanes as a block of pixels of a row-major picture: 4 x 4, 4 x 2, 4 x 1 or one pixel. Only for sources compiled per
// instruction set.
#pragma once
#include "math/wide.h"

namespace rakelight::wide::RL_ISA {

inline constexpr int block_width = lanes >= 4 ? 4 : 1, block_height = lanes / block_width;

inline integer block_x() { return lane_indices() & integer(block_width - 1); }  ///< 0..block_width - 1 of each lane
inline integer block_y() {
#if defined(RL_ISA_scalar)
    return 0;
#else
    return lane_indices() >> 2;
#endif
}

#if defined(RL_ISA_scalar)

inline real load_block(const float* p, int) { return *p; }
inline void store_block(float* p, int, real x, mask m) { store_masked(p, x, m); }
inline void store_block(int32_t* p, int, integer x, mask m) { store_masked(p, x, m); }

#elif defined(RL_ISA_avx512)

/// @param stride  [floats] from row to row
inline real load_block(const float* p, int stride) {
    const __m256 low = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(p)), _mm_loadu_ps(p + stride), 1);
    const __m256 high =
        _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(p + 2 * stride)), _mm_loadu_ps(p + 3 * stride), 1);
    return real(RealBatch(_mm512_insertf32x8(_mm512_castps256_ps512(low), high, 1)));
}
/// Lanes outside of m keep their values in memory (which other threads must not write concurrently).
inline void store_block(float* p, int stride, real x, mask m) {
    const uint32_t bits = lane_bits(m);
    _mm_mask_storeu_ps(p, __mmask8(bits), _mm512_castps512_ps128(x.v));
    _mm_mask_storeu_ps(p + stride, __mmask8(bits >> 4), _mm512_extractf32x4_ps(x.v, 1));
    _mm_mask_storeu_ps(p + 2 * stride, __mmask8(bits >> 8), _mm512_extractf32x4_ps(x.v, 2));
    _mm_mask_storeu_ps(p + 3 * stride, __mmask8(bits >> 12), _mm512_extractf32x4_ps(x.v, 3));
}

#elif defined(RL_ISA_avx2)

inline real load_block(const float* p, int stride) {
    return real(RealBatch(_mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(p)), _mm_loadu_ps(p + stride), 1)));
}
inline void store_block(float* p, int stride, real x, mask m) {
    const __m256 mixed =
        _mm256_blendv_ps(load_block(p, stride).v, x.v, m.v.data);  // masked stores are slow on some processors
    _mm_storeu_ps(p, _mm256_castps256_ps128(mixed));
    _mm_storeu_ps(p + stride, _mm256_extractf128_ps(mixed, 1));
}

#else

inline real load_block(const float* p, int) { return load(p); }
inline void store_block(float* p, int, real x, mask m) { store(p, select(m, x, load(p))); }

#endif

#if !defined(RL_ISA_scalar)
inline void store_block(int32_t* p, int stride, integer x, mask m) {
    store_block(reinterpret_cast<float*>(p), stride, real_from_bits(x), m);
}
#endif

}  // namespace rakelight::wide::RL_ISA
