// SPDX-License-Identifier: Apache-2.0
// Shadow maps: the plane of a pixel's triangle and the texels of a map, given to the lighting text
// (lighting/shadow/shadow_map.glsl). Per instruction set.
#pragma once
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

/// Normal of the triangle's plane, unit, on the side that is seen: from the plane of 1 / w (or of the depth) over the
/// screen. `otherwise` where the plane is seen from its edge.
inline vec3 plane_normal(const ShadeJob& job, const Pixels& p, vec3 otherwise) {
    real dx, dy, at;
    p.records.each<3>(offsetof(ShadeTriangle, depth), [&](int k, const part::real(&plane)[3]) {
        part_of(dx, k) = plane[0], part_of(dy, k) = plane[1], part_of(at, k) = plane[2];
    });
    const float(&r)[3][3] = job.ray;
    const vec3 x = vec3(real(r[0][0]), real(r[1][0]), real(r[2][0])),
               y = vec3(real(r[0][1]), real(r[1][1]), real(r[2][1])),
               first = vec3(real(r[0][2]), real(r[1][2]), real(r[2][2]));
    if (job.orthographic != 0) {  // two ways along the plane
        const vec3 back = splat(job.view_direction);
        const vec3 n = safe_normalize_or(cross(y - back * dy, x - back * dx), otherwise);
        return n * select(dot(n, back) < real(0.0f), real(-1.0f), real(1.0f));
    }
    // n . ray = 1 / w at all pixels, so n . position = 1: n points away from the eye.
    const vec3 yf = cross(y, first);
    const real per_volume = reciprocal(dot(x, yf));
    const vec3 n = (yf * dx + cross(first, x) * dy + cross(x, y) * at) * per_volume;
    return -safe_normalize_or(n, -otherwise);
}

/// A light's map as the lighting text reads it.
struct ShadowTexels {
    const ShadowView* view;
    integer texel(real column, real row) const { return to_int(row) * integer(view->size) + to_int(column); }
};

inline real fetch_nearness(const ShadowTexels& maps, real column, real row) {
    return gather(maps.view->nearness, maps.texel(column, row));
}

inline vec2 fetch_slopes(const ShadowTexels& maps, real column, real row) {
    const integer code = gather_i(maps.view->slopes, maps.texel(column, row));
    const real scale(1.0f / slope_codes), most(steepest_slope_on_map);
    return vec2(to_real(code & integer(0xffff)) * scale - most, to_real(shift_right_logical(code, 16)) * scale - most);
}

static_assert(RL_STEEPEST_SLOPE == steepest_slope_on_map);

inline lit::ShadowMap shadow_map_of(const ShadowView& s) {
    const auto row = [&](int i) {
        return vec3(real(s.to_light[i][0]), real(s.to_light[i][1]), real(s.to_light[i][2]));
    };
    lit::ShadowMap out;
    out.size = s.size;
    out.is_cube = s.faces == 6;
    out.is_parallel = s.is_orthographic;
    out.radius = s.filter;
    out.right = row(0), out.up = row(1), out.ahead = row(2);
    out.origin = vec3(real(s.to_light[0][3]), real(s.to_light[1][3]), real(s.to_light[2][3]));
    out.texels = real(s.texels);
    out.texel = real(1.0f / s.texels);
    out.push = real(0.5f * s.bias / s.texels);
    out.reach = real(2.0f * steepest_slope_on_map * float(s.filter + 1) / s.texels);
    return out;
}

/// 0..1: how much of light i arrives.
inline real shadow_factor(const ShadeJob& job, int32_t i, const Pixels& p) {
    const int32_t map = job.lights[i].shadow;
    if (job.full->shadows == nullptr || map < 0) return real(1.0f);
    const ShadowView& s = job.full->shadows[map];
    return lit::shadow_factor(ShadowTexels{&s}, shadow_map_of(s), p.position,
                              plane_normal(job, p, to_viewer(job, p.position)));
}

}  // namespace rakelight::raster::RL_ISA
