// SPDX-License-Identifier: Apache-2.0
// Perspective-correct attributes of a run of pixels, and their analytic screen derivatives. Per instruction set.
#pragma once
#include "engines/raster/kernel_types.h"
#include "math/wide.h"

namespace rakelight::raster::RL_ISA {
RL_USE_WIDE;

/// Numbers of the triangles' records, one record a lane. Where all lanes have the same triangle (most runs) they are
/// broadcast instead of gathered; the values are the same.
struct Records {
    const float* base;
    integer offset;   ///< of each lane's record
    bool is_uniform;

    Records(const ShadeTriangle* triangles, integer triangle)
        : Records(reinterpret_cast<const float*>(triangles), shade_triangle_floats, triangle) {}
    /// Records of `floats` floats each.
    Records(const float* records, int32_t floats, integer triangle) {
        const int32_t first = lane(triangle, 0);
        is_uniform = all_lanes(triangle == integer(first));
        base = records + (is_uniform ? int64_t(first) * floats : 0);
        offset = triangle * integer(floats);
    }
    real operator()(size_t member_offset) const {
        const int32_t k = int32_t(member_offset / sizeof(float));
        return is_uniform ? broadcast(base[k]) : gather(base, offset + integer(k));
    }
};

/// Where a pixel lies in its triangle, and how that changes from pixel to pixel: b0 = 1 - b1 - b2.
struct Barycentrics {
    real b1, b2;
    real b1_dx, b1_dy, b2_dx, b2_dy;
};

inline Barycentrics barycentrics(const Records& r, real x, real y) {
    real e[3], ex[3], ey[3];
    for (size_t k = 0; k < 3; ++k) {
        ex[k] = r(offsetof(ShadeTriangle, ex) + k * sizeof(float));
        ey[k] = r(offsetof(ShadeTriangle, ey) + k * sizeof(float));
        e[k] = ex[k] * x + ey[k] * y + r(offsetof(ShadeTriangle, e0) + k * sizeof(float));
    }
    const real sum = e[0] + e[1] + e[2];
    const mask is_in_front = sum > real(0.0f);
    const real inverse = reciprocal(select(is_in_front, sum, real(1.0f)));
    const real sum_x = ex[0] + ex[1] + ex[2], sum_y = ey[0] + ey[1] + ey[2];
    Barycentrics b;
    const real b1 = e[1] * inverse, b2 = e[2] * inverse;
    b.b1_dx = (ex[1] - b1 * sum_x) * inverse;
    b.b1_dy = (ey[1] - b1 * sum_y) * inverse;
    b.b2_dx = (ex[2] - b2 * sum_x) * inverse;
    b.b2_dy = (ey[2] - b2 * sum_y) * inverse;
    // A pixel whose center lies in the snapped triangle may lie just outside the true one; a sliver would throw its
    // attributes far out. They stay in the triangle.
    b.b1 = clamp(b1, real(0.0f), real(1.0f));
    b.b2 = clamp(b2, real(0.0f), real(1.0f) - b.b1);
    return b;
}

inline real interpolate(const Records& r, const Barycentrics& b, size_t member_offset, size_t stride) {
    const size_t step = stride * sizeof(float);
    return r(member_offset) + b.b1 * r(member_offset + step) + b.b2 * r(member_offset + 2 * step);
}

inline vec3 interpolate3(const Records& r, const Barycentrics& b, size_t member_offset) {
    return vec3(interpolate(r, b, member_offset, 3), interpolate(r, b, member_offset + sizeof(float), 3),
                interpolate(r, b, member_offset + 2 * sizeof(float), 3));
}

inline vec4 interpolate_color(const Records& r, const Barycentrics& b) {
    const size_t at = offsetof(ShadeTriangle, color);
    return vec4(interpolate(r, b, at, 4), interpolate(r, b, at + 4, 4), interpolate(r, b, at + 8, 4), interpolate(r, b, at + 12, 4));
}

/// Texture coordinates with their change from pixel to pixel.
struct TexCoords {
    vec2 uv, dx, dy;
};

inline TexCoords texcoords(const Records& r, const Barycentrics& b, int set) {
    const size_t at = set == 0 ? offsetof(ShadeTriangle, texcoord0) : offsetof(ShadeTriangle, texcoord1);
    real value[2], dx[2], dy[2];
    for (size_t c = 0; c < 2; ++c) {
        const real a0 = r(at + 4 * c), d1 = r(at + 8 + 4 * c), d2 = r(at + 16 + 4 * c);
        value[c] = a0 + b.b1 * d1 + b.b2 * d2;
        dx[c] = b.b1_dx * d1 + b.b2_dx * d2;
        dy[c] = b.b1_dy * d1 + b.b2_dy * d2;
    }
    return {vec2(value[0], value[1]), vec2(dx[0], dx[1]), vec2(dy[0], dy[1])};
}

}  // namespace rakelight::raster::RL_ISA
