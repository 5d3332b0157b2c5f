// SPDX-License-Identifier: Apache-2.0
// The votes of faces, several at a time in double, per instruction set: the vote of face_vote.h, operation by
// operation, so that the bits are the same.
#include "geometry/input/vote_kernel_types.h"
#include "geometry/kernels/double_lanes.h"

namespace rakelight::geometry::RL_ISA {

RL_INLINE Three difference(const Three& a, const Three& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
RL_INLINE Three times(const Three& a, numbers s) { return {a.x * s, a.y * s, a.z * s}; }
RL_INLINE Three product(const double (&m)[3][3], const Three& v) {
    return {v.x * m[0][0] + v.y * m[1][0] + v.z * m[2][0], v.x * m[0][1] + v.y * m[1][1] + v.z * m[2][1],
            v.x * m[0][2] + v.y * m[1][2] + v.z * m[2][2]};
}
/// direction_of(): unit and length.
/// @param odd gets lanes for the scalar function
RL_INLINE Three unit(const Three& v, numbers& length, bits& odd) {
    const numbers square = dot(v, v);
    odd |= ~((square > all(1e-280)) & (square < all(1e280)));
    length = square_root(square);
    return times(v, all(1) / length);
}

/// corner_angle().
RL_INLINE numbers corner_angle(numbers y, numbers x) {
    const numbers a = x < all(0) ? -x : x;
    const bits steep = y > a;
    const numbers t = steep ? a / y : (a > all(0) ? y / a : all(0)), s = t * t;
    numbers p = all(-0.0161657367) + s * all(0.0028662257);
    p = all(0.0429096138) + s * p;
    p = all(-0.0752896400) + s * p;
    p = all(0.1065626393) + s * p;
    p = all(-0.1420889944) + s * p;
    p = all(0.1999355085) + s * p;
    p = all(-0.3333314528) + s * p;
    p = t * (all(1) + s * p);
    const numbers first = steep ? all(3.14159265358979323846 / 2) - p : p;
    return x < all(0) ? all(3.14159265358979323846) - first : first;
}

struct Corners {
    Three e1, e2;  ///< from corner 0 to 1 and to 2
};

RL_INLINE Three place(const VoteJob& job, const uint32_t* indices, uint32_t corner) {
    alignas(64) double n[3][lanes];
    for (uint32_t i = 0; i < lanes; ++i) {
        const float* p = job.positions + 3 * uint64_t(indices[3 * i + corner]);
        n[0][i] = double(p[0]), n[1][i] = double(p[1]), n[2][i] = double(p[2]);
    }
    Three v;
    __builtin_memcpy(&v.x, n[0], sizeof n[0]);
    __builtin_memcpy(&v.y, n[1], sizeof n[1]);
    __builtin_memcpy(&v.z, n[2], sizeof n[2]);
    return v;
}

RL_INLINE void texture_place(const VoteJob& job, const uint32_t* indices, uint32_t corner, numbers& u, numbers& v) {
    alignas(64) double n[2][lanes];
    for (uint32_t i = 0; i < lanes; ++i) {
        const float* q = job.texcoords + 2 * uint64_t(indices[3 * i + corner]);
        n[0][i] = double(q[0]), n[1][i] = double(q[1]);
    }
    __builtin_memcpy(&u, n[0], sizeof n[0]);
    __builtin_memcpy(&v, n[1], sizeof n[1]);
}

struct Tangent {
    Three unit;
    numbers hand;
};

/// face_tangent().
RL_INLINE Tangent tangent_of(const VoteJob& job, const uint32_t* indices, const Corners& face, bits& odd) {
    numbers u0, v0, u1, v1, u2, v2;
    texture_place(job, indices, 0, u0, v0);
    texture_place(job, indices, 1, u1, v1);
    texture_place(job, indices, 2, u2, v2);
    const numbers du1 = u1 - u0, dv1 = v1 - v0, du2 = u2 - u0, dv2 = v2 - v0;
    const numbers det = du1 * dv2 - du2 * dv1;
    const numbers sign = det > all(0) ? all(1) : (det < all(0) ? all(-1) : all(0));
    const Three along = difference(times(face.e1, dv2), times(face.e2, dv1));
    numbers length;
    bits unsafe = {};
    const Three t = unit(product(job.linear, times(along, sign)), length, unsafe);
    const bits votes = sign != all(0);
    odd |= votes & unsafe;
    const numbers none = all(0);
    return {{votes ? t.x : none, votes ? t.y : none, votes ? t.z : none}, votes ? -sign * all(job.flip) : none};
}

RL_INLINE void put(double (&to)[vote_block], uint32_t first, numbers v) { __builtin_memcpy(to + first, &v, sizeof v); }

RL_INLINE void put_corner(double (&to)[VoteBlock::numbers][vote_block], uint32_t first, const Three& normal, numbers w,
                          const Tangent* tangent) {
    put(to[VoteBlock::normal_x], first, normal.x * w);
    put(to[VoteBlock::normal_y], first, normal.y * w);
    put(to[VoteBlock::normal_z], first, normal.z * w);
    put(to[VoteBlock::weight], first, w);
    if (!tangent) return;
    put(to[VoteBlock::tangent_x], first, tangent->unit.x * w);
    put(to[VoteBlock::tangent_y], first, tangent->unit.y * w);
    put(to[VoteBlock::tangent_z], first, tangent->unit.z * w);
    put(to[VoteBlock::hand], first, tangent->hand * w);
}

/// corner_weights().
RL_INLINE void weigh(const VoteJob& job, const Corners& face, numbers area2, numbers (&w)[3], bits& odd) {
    const numbers area = all(0.5) * area2;
    if (job.weight == VoteWeight::uniform || job.weight == VoteWeight::area) {
        w[0] = w[1] = w[2] = job.weight == VoteWeight::uniform ? all(1) : area;
        return;
    }
    const Three a = product(job.linear, face.e1), b = product(job.linear, face.e2), c = difference(b, a);
    if (job.weight == VoteWeight::max) {
        const numbers aa = dot(a, a), bb = dot(b, b), cc = dot(c, c), product = aa * bb * cc, q = area2 / product;
        odd |= ~((product > all(1e-280)) & (product < all(1e280)));
        w[0] = q * cc, w[1] = q * bb, w[2] = q * aa;
        return;
    }
    w[0] = corner_angle(area2, dot(a, b));
    w[1] = corner_angle(area2, -dot(a, c));
    w[2] = corner_angle(area2, dot(b, c));
    if (job.weight == VoteWeight::angle_area) w[0] *= area, w[1] *= area, w[2] *= area;
}

RL_INLINE void vote_some(const VoteJob& job, const uint32_t* indices, uint32_t first, VoteBlock& out) {
    const Three p = place(job, indices, 0);
    const Corners face{difference(place(job, indices, 1), p), difference(place(job, indices, 2), p)};
    numbers area2;
    bits odd = {};
    const Three normal = unit(product(job.normal_to_world, cross(face.e1, face.e2)), area2, odd);
    numbers w[3];
    weigh(job, face, area2, w, odd);
    Tangent tangent;
    if (job.texcoords) tangent = tangent_of(job, indices, face, odd);
    for (uint32_t k = 0; k < 3; ++k) put_corner(out.votes[k], first, normal, w[k], job.texcoords ? &tangent : nullptr);
    for (uint32_t i = 0; i < lanes; ++i) out.is_odd[first + i] = odd[i] != 0;
}

static void vote(const VoteJob& job, VoteBlock& out) {
    uint32_t f = 0;
    for (; f + lanes <= job.count; f += lanes) vote_some(job, job.indices + 3 * f, f, out);
    if (f == job.count) return;
    uint32_t last[3 * lanes];  // the rest, padded with copies of its first face
    for (uint32_t i = 0; i < 3 * lanes; ++i) last[i] = job.indices[3 * f + (i < 3 * (job.count - f) ? i : i % 3)];
    vote_some(job, last, f, out);
}

const VoteKernels* vote_kernels() {
    static constexpr VoteKernels table = {vote};
    return &table;
}

}  // namespace rakelight::geometry::RL_ISA
