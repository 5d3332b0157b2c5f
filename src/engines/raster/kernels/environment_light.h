// SPDX-License-Identifier: Apache-2.0
// Light from all around at a run of pixels: the diffuse term from spherical harmonics, the glossy one from a chain of
// octahedral maps and the tables of directional albedos. Per instruction set.
#pragma once
#include "engines/raster/kernels/full_surface.h"

namespace rakelight::raster::RL_ISA {

/// The world's direction in the picture's own axes.
inline vec3 to_environment(const EnvironmentView& e, vec3 d) {
    const real c(e.turn[0]), s(e.turn[1]);
    return vec3(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
}

/// Sum over the polynomials of EnvironmentLight::irradiance, not negative.
inline vec3 irradiance(const EnvironmentView& e, vec3 direction) {
    const vec3 n = to_environment(e, direction);
    const real p[8] = {
        n.y, n.z, n.x, n.x * n.y, n.y * n.z, real(3.0f) * n.z * n.z - real(1.0f), n.x * n.z, n.x * n.x - n.y * n.y};
    vec3 sum = splat(e.irradiance[0]);
    for (int i = 0; i < 8; ++i) sum = sum + splat(e.irradiance[i + 1]) * p[i];
    const real dark(0.0f), intensity(e.intensity);
    return vec3(max(sum.x, dark), max(sum.y, dark), max(sum.z, dark)) * intensity;
}

/// u, v of a direction in an octahedral map: octahedral() of image/environment.h.
inline vec2 octahedral(vec3 d) {
    const real one(1.0f), half(0.5f);
    const real scale = reciprocal(max(abs(d.x) + abs(d.y) + abs(d.z), real(1e-20f)));
    const real x = d.x * scale, z = d.z * scale;
    const mask is_below = d.y < real(0.0f);
    const real u = select(is_below, copy_sign(one - abs(z), x), x), v = select(is_below, copy_sign(one - abs(x), z), z);
    return vec2(half + half * u, half + half * v);
}

/// What a lobe of this roughness about the direction mirrors.
inline vec3 mirrored(const EnvironmentView& e, vec3 direction, real roughness) {
    const TextureView& t = *e.specular;
    TexCoords c;
    c.uv = octahedral(to_environment(e, direction));
    const real level = clamp(roughness, real(0.0f), real(1.0f)) * real(float(t.levels - 1));
    return rgb(sample(t, footprint_of(t, c, level, true))) * real(e.intensity);
}

inline vec3 mirrored_about(vec3 n, vec3 v) {
    const real n_dot_v = dot(n, v);
    return n * (n_dot_v + n_dot_v) - v;
}

inline constexpr int fan_facets = 16;

/// Of a surface that is rougher along one axis: each facet of the fan mirrors a lobe as wide as the surface is across,
/// or as they are apart: 1.2 times a facet's share of the width, a heuristic, as fan_width() is. Held to the lobe is
/// the fan's mean alone, 7 degrees off at most (tests/unit/lighting/facet_fan_test.cpp), not its spread. Lanes of equal
/// widths have `even`.
inline vec3 mirrored_by_fan(const EnvironmentView& e, const lit::MaterialSurface& s, vec3 even) {
    const mask is_along_t = s.alpha_x > s.alpha_y, is_uneven = is_along_t | (s.alpha_y > s.alpha_x);
    if (no_lane(is_uneven)) return even;
    const vec3 t = select(is_along_t, s.tangent, s.bitangent);
    const real wide = min(max(s.alpha_x, s.alpha_y), real(1.0f)), narrow = min(min(s.alpha_x, s.alpha_y), wide);
    const real width = lit::fan_width(wide, narrow);
    const real roughness = sqrt(max(narrow, width * real(1.2f / float(fan_facets))));
    vec3 sum = vec3(real(0.0f));
    real weights(0.0f);
    for (int i = 0; i < fan_facets; ++i) {
        const real place((float(i) + 0.5f) / float(fan_facets));
        const lit::FacetRay ray = lit::facet_ray(s.base.n, t, s.base.v, width, place);
        sum = sum + mirrored(e, ray.l, roughness) * ray.weight;
        weights = weights + ray.weight;
    }
    const mask has_fan = is_uneven & (weights > real(1e-6f));
    return select(has_fan, sum / max(weights, real(1e-6f)), even);
}

/// What the glossy lobe about the surface's mirror direction mirrors.
inline vec3 glossy(const ShadeJob& job, const EnvironmentView& e, const lit::MaterialSurface& s,
                   const lit::MaterialTraits& traits) {
    const vec3 even = mirrored(e, mirrored_about(s.base.n, s.base.v), s.roughness);
    const bool has_axes = job.reflection_model == RL_WARD || (is_pbr(job) && traits.is_anisotropic != 0);
    return has_axes ? mirrored_by_fan(e, s, even) : even;
}

/// `ambient`: diffuse reflection, `specular`: gloss, sheen and coat, as finish_surface() has weighed them.
inline lit::LightTerms environment_terms(const ShadeJob& job, const lit::MaterialSurface& s) {
    const EnvironmentView& e = *job.full->environment;
    const lit::MaterialTraits traits = traits_of(job);
    lit::LightTerms terms;
    terms.ambient = s.around_diffuse * irradiance(e, s.diffuse_n);
    terms.diffuse = vec3(real(0.0f));
    terms.specular = s.around_specular * glossy(job, e, s, traits);
    if (traits.has_sheen != 0) terms.specular = terms.specular + s.around_sheen * irradiance(e, s.base.n);
    if (traits.has_coat != 0)
        terms.specular =
            terms.specular + mirrored(e, mirrored_about(s.coat_n, s.base.v), sqrt(s.coat_alpha)) * s.around_coat;
    return terms;
}

}  // namespace rakelight::raster::RL_ISA
