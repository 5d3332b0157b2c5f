// SPDX-License-Identifier: Apache-2.0
// What a material of any lighting model is at a run of pixels: its factors and texels given to the lighting text
// (docs/lighting.md has the mapping in words). Per instruction set.
#pragma once
#include "engines/raster/kernels/maps.h"

namespace rakelight::raster::RL_ISA {

inline bool is_pbr(const ShadeJob& job) { return job.reflection_model == RL_PBR; }

/// What the draw's material has, the same for all its pixels.
inline lit::MaterialTraits traits_of(const ShadeJob& job) {
    const MaterialView& m = *job.material;
    const bool has_layers = is_pbr(job) && m.metallic_roughness != 0;
    lit::MaterialTraits traits;
    traits.ward_form = job.full->ward_form;
    traits.is_anisotropic = has_layers && m.anisotropy > 0.0f;
    traits.has_scattering = job.full->multiple_scattering;
    traits.has_sheen = has_layers && (m.sheen_color[0] > 0.0f || m.sheen_color[1] > 0.0f || m.sheen_color[2] > 0.0f);
    traits.has_coat = has_layers && m.clearcoat > 0.0f;
    return traits;
}

/// KHR_materials_anisotropy: a missing map turns nothing.
inline vec4 anisotropy_texel(const MaterialView& m, const Pixels& p) {
    const real one(1.0f);
    return m.map[role_anisotropy].view != nullptr ? texel(m.map[role_anisotropy], p) : vec4(one, real(0.5f), one, one);
}

/// Widths of the lobe.
inline void set_widths(const ShadeJob& job, const Pixels& p, lit::MaterialSurface& s) {
    const MaterialView& m = *job.material;
    lit::set_even_widths(s);
    if (job.reflection_model == RL_WARD && m.ward_alpha[0] > 0.0f)
        lit::set_ward_widths(s, vec2(real(m.ward_alpha[0]), real(m.ward_alpha[1])));
    else if (m.metallic_roughness != 0 && m.anisotropy > 0.0f)
        lit::apply_anisotropy(s, real(m.anisotropy), anisotropy_texel(m, p));
}

inline void set_layers(const MaterialView& m, const Pixels& p, const lit::MaterialTraits& traits,
                       lit::MaterialSurface& s) {
    lit::set_no_layers(s);
    if (traits.has_sheen != 0)
        lit::set_sheen(s, splat(m.sheen_color), real(m.sheen_roughness), texel_or_white(m.map[role_sheen_color], p),
                       texel_or_white(m.map[role_sheen_roughness], p));
    if (traits.has_coat != 0)
        lit::set_coat(s, real(m.clearcoat), real(m.clearcoat_roughness), texel_or_white(m.map[role_clearcoat], p),
                      texel_or_white(m.map[role_clearcoat_roughness], p));
}

inline void set_slopes(const MaterialView& m, lit::MaterialSurface& s) {
    lit::set_oren_nayar(s, m.sigma >= 0.0f ? real(m.sigma) : lit::sigma_of_roughness(s.roughness));
}

/// All of a surface but its directions and what depends on them.
inline void set_material(const ShadeJob& job, const Pixels& p, const BaseColor& base, lit::MaterialSurface& s) {
    const MaterialView& m = *job.material;
    const int32_t model = job.reflection_model;
    if (model == RL_PHONG || model == RL_BLINN_PHONG || (model == RL_LAMBERT && m.metallic_roughness == 0))
        return set_reflectance(job, p, base, s.base);
    s.base.diffuse = rgb(base.color);
    s.base.exponent = s.base.lobe_scale = real(1.0f);
    if (m.metallic_roughness != 0) {
        lit::set_metallic_lobe(s, metallic_roughness_at(m, p), rgb(base.color), model);
    } else {
        set_classical(m, p, rgb(base.paint), s.base);
        lit::set_classical_lobe(s, real(m.lobe_roughness), job.reflection_form);
    }
    set_widths(job, p, s);
    lit::show_base_color(s, rgb(base.color), model);
    if (model == RL_OREN_NAYAR) set_slopes(m, s);
    set_layers(m, p, traits_of(job), s);
    if (!is_pbr(job))
        lit::apply_occlusion(s.base, real(m.occlusion_strength), texel_or_white(m.map[role_occlusion], p));
}

/// The interpolated frame that the lobe's axes and the coat lie in, without the base's bumps.
struct LobeFrame {
    vec3 n, t;
    real handedness;  ///< b = cross(n, t) times it
};

inline LobeFrame lobe_frame(const Pixels& p) {
    const SignedVector normal = normal_at(p.records, p.b);
    const SignedVector tangent = tangent_at(p.records, p.b);
    return {safe_normalize(normal.v) * normal.sign, tangent.v, tangent.sign * normal.sign};
}

inline void set_axes(const MaterialView& m, const Pixels& p, const LobeFrame& frame, lit::MaterialSurface& s) {
    lit::set_lobe_axes(s, frame.t, frame.handedness);
    if (m.metallic_roughness == 0 || !(m.anisotropy > 0.0f)) return;
    lit::turn_lobe_axes(s, vec2(real(m.anisotropy_axis[0]), real(m.anisotropy_axis[1])), anisotropy_texel(m, p));
}

inline vec3 coat_normal(const MaterialView& m, const Pixels& p, const LobeFrame& frame) {
    if (m.map[role_clearcoat_normal].view == nullptr) return frame.n;
    return lit::coat_normal(frame.n, frame.t, frame.handedness, texel(m.map[role_clearcoat_normal], p),
                            real(m.clearcoat_normal_scale));
}

/// What models other than pbr reflect of the environment.
inline void set_around(const ShadeJob& job, const Pixels& p, lit::MaterialSurface& s) {
    const MaterialView& m = *job.material;
    const real occlusion = occlusion_of(m, p);
    lit::set_around(s, occlusion, reflection_of(job));
    if (m.metallic_roughness != 0 && (job.reflection_model == RL_PHONG || job.reflection_model == RL_BLINN_PHONG))
        lit::set_split_sum(s, maps_of(job), lit::metallic_f90(metallic_roughness_at(m, p)), occlusion);
}

/// What depends on directions, once they are known; the emission, dimmed by what lies over it.
inline vec3 finish_surface(const ShadeJob& job, const Pixels& p, vec3 emission, lit::MaterialSurface& s) {
    const MaterialView& m = *job.material;
    if (!is_pbr(job) && job.full->environment != nullptr) set_around(job, p, s);
    if (job.reflection_model != RL_WARD && !is_pbr(job)) return emission;
    const lit::MaterialTraits traits = traits_of(job);
    const LobeFrame frame = lobe_frame(p);
    if (job.reflection_model == RL_WARD || traits.is_anisotropic != 0) set_axes(m, p, frame, s);
    if (!is_pbr(job)) return emission;
    s.coat_n = traits.has_coat != 0 ? coat_normal(m, p, frame) : frame.n;
    const real occlusion = job.full->has_light_around != 0 ? occlusion_of(m, p) : real(1.0f);
    lit::set_pbr_albedos(s, maps_of(job), occlusion, job.full->has_light_around, traits);
    return lit::emission_under_coat(s, emission);
}

/// A point of a draw that is lit before there are pixels.
inline lit::MaterialSurface full_point(const ShadeJob& job, float mean_roughness, vec3 position, vec3 normal) {
    const MaterialView& m = *job.material;
    const lit::Surface base = point_surface(job, mean_roughness, normal, viewer_of(job, position));
    const real roughness(m.metallic_roughness != 0 ? mean_roughness : m.lobe_roughness);
    lit::MaterialSurface s =
        lit::unit_material(base, maps_of(job), roughness, vec2(real(m.ward_alpha[0]), real(m.ward_alpha[1])));
    set_slopes(m, s);
    if (m.metallic_roughness != 0) {
        lit::set_point_dielectric(s, splat(m.dielectric_color), real(m.specular_strength));
    } else {
        lit::set_classical_dielectric(
            s, lit::classical_f0(splat(m.specular), real(m.lobe_roughness), job.reflection_form));
    }
    return s;
}

/// What such a point has.
inline lit::MaterialTraits point_traits(const ShadeJob& job) {
    return {job.full->ward_form, 0, job.full->multiple_scattering, 0, 0};
}

/// One light's terms; `seen`, 0..1: how much of it reaches the surface.
inline lit::LightTerms material_terms(const ShadeJob& job, const lit::MaterialSurface& s, const lit::LightSample& light,
                                      real seen, const lit::MaterialTraits& traits) {
    const lit::LightAlbedo albedo = lit::light_albedo(s, maps_of(job), light.l, traits, job.reflection_model);
    return lit::surface_terms(s, light, seen, albedo, traits, reflection_of(job));
}

/// At points that are lit before there are pixels.
inline lit::LightTerms point_terms(const ShadeJob& job, const lit::MaterialSurface& s, const lit::LightSample& light) {
    return material_terms(job, s, light, real(1.0f), point_traits(job));
}

}  // namespace rakelight::raster::RL_ISA
