// SPDX-License-Identifier: Apache-2.0
// The inner loop of the fast weld, per instruction set.
#include "geometry/fast/fast_weld_types.h"
#include "math/wide_rows.h"

namespace rakelight::geometry::RL_ISA {
RL_USE_WIDE;
using rakelight::wide::RL_ISA::load_vectors;

constexpr uint32_t block = 16;

// Folded, because grid coordinates have no low bits; -0 becomes +0.
static inline uint32_t folded_bits(float p) {
    const uint32_t bits = __builtin_bit_cast(uint32_t, p + 0.0f);
    return bits ^ bits >> 16;
}

static inline void hash_block(const float* positions, uint32_t seed, uint32_t* hashes) {
    alignas(64) static constexpr uint32_t order[block] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    alignas(64) float x[block], y[block], z[block];
    for (uint32_t i = 0; i < block; i += uint32_t(lanes)) {
        real v[3];
        load_vectors<3, 1>(positions, order + i, v);
        store(x + i, v[0]);
        store(y + i, v[1]);
        store(z + i, v[2]);
    }
    for (uint32_t i = 0; i < block; ++i) {
        uint32_t h = (folded_bits(x[i]) * hash_multipliers[0] ^ seed) + folded_bits(y[i]) * hash_multipliers[1];
        h = (h ^ h >> 15) * hash_multipliers[3] + folded_bits(z[i]) * hash_multipliers[2];
        h = (h ^ h >> 16) * hash_multipliers[1];
        h = (h ^ h >> 13) * hash_multipliers[2];
        hashes[i] = h ^ h >> 16;
    }
}

static void hash(const float* positions, uint32_t count, uint32_t seed, uint32_t* hashes) {
    uint32_t v = 0;
    for (; v + block < count; v += block)
        hash_block(positions + 3 * uint64_t(v), seed, hashes + v);  // reads one float beyond its block
    float copy[3 * block + 4] = {};
    uint32_t last[block];
    for (uint32_t i = 0; i < 3 * (count - v); ++i) copy[i] = positions[3 * uint64_t(v) + i];
    hash_block(copy, seed, last);
    for (uint32_t i = v; i < count; ++i) hashes[i] = last[i - v];
}

const WeldKernels* weld_kernels() {
    static constexpr WeldKernels table = {hash};
    return &table;
}

}  // namespace rakelight::geometry::RL_ISA
