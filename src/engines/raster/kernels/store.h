// SPDX-License-Identifier: Apache-2.0
// Colors of a run of pixels -> arrays of floats or sRGB codes. Per instruction set.
#pragma once
#include "engines/raster/kernel_types.h"
#include "math/wide.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;

/// What is not finite becomes 0 and is counted, in the first `alive` lanes.
inline real only_finite(real v, int32_t alive, int32_t& not_finite) {
    const mask is_finite = v - v == real(0.0f);
    if (all_lanes(is_finite)) return v;
    not_finite += __builtin_popcount(lane_bits(!is_finite) & ((uint32_t(2) << (alive - 1)) - 1));
    return select(is_finite, v, real(0.0f));
}

/// Linear -> correctly rounded sRGB codes, in bits 16 to 23 (those below are anything): SrgbEncoder
/// (image/srgb_encoder.h) for a vector.
inline integer srgb8(const uint32_t* table, real linear) {
    const integer bits = bits_of(min(max(linear, real(0.0f)), real(srgb_highest)));
    return gather_i(table, shift_right_logical(bits, srgb_bucket_bits)) + (bits & integer(0xffff));
}

inline void store_colors(const ShadeJob& job, int32_t first, vec3 radiance, real alpha) {
    if (job.srgb8 == nullptr) {
        store(job.red + first, radiance.x);
        store(job.green + first, radiance.y);
        store(job.blue + first, radiance.z);
        store(job.alpha + first, alpha);
        return;
    }
    const integer codes = shift_right_logical(srgb8(job.srgb_table, radiance.x), 16) |
                          (shift_right_logical(srgb8(job.srgb_table, radiance.y), 8) & integer(0xff00)) |
                          (srgb8(job.srgb_table, radiance.z) & integer(0xff0000)) | integer(int32_t(0xff000000u));
    store(reinterpret_cast<int32_t*>(job.srgb8 + first), codes);
}

/// With 0 for what is not finite. @return how many components were not
inline int32_t store_finite(const ShadeJob& job, int32_t first, vec3 radiance, real alpha) {
    int32_t not_finite = 0;
    const int32_t alive = job.count - first < lanes ? job.count - first : lanes;
    const real sum = radiance.x + radiance.y + radiance.z;
    if (!all_lanes(sum - sum == real(0.0f))) {
        radiance.x = only_finite(radiance.x, alive, not_finite);
        radiance.y = only_finite(radiance.y, alive, not_finite);
        radiance.z = only_finite(radiance.z, alive, not_finite);
    }
    store_colors(job, first, radiance, alpha);
    return not_finite;
}

inline void store_normal(const ShadeJob& job, int32_t first, vec3 n) {
    store(job.normal_x + first, n.x);
    store(job.normal_y + first, n.y);
    store(job.normal_z + first, n.z);
}

}  // namespace rakelight::raster::RL_ISA
