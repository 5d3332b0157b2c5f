// SPDX-License-Identifier: Apache-2.0
// Light from all around at a run of pixels: the diffuse term from spherical harmonics, the glossy one from a chain of
// octahedral maps and a table of directional albedos. Per instruction set.
#pragma once
#include "engines/raster/kernels/surface.h"

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

/// Albedo of a GGX surface in even light: f0 times `scale` plus `bias` (Karis 2013, the second sum).
struct SplitSum {
    real scale, bias;
};

inline SplitSum split_sum(const float* table, real n_dot_v, real roughness) {
    const real last(float(split_sum_size - 1)), zero(0.0f), one(1.0f);
    const real x = clamp(n_dot_v, zero, one) * last, y = clamp(roughness, zero, one) * last;
    const integer most(split_sum_size - 2);
    const integer x0 = min(to_int(x), most), y0 = min(to_int(y), most);
    const real tx = x - to_real(x0), ty = y - to_real(y0);
    const auto at = [&](int component) {
        const integer i = ((y0 << split_sum_bits) + x0) << 1;
        const float* const from = table + component;
        const real upper = mix(gather(from, i), gather(from + 2, i), tx);
        const float* const below = from + 2 * split_sum_size;
        return mix(upper, mix(gather(below, i), gather(below + 2, i), tx), ty);
    };
    return {at(0), at(1)};
}

inline real occlusion_at(const MaterialView& m, const Pixels& p) {
    if (m.occlusion_map.view == nullptr) return real(1.0f);
    return real(1.0f) + real(m.occlusion_strength) * (texel(m.occlusion_map, p).x - real(1.0f));
}

/// GGX roughness of a lobe of this exponent: alpha^2 = 2 / (e + 2) (Walter et al. 2007, section 5.3, in Blinn-Phong's
/// terms).
inline real roughness_of_exponent(real exponent) { return sqrt(sqrt(real(2.0f) / (exponent + real(2.0f)))); }

inline constexpr int32_t oren_nayar = 3;  ///< Lighting - 1, as ShadeJob::reflection_model

/// `ambient`: diffuse reflection, `specular`: glossy reflection. Classical materials reflect k_d and, but for Lambert's
/// and Oren-Nayar's models, k_s of it; metallic-roughness ones by the split sum, and as diffuse light what is left.
inline lit::LightTerms environment_terms(const ShadeJob& job, const Pixels& p, const lit::MaterialSurface& surface) {
    const EnvironmentView& e = *job.full->environment;
    const MaterialView& m = *job.material;
    const lit::Surface& s = surface.base;
    const real occlusion = occlusion_at(m, p), zero(0.0f);
    lit::LightTerms terms;
    terms.ambient = s.diffuse * irradiance(e, surface.diffuse_n) * occlusion;
    terms.diffuse = terms.specular = vec3(zero);
    if (job.reflection_model == RL_LAMBERT || job.reflection_model == oren_nayar) return terms;
    const real n_dot_v = dot(s.n, s.v);
    const vec3 r = s.n * (n_dot_v + n_dot_v) - s.v;
    const real roughness = roughness_of_exponent(s.exponent);
    vec3 albedo = s.specular;
    if (m.metallic_roughness != 0) {
        const SplitSum sums = split_sum(e.split_sum, n_dot_v, roughness);
        albedo = s.specular * sums.scale + vec3(sums.bias);
        if (job.full->multiple_scattering != 0) {
            const real lost = reciprocal(max(sums.scale + sums.bias, real(1e-3f))) - real(1.0f);
            albedo = albedo * (vec3(real(1.0f)) + s.specular * lost);
        }
        terms.ambient = terms.ambient * (vec3(real(1.0f)) - albedo);
    }
    terms.specular = albedo * mirrored(e, r, roughness) * occlusion;
    return terms;
}

}  // namespace rakelight::raster::RL_ISA
