// SPDX-License-Identifier: Apache-2.0
// Shadow maps: the plane of a pixel's triangle and the texels of a map, given to the lighting text
// (lighting/shadow/shadow_map.glsl). Per instruction set.
#pragma once
#include "engines/raster/kernels/pixels.h"

namespace rakelight::raster::RL_ISA {

/// Normal of each pixel's triangle, on the side that is seen.
inline vec3 plane_normal_at(const ShadeJob& job, const Pixels& p, vec3 otherwise) {
    real dx, dy, at;
    p.records.each<3>(offsetof(ShadeTriangle, depth), [&](int k, const part::real(&plane)[3]) {
        part_of(dx, k) = plane[0], part_of(dy, k) = plane[1], part_of(at, k) = plane[2];
    });
    const auto ray = [&](int i) { return vec3(real(job.ray[0][i]), real(job.ray[1][i]), real(job.ray[2][i])); };
    if (job.orthographic != 0)
        return lit::parallel_plane_normal(ray(0), ray(1), splat(job.view_direction), dx, dy, otherwise);
    return lit::plane_normal(ray(0), ray(1), ray(2), dx, dy, at, otherwise);
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
    return lit::decode_slopes(vec2(to_real(code & integer(0xffff)), to_real(shift_right_logical(code, 16))));
}

static_assert(RL_STEEPEST_SLOPE == shading::steepest_slope_on_map && RL_SLOPE_CODES == shading::slope_codes);

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
    lit::set_reach(out, real(s.bias));
    return out;
}

/// 0..1: how much of light i arrives.
inline real shadow_factor(const ShadeJob& job, int32_t i, const Pixels& p, vec3 position) {
    const int32_t map = job.lights[i].shadow;
    if (job.shadows == nullptr || map < 0) return real(1.0f);
    const ShadowView& s = job.shadows[map];
    const vec3 to_viewer = lit::to_viewer(position, splat(job.view_direction), job.orthographic);
    return lit::shadow_factor(ShadowTexels{&s}, shadow_map_of(s), position, plane_normal_at(job, p, to_viewer));
}

}  // namespace rakelight::raster::RL_ISA
