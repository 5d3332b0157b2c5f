// SPDX-License-Identifier: Apache-2.0
// The two inner loops of the fast path, per instruction set: votes of faces, and from sums to vectors.
#include "geometry/kernels/face_blocks.h"

namespace rakelight::geometry::RL_ISA {
using rakelight::wide::RL_ISA::load_rows4, rakelight::wide::RL_ISA::load_rows8;

/// corner_angle() of face_vote.h.
static inline real corner_angle(real y, real x) {
    const real a = abs(x);
    const mask steep = y > a;
    const real t = select(steep, a, y) / select(steep, y, a), s = t * t;
    real p = real(-0.0161657367f) + s * real(0.0028662257f);
    p = real(0.0429096138f) + s * p;
    p = real(-0.0752896400f) + s * p;
    p = real(0.1065626393f) + s * p;
    p = real(-0.1420889944f) + s * p;
    p = real(0.1999355085f) + s * p;
    p = real(-0.3333314528f) + s * p;
    p = t + t * s * p;
    const real first = select(steep, real(1.57079633f) - p, p);
    return select(x < real(0.0f), real(3.14159265f) - first, first);
}

/// corner_weights() of face_vote.h.
static inline void weigh(VoteWeight weight, const vec3& e1, const vec3& e2, real area2, real (&w)[3], mask& safe) {
    const real area = area2 * real(0.5f);
    if (weight == VoteWeight::area) {
        w[0] = w[1] = w[2] = area;
        return;
    }
    const vec3 e3 = e2 - e1;
    if (weight == VoteWeight::max) {
        const real a = dot(e1, e1), b = dot(e2, e2), c = dot(e3, e3), all = a * b * c, q = area2 / all;
        safe &= all > real(1e-30f) && all < real(1e30f);
        w[0] = q * c, w[1] = q * b, w[2] = q * a;
        return;
    }
    w[0] = corner_angle(area2, dot(e1, e2));
    w[1] = corner_angle(area2, -dot(e1, e3));
    w[2] = corner_angle(area2, dot(e2, e3));
    if (weight == VoteWeight::angle_area) w[0] = w[0] * area, w[1] = w[1] * area, w[2] = w[2] * area;
}

/// A unit tangent and its handedness.
struct Tangent {
    vec3 unit;
    real hand;
};
static inline Tangent tangent_of(const BlockSource& from, const uint32_t* corner, const vec3& e1, const vec3& e2,
                                 mask& safe) {
    real q[2], q1[2], q2[2];
    load_vectors<2, 3>(from.texcoords, corner, q);
    load_vectors<2, 3>(from.texcoords, corner + 1, q1);
    load_vectors<2, 3>(from.texcoords, corner + 2, q2);
    const real du1 = q1[0] - q[0], dv1 = q1[1] - q[1], du2 = q2[0] - q[0], dv2 = q2[1] - q[1];
    const real det = du1 * dv2 - du2 * dv1;
    safe &= is_safe(det * det, du1 * du1 + dv1 * dv1, du2 * du2 + dv2 * dv2);
    // dP/du = (dv2 e1 - dv1 e2) / det; cross(n, t) . dP/dv has the sign of det, the bitangent is -dP/dv.
    const real hand = select(det < real(0.0f), real(1.0f), real(-1.0f));
    const vec3 t = (e2 * dv1 - e1 * dv2) * hand;
    const real tt = dot(t, t);
    safe &= tt > real(1e-34f) && tt < real(1e34f);
    return {t * (real(1.0f) / sqrt(tt)), hand};
}

/// Unit normal and tangent of each face times the weights of its corners.
template <bool textured, int floats, bool alike>
static inline uint32_t vote_rows(VoteWeight weight, const BlockSource& from, BlockRows<floats, alike>& rows) {
    uint32_t odd = 0;
    for (uint32_t f = 0; f < face_block; f += uint32_t(lanes)) {
        const uint32_t* corner = from.index + 3 * f;
        const vec3 p = corner_vector(from.positions, corner);
        const vec3 e1 = corner_vector(from.positions, corner + 1) - p,
                   e2 = corner_vector(from.positions, corner + 2) - p;
        const vec3 c = cross(e1, e2);
        const real cc = dot(c, c), area2 = sqrt(cc);
        mask safe = is_safe(cc, dot(e1, e1), dot(e2, e2));
        const vec3 n = c * (real(1.0f) / area2);
        real value[8] = {n.x, n.y, n.z, real(1.0f), real(0.0f), real(0.0f), real(0.0f), real(1.0f)};
        if constexpr (floats == 8) value[3] = real(0.0f);
        if constexpr (textured) {
            const Tangent t = tangent_of(from, corner, e1, e2, safe);
            value[3] = t.hand, value[4] = t.unit.x, value[5] = t.unit.y, value[6] = t.unit.z;
        }
        if constexpr (alike) {
            rows.put(f, 0, value);
        } else {
            real w[3], weighed[8];
            weigh(weight, e1, e2, area2, w, safe);
            for (uint32_t k = 0; k < 3; ++k) {
                for (uint32_t i = 0; i < uint32_t(floats); ++i) weighed[i] = value[i] * w[k];
                rows.put(f, k, weighed);
            }
        }
        odd |= lane_bits(!safe) << f;
    }
    return odd;
}

template <bool textured, int floats>
static inline void scatter(ScatterJob* job) {
    if (job->weight == VoteWeight::uniform)
        scatter_faces<floats, true>(job, [](const BlockSource& from, BlockRows<floats, true>& rows) {
            return vote_rows<textured>(VoteWeight::uniform, from, rows);
        });
    else
        scatter_faces<floats, false>(job,
                                     [weight = job->weight](const BlockSource& from, BlockRows<floats, false>& rows) {
                                         return vote_rows<textured>(weight, from, rows);
                                     });
}

static void scatter_normals(ScatterJob* job) { scatter<false, normal_row_floats>(job); }
static void scatter_tangents(ScatterJob* job) {
    if (job->texcoords != nullptr)
        scatter<true, tangent_row_floats>(job);
    else
        scatter<false, tangent_row_floats>(job);
}

/// Of lanes f and following; for lanes beyond the block's count any.
static inline vec3 kept_normals(const FinishJob& job, uint32_t f, uint32_t count) {
    alignas(64) float n[3][lanes];
    for (uint32_t i = 0; i < uint32_t(lanes); ++i)
        for (uint32_t a = 0; a < 3; ++a)
            n[a][i] = f + i < count ? job.normals[3 * uint64_t(job.begin + f + i) + a] : (a == 2 ? 1.0f : 0.0f);
    return {load(n[0]), load(n[1]), load(n[2])};
}
static inline vec3 some_across(const vec3& n) {
    const vec3 v = across(n);
    return v * (real(1.0f) / sqrt(dot(v, v)));
}

/// Rows of four, of which the first three are a unit vector but for the rounding of float: one step of Newton's method in
/// double, so that it stays itself when it is normalized again.
static inline void make_units(float (&rows)[4 * face_block]) {
    for (uint32_t f = 0; f < face_block; ++f) {
        const double x = double(rows[4 * f]), y = double(rows[4 * f + 1]), z = double(rows[4 * f + 2]);
        const double scale = 1.5 - 0.5 * (x * x + y * y + z * z);
        rows[4 * f] = float(x * scale), rows[4 * f + 1] = float(y * scale), rows[4 * f + 2] = float(z * scale);
    }
}

/// From a row with tangents to tangents beside normals.
/// @return where there is one: a sum of one handedness that is not weak
static inline mask finish_tangents_of(const FinishJob& job, const real (&v)[8], const vec3& n, mask is_alone,
                                      float* to) {
    const real hand = v[3], size = abs(hand), weight = v[7];
    const vec3 t(v[4], v[5], v[6]);
    const vec3 flat = t - n * dot(n, t);
    const real across_square = dot(flat, flat);
    const mask has_tangent = size == weight && across_square >= size * size * real(job.weak_tangent * job.weak_tangent);
    vec3 unit = flat * (real(1.0f) / sqrt(across_square));
    if (job.keeps_normals) unit = select(has_tangent, unit, some_across(n));
    unit = select(is_alone, vec3(real(1.0f), real(0.0f), real(0.0f)), unit);
    const real sign = select(is_alone || hand > real(0.0f), real(1.0f), real(-1.0f));
    const real out[4] = {unit.x, unit.y, unit.z, sign};
    store_rows4(to, out);
    return has_tangent;
}

/// @param odd, alone  a bit for each vertex that is left to the general path, or has no faces
static inline void put_block(FinishJob& job, uint32_t count, uint32_t odd, uint32_t alone,
                             float (&normal)[4 * face_block], float (*tangent)[4 * face_block]) {
    const uint32_t live = count == 32 ? 0xffffffffu : (1u << count) - 1;
    job.isolated += uint32_t(__builtin_popcount(alone & live));
    for (odd &= live; odd != 0; odd &= odd - 1) job.odd[job.odd_count++] = job.begin + uint32_t(__builtin_ctz(odd));
    if (!job.keeps_normals) make_units(normal);
    float* to = job.normals + 3 * uint64_t(job.begin);
    for (uint32_t f = 0; f < count; ++f)
        for (uint32_t a = 0; a < 3; ++a) to[3 * f + a] = normal[4 * f + a];
    if (!tangent) return;
    make_units(*tangent);
    __builtin_memcpy(job.tangents + 4 * uint64_t(job.begin), *tangent, count * 16);
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
        mask good = square >= weight * weight * real(weak_normal_share * weak_normal_share) && weight >= real(0.0f) &&
                    square > real(1e-30f) && square < real(1e30f);
        vec3 n = sum * (real(1.0f) / sqrt(square));
        n = select(is_alone, vec3(real(0.0f), real(0.0f), real(1.0f)), n);
        if (job.keeps_normals) n = kept_normals(job, f, count);
        const real out[4] = {n.x, n.y, n.z, real(0.0f)};
        store_rows4(normal + 4 * f, out);
        if constexpr (floats == 8) {
            const mask has_tangent = finish_tangents_of(job, v, n, is_alone, tangent + 4 * f);
            if (textured) good = good && has_tangent;
        }
        odd |= lane_bits(!(good || is_alone)) << f;
        alone |= lane_bits(is_alone) << f;
    }
    put_block(job, count, odd, alone, normal, floats == 8 && textured ? &tangent : nullptr);
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
