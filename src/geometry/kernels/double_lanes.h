// SPDX-License-Identifier: Apache-2.0
// Vectors of doubles as wide as the instruction set has them, for kernels of one source.
#pragma once
#include <stdint.h>

namespace rakelight::geometry::RL_ISA {

#if defined(RL_ISA_avx512)
constexpr uint32_t lanes = 8;
#elif defined(RL_ISA_avx2)
constexpr uint32_t lanes = 4;
#else
constexpr uint32_t lanes = 2;
#endif
typedef double numbers __attribute__((vector_size(lanes * sizeof(double))));
typedef long long bits __attribute__((vector_size(lanes * sizeof(double))));
#define RL_INLINE static inline __attribute__((always_inline))

RL_INLINE numbers all(double v) { return v - numbers{}; }
RL_INLINE numbers square_root(numbers v) {
    alignas(64) double n[lanes];
    __builtin_memcpy(n, &v, sizeof n);
    for (uint32_t i = 0; i < lanes; ++i) n[i] = __builtin_sqrt(n[i]);
    __builtin_memcpy(&v, n, sizeof n);
    return v;
}

struct Three {
    numbers x, y, z;
};

RL_INLINE numbers dot(const Three& a, const Three& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
RL_INLINE Three cross(const Three& a, const Three& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace rakelight::geometry::RL_ISA
