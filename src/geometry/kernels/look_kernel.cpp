// SPDX-License-Identifier: Apache-2.0
// How the faces at each vertex lie around its normal (LookRow), per instruction set.
#include "geometry/fast/fast_weld_types.h"
#include "geometry/kernels/face_blocks.h"

namespace rakelight::geometry::RL_ISA {

/// Hashes of a corner's positions, in halves of 16 bits. -0 is +0.
struct PlaceHash {
    real low, high;
};
static inline PlaceHash hash_of(const vec3& p) {
    alignas(64) float x[lanes], y[lanes], z[lanes], low[lanes], high[lanes];
    store(x, p.x + real(0.0f)), store(y, p.y + real(0.0f)), store(z, p.z + real(0.0f));
    for (int i = 0; i < lanes; ++i) {
        const uint32_t a = __builtin_bit_cast(uint32_t, x[i]), b = __builtin_bit_cast(uint32_t, y[i]),
                       c = __builtin_bit_cast(uint32_t, z[i]);
        uint32_t h = (a ^ a >> 16) * hash_multipliers[0] + (b ^ b >> 16) * hash_multipliers[1];
        h = (h ^ h >> 15) * hash_multipliers[3] + (c ^ c >> 16) * hash_multipliers[2];
        h = (h ^ h >> 16) * hash_multipliers[1];
        h ^= h >> 15;
        low[i] = float(int32_t(h & 0xffffu)), high[i] = float(int32_t(h >> 16));
    }
    return {load(low), load(high)};
}

/// One corner's faces and neighbors, seen from its vertex's normal.
static inline void look(const vec3& n, const vec3& vertex_normal, const vec3& to_next, const vec3& to_previous,
                        real hard_cosine, real bent_cosine, real& turns, real& bends) {
    const real zero(0.0f), one(1.0f), cosine = dot(n, vertex_normal);
    const vec3 side = across(vertex_normal);
    // Each time that a fan goes around, one face crosses the half plane behind `side`: an edge is on one side of it for
    // both of its faces, also after rounding.
    turns = select(dot(to_next, side) > zero && !(dot(to_previous, side) > zero), one, zero);
    bends = select(cosine >= bent_cosine, zero, one) + select(cosine >= hard_cosine, zero, real(hard_face));
}

static inline uint32_t look_rows(const ScatterJob& job, const BlockSource& from, BlockRows<4, false>& rows) {
    const real hard(job.hard_cosine), bent(job.bent_cosine);
    uint32_t odd = 0;
    for (uint32_t f = 0; f < face_block; f += uint32_t(lanes)) {
        const uint32_t* corner = from.index + 3 * f;
        vec3 p[3], to_next[3];
        PlaceHash hash[3];
        for (uint32_t k = 0; k < 3; ++k) p[k] = corner_vector(from.positions, corner + k), hash[k] = hash_of(p[k]);
        for (uint32_t k = 0; k < 3; ++k) to_next[k] = p[(k + 1) % 3] - p[k];
        const vec3 to_last = p[2] - p[0], c = cross(to_next[0], to_last);
        const real cc = dot(c, c);
        const mask safe = is_safe(cc, dot(to_next[0], to_next[0]), dot(to_last, to_last));
        const vec3 n = c * (real(1.0f) / sqrt(cc));
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t next = (k + 1) % 3, last = (k + 2) % 3;
            real value[4] = {hash[next].low - hash[last].low, hash[next].high - hash[last].high, real(0.0f),
                             real(0.0f)};
            look(n, corner_vector(from.normals, corner + k), to_next[k], p[last] - p[k], hard, bent, value[2],
                 value[3]);
            rows.put(f, k, value);
        }
        odd |= lane_bits(!safe) << f;
    }
    return odd;
}

static void scatter(ScatterJob* job) {
    const ScatterJob asked = *job;
    scatter_faces<4, false>(
        job, [&asked](const BlockSource& from, BlockRows<4, false>& rows) { return look_rows(asked, from, rows); });
}

const LookKernels* look_kernels() {
    static constexpr LookKernels table = {scatter};
    return &table;
}

}  // namespace rakelight::geometry::RL_ISA
