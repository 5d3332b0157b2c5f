// SPDX-License-Identifier: Apache-2.0
// The door to the lighting equations for kernels that are compiled per instruction set (rl_add_isa_sources); includes
// math/wide.h. The text itself is GLSL and C++ at once (*.glsl), here inside `rakelight::lighting::RL_ISA`.
//
// Entry points (real, mask, vec3 are wide; everything pure, noexcept, no memory):
//   unlit(base_color, emission)                             -> radiance
//   decode_normal(texel, scale), decode_normal_centered     -> tangent-space normal, not unit (light_sum never sees it)
//   decode_twice_normal(2 texel)                            -> the same as decode_normal(texel, 1)
//   orthogonal_tangent(n, t)                                -> unit tangent across n (Gram-Schmidt)
//   perturb_normal(n, t, w, m)                              -> unit normal: t m.x + cross(n, t) w m.y + n m.z
//   height_slope, bumped_normal(slope_t, slope_b)           -> tangent-space normal of a height map, not unit
//   relief_run, first_layer, refined_height, relief_light   -> where rays meet a height map: parallax.glsl
//   sample_light(parameters, position)                      -> LightSample: l, attenuation and colors at that point
//   range_of(parameters, position)                          -> 0..1 for classical lights with a range
//   end_at_range(sample, parameters, position)              -> the sample, times that where there is one
//   add_light(sum, surface, sample, reflection)             -> sum + the light's ambient + diffuse + specular
//   light_terms(surface, sample, reflection)                -> the three terms apart
//   lobe_scale(exponent, reflection)                        -> a surface's energy factor, for all its lights
//   fan_width, facet_ray(n, t, v, width, place)            -> FacetRay: where a brushed surface mirrors its
//   surroundings fog_factor(kind, distance, start, end, density)         -> what is left of a color behind fog
//   lambert_brdf, phong_brdf, blinn_phong_brdf, ..._lobe    -> the models themselves [1/sr], [1]
//
// A pixel: Surface s {n, v, k_a, k_d, k_s, exponent, lobe_scale}; Reflection r {RL_BLINN_PHONG, RL_TEXTBOOK, 1};
//          vec3 sum = emission; for each light in the scene's order: sum = add_light(sum, s, sample_light(light, p),
//          r);
// n, v unit and away from the surface, n on the viewer's side (the caller flips it for back faces of double-sided
// materials); position in the space of the lights. Degenerate vectors give black or a fallback, never NaN, as long as
// colors are finite. Model, form and light kind are uniform: one run of pixels of one material.
#include "lighting/light_parameters.h"
#include "math/wide.h"

namespace rakelight::lighting::RL_ISA {

// clang-format off
#include "lighting/prelude.h"
// the order of all.glsl.list
#include "lighting/lambert.glsl"
#include "lighting/phong.glsl"
#include "lighting/blinn_phong.glsl"
#include "lighting/unlit.glsl"
#include "lighting/oren_nayar.glsl"
#include "lighting/ward.glsl"
#include "lighting/ggx.glsl"
#include "lighting/facet_fan.glsl"
#include "lighting/clearcoat.glsl"
#include "lighting/sheen.glsl"
#include "lighting/normal_map.glsl"
#include "lighting/height_bump.glsl"
#include "lighting/parallax.glsl"
#include "lighting/attenuation.glsl"
#include "lighting/light_sum.glsl"
#include "lighting/surface_terms.glsl"
#include "lighting/fog.glsl"
// clang-format on

/// Three floats for all lanes.
RL_FN vec3 broadcast3(const float (&a)[3]) { return vec3(broadcast(a[0]), broadcast(a[1]), broadcast(a[2])); }

RL_FN ClassicalLight classical_light(const LightParameters& p) {
    ClassicalLight light;
    light.type = int(p.kind);
    light.position = broadcast3(p.position);
    light.direction = broadcast3(p.direction);
    light.ambient = broadcast3(p.ambient);
    light.diffuse = broadcast3(p.diffuse);
    light.specular = broadcast3(p.specular);
    light.constant_term = broadcast(p.constant_term);
    light.linear_term = broadcast(p.linear_term);
    light.quadratic_term = broadcast(p.quadratic_term);
    light.cos_cutoff = broadcast(p.cos_cutoff);
    light.exponent = broadcast(p.exponent);
    return light;
}

RL_FN PhotometricLight photometric_light(const LightParameters& p) {
    PhotometricLight light;
    light.type = int(p.kind);
    light.position = broadcast3(p.position);
    light.direction = broadcast3(p.direction);
    light.intensity = broadcast3(p.intensity);
    light.inverse_range = broadcast(p.inverse_range);
    light.cone_scale = broadcast(p.cone_scale);
    light.cone_offset = broadcast(p.cone_offset);
    return light;
}

/// The light as the points `position` meet it.
RL_FN LightSample sample_light(const LightParameters& p, vec3 position) {
    if (p.is_photometric) return sample_photometric(photometric_light(p), position);
    return sample_classical(classical_light(p), position);
}

RL_FN bool has_classical_range(const LightParameters& p) {
    return !p.is_photometric && p.inverse_range > 0.0f && (p.kind == LightKind::point || p.kind == LightKind::spot);
}

/// What the attenuation of sample_light() is to be multiplied by, where a classical light has a range.
RL_FN real range_of(const LightParameters& p, vec3 position) {
    const vec3 to_light = broadcast3(p.position) - position;
    return range_window(dot(to_light, to_light), broadcast(p.inverse_range));
}

/// sample_light(), and what its classical lights lack: their end.
RL_FN LightSample end_at_range(LightSample light, const LightParameters& p, vec3 position) {
    if (has_classical_range(p)) light.attenuation = light.attenuation * range_of(p, position);
    return light;
}

}  // namespace rakelight::lighting::RL_ISA
