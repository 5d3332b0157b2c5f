// SPDX-License-Identifier: Apache-2.0
// Colors of a run of pixels -> arrays of floats or sRGB codes. Per instruction set.
#pragma once
#include "cpu_shading/kernels/finite.h"
#include "engines/raster/kernels/kernel_types.h"
#include "math/wide.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;
using cpu_shading::RL_ISA::only_finite;

/// Linear -> correctly rounded sRGB codes, in bits 16 to 23 (those below are anything): SrgbEncoder
/// (image/srgb_encoder.h) for a vector.
inline integer srgb8(const uint32_t* table, real linear) {
    const integer bits = bits_of(min(max(linear, real(0.0f)), real(srgb_highest)));
    return gather_i(table, shift_right_logical(bits, srgb_bucket_bits)) + (bits & integer(0xffff));
}

/// To their pixels: a whole block of the tile, which most vectors are, row by row.
inline void store_codes(const DisplayPixels& to, const int32_t* pixels, int32_t count, integer codes) {
    constexpr int32_t columns = lanes < block_side ? lanes : block_side;
    constexpr int32_t rows = lanes / columns < block_side ? lanes / columns : block_side, part = rows * columns;
    constexpr int32_t last = (rows - 1) * tile_size + columns - 1;  // its bits are places in a block
    int32_t code[lanes];
    store(code, codes);
    for (int32_t i = 0; i < lanes; i += part) {
        const int32_t* const pixel = pixels + i;
        const auto at = [&](int32_t p) { return to.srgb8 + (p >> tile_bits) * to.stride + (p & (tile_size - 1)); };
        const int32_t alive = count - i;
        if (alive >= part && (pixel[0] & last) == 0 && pixel[part - 1] == pixel[0] + last) {
            uint32_t* const block = at(pixel[0]);
            for (int32_t row = 0; row < rows; ++row)
                __builtin_memcpy(block + row * to.stride, code + i + row * columns, columns * sizeof(int32_t));
        } else {
            for (int32_t k = 0; k < part && k < alive; ++k) *at(pixel[k]) = uint32_t(code[i + k]);
        }
    }
}

/// @param pixels  [count] of them, as in ShadeJob; of the others nothing is stored
inline void store_display(const DisplayPixels& to, const int32_t* pixels, int32_t count, vec3 radiance) {
    const integer codes = shift_right_logical(srgb8(to.table, radiance.x), 16) |
                          (shift_right_logical(srgb8(to.table, radiance.y), 8) & integer(0xff00)) |
                          (srgb8(to.table, radiance.z) & integer(0xff0000)) | integer(int32_t(0xff000000u));
    store_codes(to, pixels, count, codes);
}

inline void store_colors(const ShadeJob& job, int32_t first, vec3 radiance, real alpha) {
    if (job.display.srgb8 != nullptr) return store_display(job.display, job.pixel + first, job.count - first, radiance);
    store(job.red + first, radiance.x);
    store(job.green + first, radiance.y);
    store(job.blue + first, radiance.z);
    store(job.alpha + first, alpha);
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
