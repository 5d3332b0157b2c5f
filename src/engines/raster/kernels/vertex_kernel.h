// SPDX-License-Identifier: Apache-2.0
// Object space -> clip space -> screen, a vector of vertices at a time. Per instruction set.
#pragma once
#include "engines/raster/kernels/clip_planes.h"
#include "engines/raster/kernels/geometry_types.h"
#include "math/wide_double.h"
#include "math/wide_rows.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;
using wide::RL_ISA::load_vectors;
using wide::RL_ISA::real_double;
using wide::RL_ISA::store_rows4;
using wide::RL_ISA::to_double;

inline integer bit_where(mask m, uint32_t bit) { return select(m, integer(int32_t(bit)), integer(0)); }

/// outcode() of clip.cpp, lane by lane.
inline integer outcodes(const VertexJob& job, real x, real y, real w, real distance) {
    const real most(3.40282347e38f);
    const mask inside =
        distance >= real(job.z_near) && distance <= min(real(job.z_far), most) && abs(x) <= min(w, most) && abs(y) <= w;
    if (all_lanes(inside)) return integer(0);
    const real gx = real(job.guard_x) * w, gy = real(job.guard_y) * w;
    integer code =
        bit_where(!(distance >= real(job.z_near)), clip_near) | bit_where(!(distance <= real(job.z_far)), clip_far);
    code = code | bit_where(!(x >= -w), clip_left) | bit_where(!(x <= w), clip_right);
    code = code | bit_where(!(y >= -w), clip_bottom) | bit_where(!(y <= w), clip_top);
    code = code | bit_where(!(x >= -gx), clip_guard_left) | bit_where(!(x <= gx), clip_guard_right);
    code = code | bit_where(!(y >= -gy), clip_guard_bottom) | bit_where(!(y <= gy), clip_guard_top);
    const mask finite = abs(x) <= most && abs(y) <= most && abs(w) <= most && abs(distance) <= most;
    return select(finite, code, integer(int32_t(outside_all)));
}

struct Snapped {
    integer at, fine;
};

/// snap_to_screen() of transform.cpp.
inline Snapped snap(real_double v, double scale, double offset) {
    const real_double at =
        min(max(v * real_double(scale) + real_double(offset), real_double(snap_lowest)), real_double(snap_highest));
    const integer whole = to_int(at);
    return {whole - integer(snap_origin), to_int((at - to_double(whole)) * real_double(double(1 << fine_bits)))};
}

inline void transform_vector(const VertexJob& job, int32_t first) {
    static constexpr uint32_t in_turn[16] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    real p[3];
    if (first + lanes < job.total) {  // a vector of three floats is read as four
        load_vectors<3, 1>(job.positions + 3 * first, in_turn, p);
    } else {
        const integer at = min(lane_indices() + integer(first), integer(job.count - 1)) * integer(3);
        for (int c = 0; c < 3; ++c) p[c] = gather(job.positions + c, at);
    }
    real to[3];
    for (int r = 0; r < 3; ++r) {
        const float(&m)[4] = job.to_clip[r];
        to[r] = real(m[0]) * p[0] + real(m[1]) * p[1] + real(m[2]) * p[2] + real(m[3]);
    }
    const real distance = to[2], w = job.orthographic != 0 ? real(1.0f) : distance;
    const real clip[4] = {to[0], to[1], w, distance};
    store_rows4(job.clip + 4 * first, clip);

    const integer code = outcodes(job, to[0], to[1], w, distance);
    const mask is_kept = (code & integer(int32_t(cutting_planes))) == integer(0);
    const real one(1.0f), zero(0.0f);
    const real_double inverse = real_double(1.0) / to_double(select(is_kept, w, one));
    const Snapped x = snap(to_double(select(is_kept, to[0], zero)) * inverse, job.scale_x, job.offset_x);
    const Snapped y = snap(to_double(select(is_kept, to[1], zero)) * inverse, job.scale_y, job.offset_y);
    const real_double towards = job.orthographic != 0 ? to_double(select(is_kept, distance, zero)) : inverse;
    const real key = to_real(min(
        max(towards * real_double(job.key_scale) + real_double(job.key_offset), real_double(0.0)), real_double(1.0)));
    const integer nothing(0), bits = code | x.fine << outcode_bits | y.fine << (outcode_bits + fine_bits);
    const real screen[4] = {real_from_bits(select(is_kept, x.at, nothing)),
                            real_from_bits(select(is_kept, y.at, nothing)), select(is_kept, key, zero),
                            real_from_bits(bits)};
    store_rows4(reinterpret_cast<float*>(job.screen + first), screen);
}

static void transform(const VertexJob* given) {
    const VertexJob job = *given;
    for (int32_t i = 0; i < job.count; i += lanes) transform_vector(job, i);
}

}  // namespace rakelight::raster::RL_ISA
