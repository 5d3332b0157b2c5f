// SPDX-License-Identifier: Apache-2.0
// The two inner loops of the fast path, per instruction set. A block of faces is staged as structures of arrays,
// computed `lanes` at a time, turned into rows and added corner by corner, in the order of the faces: bit-identical in
// every flavor.
#include "geometry/fast_kernel_types.h"
#include "math/wide_rows.h"

namespace rakelight::geometry::RL_ISA {
RL_USE_WIDE;
using rakelight::wide::RL_ISA::load_vectors, rakelight::wide::RL_ISA::load_rows4, rakelight::wide::RL_ISA::load_rows8;
using rakelight::wide::RL_ISA::store_rows4, rakelight::wide::RL_ISA::store_rows8;

typedef float Row4 __attribute__((vector_size(16), aligned(4), may_alias));
typedef float Row8 __attribute__((vector_size(32), aligned(4), may_alias));
template <int floats>
struct RowOf;
template <>
struct RowOf<4> {
    using type = Row4;
};
template <>
struct RowOf<8> {
    using type = Row8;
};

// Float is safe where sums of squares neither overflow nor come near the denormals, and where the edges are not nearly
// parallel: an angle between 7 and 173 degrees loses at most three bits of the cross product.
static inline mask is_safe(real cross_square, real square1, real square2) {
    return cross_square >= square1 * square2 * real(1.0f / 4096) && cross_square > real(1e-34f) &&
           cross_square < real(1e34f);
}

// Source of a block's corners. Vectors are loaded as four floats, so incomplete blocks, and blocks that use the last
// vertex of the mesh, read from a copy.
struct BlockCopy {
    float position[3 * 3 * face_block + 4], texcoord[2 * 3 * face_block + 4];
    uint32_t index[3 * face_block];
};

template <bool textured>
static inline void copy_block(const ScatterJob& job, const uint32_t* index, uint32_t count, BlockCopy& copy) {
    for (uint32_t i = 0; i < 3 * face_block; ++i) {
        const uint64_t v = index[i < 3 * count ? i : 0];
        copy.index[i] = i;
        for (uint32_t a = 0; a < 3; ++a) copy.position[3 * i + a] = job.positions[3 * v + a];
        if constexpr (textured)
            for (uint32_t a = 0; a < 2; ++a) copy.texcoord[2 * i + a] = job.texcoords[2 * v + a];
    }
}

static inline vec3 corner_position(const float* positions, const uint32_t* corner) {
    real v[3];
    load_vectors<3, 3>(positions, corner, v);
    return vec3(v[0], v[1], v[2]);
}
static inline vec2 corner_texcoord(const float* texcoords, const uint32_t* corner) {
    real v[2];
    load_vectors<2, 3>(texcoords, corner, v);
    return vec2(v[0], v[1]);
}

// Computes rows of the block's faces; returns a bit for each unsafe face.
template <bool textured, int floats>
static inline uint32_t face_rows(const float* positions, const float* texcoords, const uint32_t* index, float* rows) {
    uint32_t odd = 0;
    for (uint32_t f = 0; f < face_block; f += uint32_t(lanes)) {
        const uint32_t* corner = index + 3 * f;
        const vec3 p = corner_position(positions, corner);
        const vec3 e1 = corner_position(positions, corner + 1) - p, e2 = corner_position(positions, corner + 2) - p;
        const vec3 c = cross(e1, e2);
        const real cc = dot(c, c);
        mask safe = is_safe(cc, dot(e1, e1), dot(e2, e2));
        const vec3 n = c * (real(1.0f) / sqrt(cc));
        real value[8] = {n.x, n.y, n.z, real(1.0f)};
        if constexpr (floats == 8) {
            real hand(0.0f);
            vec3 t(real(0.0f));
            if constexpr (textured) {
                const vec2 q = corner_texcoord(texcoords, corner);
                const vec2 q1 = corner_texcoord(texcoords, corner + 1) - q,
                           q2 = corner_texcoord(texcoords, corner + 2) - q;
                const real du1 = q1.x, dv1 = q1.y, du2 = q2.x, dv2 = q2.y;
                const real det = du1 * dv2 - du2 * dv1;
                safe &= is_safe(det * det, du1 * du1 + dv1 * dv1, du2 * du2 + dv2 * dv2);
                // dP/du = (dv2 e1 - dv1 e2) / det; cross(n, t) . dP/dv has the sign of det, the bitangent is -dP/dv.
                hand = select(det < real(0.0f), real(1.0f), real(-1.0f));
                t = (e2 * dv1 - e1 * dv2) * hand;
                const real tt = dot(t, t);
                safe &= tt > real(1e-34f) && tt < real(1e34f);
                t = t * (real(1.0f) / sqrt(tt));
            }
            value[3] = hand;
            value[4] = t.x;
            value[5] = t.y;
            value[6] = t.z;
            value[7] = real(1.0f);
            store_rows8(rows + 8 * f, value);
        } else {
            store_rows4(rows + 4 * f, value);
        }
        odd |= lane_bits(!safe) << f;
    }
    return odd;
}

// Common case: only vertices of the own piece, and no unsafe face.
template <int floats>
static inline void add_own_block(float* own, const uint32_t* index, const float* rows) {
    using Row = typename RowOf<floats>::type;
    for (uint32_t f = 0; f < face_block; ++f) {
        const Row row = *reinterpret_cast<const Row*>(rows + uint32_t(floats) * f);
        for (uint32_t k = 0; k < 3; ++k) {
            Row* to = reinterpret_cast<Row*>(own + uint64_t(floats) * index[3 * f + k]);
            *to = *to + row;
        }
    }
}

template <int floats>
static inline void add_block(ScatterJob& job, const uint32_t* index, uint32_t count, uint32_t odd, const float* rows) {
    using Row = typename RowOf<floats>::type;
    FastParcel<floats>* parcels = static_cast<FastParcel<floats>*>(job.foreign);
    const uint32_t own_begin = job.own_begin, own_size = job.own_end - own_begin;
    for (uint32_t f = 0; f < count; ++f) {
        if ((odd >> f & 1) != 0) {
            job.odd[job.odd_count++] = job.face + f;
            continue;
        }
        const Row row = *reinterpret_cast<const Row*>(rows + uint32_t(floats) * f);
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t v = index[3 * f + k];
            if (v - own_begin < own_size) {
                Row* to = reinterpret_cast<Row*>(job.rows + uint64_t(floats) * v);
                *to = *to + row;
            } else {
                FastParcel<floats>& parcel = parcels[job.foreign_count++];
                parcel.vertex = v;
                *reinterpret_cast<Row*>(parcel.row) = row;
            }
        }
    }
}

template <bool textured, int floats>
static inline bool scatter_block(ScatterJob& job) {
    const uint32_t count = job.face_end - job.face < face_block ? job.face_end - job.face : face_block;
    const uint32_t* index = job.indices + 3 * uint64_t(job.face);
    uint32_t largest = 0, smallest = 0xffffffffu;
    if (count == face_block) {
        for (uint32_t i = 0; i < 3 * face_block; ++i) {
            largest = index[i] > largest ? index[i] : largest;
            smallest = index[i] < smallest ? index[i] : smallest;
        }
    } else {
        for (uint32_t i = 0; i < 3 * count; ++i) largest = index[i] > largest ? index[i] : largest;
        for (uint32_t i = 0; i < 3 * count; ++i) smallest = index[i] < smallest ? index[i] : smallest;
    }
    job.largest = largest > job.largest ? largest : job.largest;
    job.smallest = smallest < job.smallest ? smallest : job.smallest;
    if (largest >= job.vertices) {
        job.is_index_bad = true;
        return false;
    }
    job.wanted_end = largest < job.own_end ? largest + 1 : job.own_end;
    if (job.wanted_end > job.ready_end) return false;
    alignas(64) float rows[face_block * floats];
    uint32_t odd;
    if (count == face_block && largest + 1 < job.vertices) {
        odd = face_rows<textured, floats>(job.positions, job.texcoords, index, rows);
    } else {
        BlockCopy copy;
        copy_block<textured>(job, index, count, copy);
        odd = face_rows<textured, floats>(copy.position, copy.texcoord, copy.index, rows);
    }
    if (odd == 0 && count == face_block && smallest >= job.own_begin && largest < job.own_end)
        add_own_block<floats>(job.rows, index, rows);
    else
        add_block<floats>(job, index, count, odd, rows);
    job.face += count;
    return true;
}

template <bool textured, int floats>
static void scatter(ScatterJob* given) {
    ScatterJob job = *given;  // on this thread's own stack
    while (job.face < job.face_end && job.foreign_count + 3 * face_block <= parcel_capacity &&
           job.odd_count + face_block <= odd_capacity && scatter_block<textured, floats>(job)) {
    }
    *given = job;
}

static void scatter_normals(ScatterJob* job) { scatter<false, normal_row_floats>(job); }
static void scatter_tangents(ScatterJob* job) {
    if (job->texcoords != nullptr)
        scatter<true, tangent_row_floats>(job);
    else
        scatter<false, tangent_row_floats>(job);
}

template <int floats>
static inline void finish_block(FinishJob& job, const float* rows, uint32_t count, bool textured) {
    alignas(64) float normal[4 * face_block], tangent[4 * face_block];
    uint32_t odd = 0, alone = 0;
    for (uint32_t f = 0; f < face_block; f += uint32_t(lanes)) {
        real v[8];
        if constexpr (floats == 8)
            load_rows8(rows + 8 * f, v);
        else
            load_rows4(rows + 4 * f, v);
        const real weight = v[floats - 1];
        const vec3 sum(v[0], v[1], v[2]);
        const real square = dot(sum, sum);
        const mask is_alone = weight == real(0.0f);
        mask good = square >= weight * weight * real(weak_normal_share * weak_normal_share) && weight >= real(0.0f);
        vec3 n = sum * (real(1.0f) / sqrt(square));
        n = select(is_alone, vec3(real(0.0f), real(0.0f), real(1.0f)), n);
        const real out[4] = {n.x, n.y, n.z, real(0.0f)};
        store_rows4(normal + 4 * f, out);
        if constexpr (floats == 8) {
            const real hand = v[3], size = abs(hand);
            const vec3 t(v[4], v[5], v[6]);
            const vec3 across = t - n * dot(n, t);
            const real across_square = dot(across, across);
            const mask has_tangent =
                size == weight && across_square >= size * size * real(weak_tangent_share * weak_tangent_share);
            if (textured) good = good && has_tangent;
            vec3 unit = across * (real(1.0f) / sqrt(across_square));
            unit = select(is_alone, vec3(real(1.0f), real(0.0f), real(0.0f)), unit);
            const real sign = select(is_alone || hand > real(0.0f), real(1.0f), real(-1.0f));
            const real out_t[4] = {unit.x, unit.y, unit.z, sign};
            store_rows4(tangent + 4 * f, out_t);
        }
        odd |= lane_bits(!(good || is_alone)) << f;
        alone |= lane_bits(is_alone) << f;
    }
    const uint32_t live = count == 32 ? 0xffffffffu : (1u << count) - 1;
    odd &= live;
    job.isolated += uint32_t(__builtin_popcount(alone & live));
    for (; odd != 0; odd &= odd - 1) job.odd[job.odd_count++] = job.begin + uint32_t(__builtin_ctz(odd));
    float* to = job.normals + 3 * uint64_t(job.begin);
    for (uint32_t f = 0; f < count; ++f)
        for (uint32_t a = 0; a < 3; ++a) to[3 * f + a] = normal[4 * f + a];
    if (floats == 8 && textured) __builtin_memcpy(job.tangents + 4 * uint64_t(job.begin), tangent, count * 16);
}

template <int floats>
static void finish(FinishJob* given) {
    FinishJob job = *given;
    while (job.begin < job.end && job.odd_count + face_block <= odd_capacity) {
        const uint32_t count = job.end - job.begin < face_block ? job.end - job.begin : face_block;
        const float* rows = job.rows + uint64_t(floats) * job.begin;
        alignas(64) float last[face_block * floats];
        if (count < face_block) {
            for (uint32_t i = 0; i < face_block * floats; ++i) last[i] = i < count * floats ? rows[i] : 0.0f;
            rows = last;
        }
        finish_block<floats>(job, rows, count, job.tangents != nullptr);
        job.begin += count;
    }
    *given = job;
}

static void finish_normals(FinishJob* job) { finish<normal_row_floats>(job); }
static void finish_tangents(FinishJob* job) { finish<tangent_row_floats>(job); }

const FastKernels* fast_kernels() {
    static constexpr FastKernels table = {scatter_normals, scatter_tangents, finish_normals, finish_tangents};
    return &table;
}

}  // namespace rakelight::geometry::RL_ISA
