// SPDX-License-Identifier: Apache-2.0
// Linear blend skinning, per instruction set: matrices are blended per vertex, everything else is vectorized.
#include "geometry/pose/skin_kernel_types.h"
#include "math/wide_rows.h"

namespace rakelight::geometry::RL_ISA {
RL_USE_WIDE;
using rakelight::wide::RL_ISA::load_rows4, rakelight::wide::RL_ISA::load_rows4_at,
    rakelight::wide::RL_ISA::load_vectors;
using rakelight::wide::RL_ISA::store_rows4;

constexpr uint32_t block = 16;  // vertices at a time, in every flavor

/// One matrix, in as many vectors as the instruction set needs.
typedef float matrix __attribute__((vector_size(joint_floats * sizeof(float)), aligned(16)));

alignas(64) static constexpr uint32_t order[block] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

static inline bool has_weight(const KernelInfluence& i) {
    return i.weights[0] != 0 || i.weights[1] != 0 || i.weights[2] != 0 || i.weights[3] != 0;
}

static inline const matrix& joint_of(const float* joints, const KernelInfluence& i, int k) {
    // Joints with weight 0 need not exist.
    return *reinterpret_cast<const matrix*>(joints + joint_floats * uint64_t(i.weights[k] != 0 ? i.joints[k] : 0));
}

static inline void weigh(const float* joints, const KernelInfluence& i, matrix& sum) {
    sum = joint_of(joints, i, 0) * i.weights[0] + joint_of(joints, i, 1) * i.weights[1] +
          joint_of(joints, i, 2) * i.weights[2] + joint_of(joints, i, 3) * i.weights[3];
}

/// @param rows  [block * joint_floats] the blended matrices
static inline void blend(const SkinJob& job, uint32_t first, float* rows) {
    for (uint32_t i = 0; i < block; ++i) {
        const KernelInfluence& influence = job.influences[first + i];
        matrix& sum = *reinterpret_cast<matrix*>(rows + joint_floats * i);
        const bool has_more = job.more_influences && has_weight(job.more_influences[first + i]);
        if (!has_more && !has_weight(influence)) {
            sum = *reinterpret_cast<const matrix*>(job.joints);
            continue;
        }
        weigh(job.joints, influence, sum);
        if (!has_more) continue;
        matrix more;
        weigh(job.joints, job.more_influences[first + i], more);
        sum = sum + more;
    }
}

struct Columns {
    vec3 x, y, z, w;
};

static inline Columns columns_of(const float* rows) {
    const float* row[lanes];
    for (int i = 0; i < lanes; ++i) row[i] = rows + joint_floats * uint64_t(i);
    real x[4], y[4], z[4], w[4];
    load_rows4_at(row, 0, x);
    load_rows4_at(row, 4, y);
    load_rows4_at(row, 8, z);
    load_rows4_at(row, 12, w);
    return {{x[0], x[1], x[2]}, {y[0], y[1], y[2]}, {z[0], z[1], z[2]}, {w[0], w[1], w[2]}};
}

static inline vec3 turned(vec3 x, vec3 y, vec3 z, vec3 d) {
    return {x.x * d.x + y.x * d.y + z.x * d.z, x.y * d.x + y.y * d.y + z.y * d.z, x.z * d.x + y.z * d.y + z.z * d.z};
}

static inline vec3 load_threes(const float* from) {
    real v[3];
    load_vectors<3, 1>(from, order, v);
    return {v[0], v[1], v[2]};
}

/// Normalizes.
/// @param odd gets lanes whose square may under- or overflow
static inline vec3 unit(vec3 v, mask& odd) {
    const real squared = v.x * v.x + v.y * v.y + v.z * v.z;
    odd = odd | !((squared > real(min_square)) & (squared < real(greatest_square)));
    const real inverse = real(1.0f) / sqrt(squared);
    return {v.x * inverse, v.y * inverse, v.z * inverse};
}

/// Stores packed triples.
/// @param to nothing is written beyond the last one
static inline void store_threes(const float* rows, float* to) {
    for (uint32_t i = 0; i + 1 < block; ++i) __builtin_memcpy(to + 3 * i, rows + 4 * i, 4 * sizeof(float));
    __builtin_memcpy(to + 3 * (block - 1), rows + 4 * (block - 1), 3 * sizeof(float));
}

static inline void skin_block(SkinJob& job, uint32_t first) {
    alignas(64) float rows[block * joint_floats], positions[4 * block], normals[4 * block];
    blend(job, first, rows);
    for (uint32_t i = 0; i < block; i += uint32_t(lanes)) {
        const Columns m = columns_of(rows + joint_floats * i);
        const uint64_t v = first + i;
        const vec3 p = turned(m.x, m.y, m.z, load_threes(job.positions + 3 * v));
        const real place[4] = {p.x + m.w.x, p.y + m.w.y, p.z + m.w.z, real(0.0f)};
        store_rows4(positions + 4 * i, place);
        if (!job.normals && !job.tangents) continue;
        const vec3 yz = cross(m.y, m.z);
        const real side = select(dot(m.x, yz) < real(0.0f), real(-1.0f), real(1.0f));
        mask odd = real(0.0f) > real(1.0f);
        if (job.normals) {  // the cofactor matrix negates normals for mirroring m
            const vec3 n = turned(yz, cross(m.z, m.x), cross(m.x, m.y), load_threes(job.normals + 3 * v));
            const vec3 u = unit({n.x * side, n.y * side, n.z * side}, odd);
            const real out[4] = {u.x, u.y, u.z, real(0.0f)};
            store_rows4(normals + 4 * i, out);
        }
        if (job.tangents) {
            real t[4];
            load_rows4(job.tangents + 4 * v, t);
            const vec3 u = unit(turned(m.x, m.y, m.z, {t[0], t[1], t[2]}), odd);
            const real out[4] = {u.x, u.y, u.z, t[3] * side};
            store_rows4(job.out_tangents + 4 * v, out);
        }
        if (no_lane(odd)) continue;
        for (uint32_t k = 0; k < uint32_t(lanes); ++k)
            if (lane_bits(odd) >> k & 1) job.odd[job.odd_count++] = uint32_t(v) + k;
    }
    store_threes(positions, job.out_positions + 3 * uint64_t(first));
    if (job.normals) store_threes(normals, job.out_normals + 3 * uint64_t(first));
}

/// The remaining vertices, padded to a block.
static void skin_rest(SkinJob& job, uint32_t first) {
    const uint32_t count = job.count - first;
    KernelInfluence influences[block] = {}, more[block] = {};
    float positions[3 * block + 1] = {}, normals[3 * block + 1] = {}, tangents[4 * block] = {};
    float out_positions[3 * block], out_normals[3 * block], out_tangents[4 * block];
    uint32_t odd[block];
    const auto copy = [=](auto* to, const auto* from, uint32_t width) {
        if (from) __builtin_memcpy(to, from + uint64_t(width) * first, width * count * sizeof(*to));
    };
    copy(influences, job.influences, 1), copy(more, job.more_influences, 1);
    copy(positions, job.positions, 3), copy(normals, job.normals, 3), copy(tangents, job.tangents, 4);
    SkinJob rest = job;
    rest.influences = influences, rest.more_influences = job.more_influences ? more : nullptr;
    rest.positions = positions, rest.normals = job.normals ? normals : nullptr;
    rest.tangents = job.tangents ? tangents : nullptr;
    rest.out_positions = out_positions, rest.out_normals = out_normals, rest.out_tangents = out_tangents;
    rest.odd = odd, rest.odd_count = 0;
    skin_block(rest, 0);
    const auto put = [=](float* to, const float* from, uint32_t width) {
        if (to) __builtin_memcpy(to + uint64_t(width) * first, from, width * count * sizeof(float));
    };
    put(job.out_positions, out_positions, 3);
    put(job.normals ? job.out_normals : nullptr, out_normals, 3);
    put(job.tangents ? job.out_tangents : nullptr, out_tangents, 4);
    for (uint32_t k = 0; k < rest.odd_count; ++k)
        if (odd[k] < count) job.odd[job.odd_count++] = first + odd[k];
}

static void skin(SkinJob& job) {
    uint32_t v = 0;
    for (; v + block < job.count; v += block) skin_block(job, v);  // reads one float beyond its block
    if (v < job.count) skin_rest(job, v);
}

const SkinKernels* skin_kernels() {
    static constexpr SkinKernels table = {skin};
    return &table;
}

}  // namespace rakelight::geometry::RL_ISA
