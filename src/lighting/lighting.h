// SPDX-License-Identifier: Apache-2.0
// The lighting equations for kernels that are compiled per instruction set (rl_add_isa_sources). Includes
// math/wide.h. The equations are text that is both GLSL and C++ (*.glsl), here inside `rakelight::lighting::RL_ISA`.
//
// The folders, in the order in which a pixel needs them (real, mask, vec3 are wide; all functions are pure, noexcept
// and allocate nothing):
//   models/       the BRDFs and lobes, one file each: lambert_brdf, blinn_phong_brdf, ggx_brdf, sheen_brdf, ...
//   light/        sample_light(parameters, position) -> LightSample; to_viewer; fog_factor, behind_fog
//   relief/       bump_frame -> Frame; decode_mapped, mapped_normal; relief_point, filtered_slope, relief_shadow
//   material/     factors and texels -> Surface, MaterialSurface: set_metallic_reflectance, set_even_widths, set_normals,
//                 set_pbr_albedos, ...; light_terms, add_light (classical), surface_terms (all models); lobe_shares,
//                 sample_surface, surface_pdf (paths)
//   environment/  irradiance, mirrored, environment_terms, sky_color
//   shadow/       shadow_factor(maps, map, position, normal) -> 0..1
// Functions that read maps take `maps`, a struct of the caller's with sample_height(maps, uv, level),
// sample_environment(), sample_sky(), sample_behind(), sample_albedo(maps, table, x, y), fetch_nearness(maps, column, row), fetch_slopes()
// beside it, as far as they are needed.
//
// A pixel: Surface s {n, v, k_a, k_d, k_s, exponent, lobe_scale}; Reflection r {RL_BLINN_PHONG, RL_TEXTBOOK, 1};
//          vec3 sum = emission; for each light in the scene's order:
//              sum = add_light(sum, s, sample_light(light, p), r);
//
// The unit vectors n and v point away from the surface. The normal n is on the viewer's side: the caller flips it for
// back faces of double-sided materials. The position p is in the space of the lights. Degenerate vectors give black or
// a fallback, never NaN, as long as colors are finite. Model, form and light kind are uniform: one run of pixels of one
// material.
#pragma once
#include "lighting/light_parameters.h"
#include "math/wide.h"

namespace rakelight::lighting::RL_ISA {

// clang-format off
#include "math/prelude.h"
// the order of all.glsl.list
#include "lighting/models/sampling.glsl"
#include "lighting/models/lambert.glsl"
#include "lighting/models/phong.glsl"
#include "lighting/models/blinn_phong.glsl"
#include "lighting/models/unlit.glsl"
#include "lighting/models/oren_nayar.glsl"
#include "lighting/models/oren_nayar_full.glsl"
#include "lighting/models/ward.glsl"
#include "lighting/models/ggx.glsl"
#include "lighting/models/clearcoat.glsl"
#include "lighting/models/sheen.glsl"
#include "lighting/models/dielectric.glsl"
#include "lighting/models/iridescence.glsl"
#include "lighting/light/attenuation.glsl"
#include "lighting/light/sample_light.glsl"
#include "lighting/light/viewer.glsl"
#include "lighting/light/fog.glsl"
#include "lighting/material/probes.glsl"
#include "lighting/relief/normal_map.glsl"
#include "lighting/relief/frame.glsl"
#include "lighting/relief/height_bump.glsl"
#include "lighting/relief/parallax.glsl"
#include "lighting/relief/relief.glsl"
#include "lighting/material/surface.glsl"
#include "lighting/material/light_sum.glsl"
#include "lighting/material/reflectance.glsl"
#include "lighting/material/albedo.glsl"
#include "lighting/material/lobe.glsl"
#include "lighting/material/directions.glsl"
#include "lighting/material/around.glsl"
#include "lighting/material/surface_terms.glsl"
#include "lighting/material/sample_surface.glsl"
#include "lighting/material/point.glsl"
#include "lighting/material/transport.glsl"
#include "lighting/material/transmission.glsl"
#include "lighting/environment/irradiance.glsl"
#include "lighting/environment/anisotropic_fan.glsl"
#include "lighting/environment/mirrored.glsl"
#include "lighting/environment/environment_terms.glsl"
#include "lighting/environment/sky.glsl"
#include "lighting/shadow/shadow_map.glsl"
// clang-format on

static_assert(int(LightKind::ambient) == RL_AMBIENT_LIGHT && int(LightKind::directional) == RL_DIRECTIONAL_LIGHT &&
              int(LightKind::point) == RL_POINT_LIGHT && int(LightKind::spot) == RL_SPOT_LIGHT);

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
    light.has_range = p.inverse_range > 0.0f ? 1 : 0;
    light.inverse_range = broadcast(p.inverse_range);
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

}  // namespace rakelight::lighting::RL_ISA
