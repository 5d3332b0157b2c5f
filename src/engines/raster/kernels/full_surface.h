// SPDX-License-Identifier: Apache-2.0
// What a material of any lighting model is at a run of pixels (docs/lighting.md has the same mapping in words). Per
// instruction set.
#pragma once
#include "engines/raster/kernels/albedo.h"
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

inline real greatest(vec3 v) { return max(v.x, max(v.y, v.z)); }

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

inline real occlusion_of(const MaterialView& m, const Pixels& p) {
    if (m.occlusion_map.view == nullptr) return real(1.0f);
    return real(1.0f) + real(m.occlusion_strength) * (texel(m.occlusion_map, p).x - real(1.0f));
}

/// f0 of a microfacet lobe as wide as the classical one. A textbook k_s is how bright the highlight's center is, not an
/// albedo: k_s = f0 / (4 alpha^2) there, so f0 = 4 alpha^2 k_s, at most k_s. As metallic_roughness_from_classical().
inline vec3 classical_f0(const ShadeJob& job, vec3 k_s) {
    const float alpha = job.material->lobe_roughness * job.material->lobe_roughness, share = 4.0f * alpha * alpha;
    if (job.reflection_form == RL_TEXTBOOK) k_s = k_s * real(share < 1.0f ? share : 1.0f);
    return min(k_s, vec3(real(1.0f)));
}

/// What the diffuse light of a classical surface loses to its highlight.
inline void set_classical_dielectric(vec3 f0, lit::MaterialSurface& s) {
    s.dielectric_f0 = greatest(f0);
    s.dielectric_f90 = min(real(1.0f), s.dielectric_f0 * real(50.0f));  // none where there is no highlight at all
}

/// Classical parameters as those of a microfacet lobe as wide.
inline void set_classical_lobe(const ShadeJob& job, const Pixels& p, const BaseColor& base, lit::MaterialSurface& s) {
    const MaterialView& m = *job.material;
    set_classical(m, p, rgb(base.paint), s.base);
    s.roughness = real(m.lobe_roughness);
    s.base.specular = classical_f0(job, s.base.specular);
    set_classical_dielectric(s.base.specular, s);
    s.f90 = vec3(s.dielectric_f90);
}

/// Metals reflect all at grazing angles.
inline vec3 f90_of(const MetallicRoughness& at) { return vec3(mix(at.dielectric_f90, real(1.0f), at.metallic)); }

/// glTF 2.0, appendix B, with KHR_materials_ior and KHR_materials_specular.
inline void set_metallic_lobe(const ShadeJob& job, const Pixels& p, vec3 base, lit::MaterialSurface& s) {
    const MetallicRoughness at = metallic_roughness_at(*job.material, p);
    set_metallic_reflectance(at, base, s.base);
    s.roughness = at.roughness;
    s.dielectric_f0 = greatest(at.dielectric_f0);
    s.dielectric_f90 = at.dielectric_f90;
    s.f90 = f90_of(at);
    if (is_pbr(job)) s.base.ambient = s.base.diffuse;  // the lobe's share is that of the albedo tables
}

/// Cosine at which the tables of the lobe's albedos are read for a direction of light, or that to the viewer.
inline real table_cosine(const lit::MaterialSurface& s, vec3 d, const lit::MaterialTraits& traits) {
    const real cosine = dot(s.base.n, d);
    if (traits.is_anisotropic == 0) return cosine;
    const real equal = equal_cosine(cosine, dot(s.tangent, d), dot(s.bitangent, d), s.alpha_x, s.alpha_y);
    return select(s.alpha_x > s.alpha_y, equal, cosine);
}

/// Widths of the lobe. KHR_materials_anisotropy: alpha_t = mix(alpha, 1, strength^2), alpha_b = alpha.
inline void set_widths(const ShadeJob& job, const Pixels& p, lit::MaterialSurface& s) {
    const MaterialView& m = *job.material;
    const real alpha = max(s.roughness * s.roughness, real(1e-3f));
    s.alpha_x = s.alpha_y = alpha;
    s.table_roughness = s.roughness;
    if (job.reflection_model == RL_WARD && m.ward_alpha[0] > 0.0f) {
        s.alpha_x = max(real(m.ward_alpha[0]), real(1e-3f)), s.alpha_y = max(real(m.ward_alpha[1]), real(1e-3f));
        s.roughness = sqrt(sqrt(s.alpha_x * s.alpha_y));
    } else if (m.metallic_roughness != 0 && m.anisotropy > 0.0f) {
        real strength = real(m.anisotropy);
        if (m.anisotropy_map.view != nullptr) strength = strength * texel(m.anisotropy_map, p).z;
        s.alpha_x = mix(alpha, real(1.0f), strength * strength);
        const mask is_uneven = s.alpha_x > alpha;
        s.table_roughness = select(is_uneven, equal_roughness(s.alpha_x, s.alpha_y), s.roughness);
        s.roughness = select(is_uneven, sqrt(sqrt(s.alpha_x * s.alpha_y)), s.roughness);
    }
}

inline void set_sheen_and_coat(const MaterialView& m, const Pixels& p, const lit::MaterialTraits& traits,
                               lit::MaterialSurface& s) {
    s.sheen = vec3(real(0.0f));
    s.sheen_alpha = s.coat_alpha = real(1.0f);
    s.coat_reflectance = real(0.0f);
    if (traits.has_sheen != 0) {
        real roughness = real(m.sheen_roughness);
        s.sheen = splat(m.sheen_color);
        if (m.sheen_color_map.view != nullptr) s.sheen = s.sheen * rgb(texel(m.sheen_color_map, p));
        if (m.sheen_roughness_map.view != nullptr) roughness = roughness * texel(m.sheen_roughness_map, p).w;
        s.sheen_alpha = max(roughness * roughness, real(5e-3f));
    }
    if (traits.has_coat != 0) {
        real roughness = real(m.clearcoat_roughness);
        s.coat_reflectance = real(m.clearcoat);
        if (m.clearcoat_map.view != nullptr) s.coat_reflectance = s.coat_reflectance * texel(m.clearcoat_map, p).x;
        if (m.clearcoat_roughness_map.view != nullptr) roughness = roughness * texel(m.clearcoat_roughness_map, p).y;
        s.coat_alpha = max(roughness * roughness, real(1e-3f));
    }
}

/// Oren-Nayar's terms. Slopes of a surface of Beckmann's facets with this alpha have the deviation alpha / sqrt(2),
/// which is taken for that of their angles: the tangent for its angle, 0.71 for 0.62 at most.
inline void set_slopes(const MaterialView& m, lit::MaterialSurface& s) {
    const real sigma = m.sigma >= 0.0f ? real(m.sigma) : s.roughness * s.roughness * real(0.707106781f);
    s.oren_nayar_a = lit::oren_nayar_a(sigma);
    s.oren_nayar_b = lit::oren_nayar_b(sigma);
}

/// Diffuse models show metals in their base color: they have no highlight that would.
inline void set_diffuse_model(const ShadeJob& job, vec3 base, lit::MaterialSurface& s) {
    s.base.diffuse = base;
    if (job.reflection_model == RL_OREN_NAYAR) set_slopes(*job.material, s);
}

/// All of a surface but its directions and what depends on them.
inline void set_material(const ShadeJob& job, const Pixels& p, const BaseColor& base, lit::MaterialSurface& s) {
    const MaterialView& m = *job.material;
    const vec3 color = rgb(base.color);
    if (job.reflection_model == RL_PHONG || job.reflection_model == RL_BLINN_PHONG ||
        (job.reflection_model == RL_LAMBERT && m.metallic_roughness == 0)) {
        set_reflectance(job, p, base, s.base);
        return;
    }
    s.base.diffuse = color;
    s.base.exponent = s.base.lobe_scale = real(1.0f);
    if (m.metallic_roughness != 0)
        set_metallic_lobe(job, p, color, s);
    else
        set_classical_lobe(job, p, base, s);
    set_widths(job, p, s);
    if (job.reflection_model == RL_LAMBERT || job.reflection_model == RL_OREN_NAYAR) set_diffuse_model(job, color, s);
    set_sheen_and_coat(m, p, traits_of(job), s);
    if (!is_pbr(job)) s.base.ambient = s.base.ambient * occlusion_of(m, p);
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

inline void set_lobe_axes(const ShadeJob& job, const Pixels& p, const LobeFrame& frame, lit::MaterialSurface& s) {
    const MaterialView& m = *job.material;
    const vec3 n = s.base.n, t = lit::orthogonal_tangent(n, frame.t), b = cross(n, t) * frame.handedness;
    s.tangent = t, s.bitangent = b;
    if (m.metallic_roughness == 0 || !(m.anisotropy > 0.0f)) return;
    vec2 axis = vec2(real(m.anisotropy_axis[0]), real(m.anisotropy_axis[1]));
    if (m.anisotropy_map.view != nullptr) {
        const vec4 map = texel(m.anisotropy_map, p);
        const real one(1.0f), two(2.0f);
        const vec2 d = vec2(two * map.x - one, two * map.y - one);
        axis = vec2(axis.x * d.x - axis.y * d.y, axis.y * d.x + axis.x * d.y);
    }
    s.tangent = safe_normalize_or(t * axis.x + b * axis.y, t);
    s.bitangent = cross(n, s.tangent);
}

inline vec3 coat_normal(const MaterialView& m, const Pixels& p, const LobeFrame& frame) {
    if (m.clearcoat_normal_map.view == nullptr) return frame.n;
    const vec3 mapped = lit::decode_normal(rgb(texel(m.clearcoat_normal_map, p)), real(m.clearcoat_normal_scale));
    return lit::perturb_normal(frame.n, lit::orthogonal_tangent(frame.n, frame.t), frame.handedness, mapped);
}

/// What the layers reflect of light from all around, towards the viewer.
inline void set_pbr_around(const ShadeJob& job, const Pixels& p, const lit::MaterialTraits& traits, real lobe,
                           lit::MaterialSurface& s) {
    const lighting::AlbedoTables& t = job.full->albedo;
    lit::ViewAlbedo albedo;
    albedo.lobe = lobe;
    albedo.grazing = lobe * look_up_table(t.grazing, grazing_place(dot(s.base.n, s.base.v), s.table_roughness));
    albedo.coat = real(0.0f);
    if (traits.has_coat != 0) albedo.coat = lobe_albedo(t, dot(s.coat_n, s.base.v), sqrt(s.coat_alpha));
    s = lit::pbr_around(s, albedo, occlusion_of(*job.material, p));
}

/// The tables are read only for what is there: layers, light between the facets, light from all around.
inline void set_pbr_albedos(const ShadeJob& job, const Pixels& p, const lit::MaterialTraits& traits,
                            lit::MaterialSurface& s) {
    const lighting::AlbedoTables& t = job.full->albedo;
    const real n_dot_v = dot(s.base.n, s.base.v), zero(0.0f), one(1.0f);
    s.scattering = vec3(zero);
    s.sheen_albedo = zero;
    s.albedo = s.albedo_mean = one;
    if (traits.has_sheen != 0) s.sheen_albedo = sheen_albedo(t, n_dot_v, s.sheen_alpha);
    if (traits.has_coat != 0) s.coat_reflectance = lit::coat_reflectance(s.coat_reflectance, dot(s.coat_n, s.base.v));
    if (job.full->has_light_around == 0 && traits.has_scattering == 0) return;
    const real lobe = lobe_albedo(t, table_cosine(s, s.base.v, traits), s.table_roughness);
    s.albedo = select(n_dot_v > zero, lobe, one);  // nothing comes from under the horizon
    s.albedo_mean = lobe_mean(t, s.table_roughness);
    if (traits.has_scattering != 0) s.scattering = lit::scattering_color(s.base.specular, s.f90, s.albedo_mean);
    if (job.full->has_light_around != 0) set_pbr_around(job, p, traits, lobe, s);
}

/// Metallic-roughness materials under Phong and Blinn-Phong mirror surroundings by Karis 2013's split sum, and are
/// diffuse with what is left.
inline void set_split_sum(const ShadeJob& job, const Pixels& p, lit::MaterialSurface& s) {
    const lighting::AlbedoTables& t = job.full->albedo;
    const real n_dot_v = dot(s.base.n, s.base.v), whole = lobe_albedo(t, n_dot_v, s.roughness);
    const real grazing = whole * look_up_table(t.grazing, grazing_place(n_dot_v, s.roughness));
    const vec3 f90 = f90_of(metallic_roughness_at(*job.material, p));
    const vec3 albedo = s.base.specular * (whole - grazing) + f90 * grazing;
    s.around_diffuse = s.around_diffuse * (vec3(real(1.0f)) - albedo);
    s.around_specular = albedo;
}

/// What models other than pbr reflect of surroundings: k_d, and k_s of a textbook lobe by the mapping above.
inline void set_around(const ShadeJob& job, const Pixels& p, lit::MaterialSurface& s) {
    const MaterialView& m = *job.material;
    const real one(1.0f), occlusion = occlusion_of(m, p);
    s.coat_n = s.base.n;
    s.coat_alpha = one;
    s.around_coat = real(0.0f);
    s.around_specular = s.around_sheen = vec3(real(0.0f));
    s.around_diffuse = s.base.diffuse * occlusion;
    if (job.reflection_model == RL_LAMBERT || job.reflection_model == RL_OREN_NAYAR) {
        s.roughness = one;
        return;
    }
    s.around_specular = s.base.specular;
    if (job.reflection_model != RL_WARD) {
        const real alpha_squared = real(2.0f) / (s.base.exponent + real(2.0f));
        s.roughness = sqrt(sqrt(alpha_squared));
        if (m.metallic_roughness != 0)
            set_split_sum(job, p, s);
        else if (job.reflection_form == RL_TEXTBOOK)
            s.around_specular = s.around_specular * min(one, real(4.0f) * alpha_squared);
    }
    s.around_specular = s.around_specular * occlusion;
}

/// What depends on directions, once they are known; the emission, dimmed by what lies over it.
inline vec3 finish_surface(const ShadeJob& job, const Pixels& p, vec3 emission, lit::MaterialSurface& s) {
    if (!is_pbr(job) && job.full->environment != nullptr) set_around(job, p, s);
    if (job.reflection_model != RL_WARD && !is_pbr(job)) return emission;
    const lit::MaterialTraits traits = traits_of(job);
    const LobeFrame frame = lobe_frame(p);
    if (job.reflection_model == RL_WARD || traits.is_anisotropic != 0) set_lobe_axes(job, p, frame, s);
    if (!is_pbr(job)) return emission;
    s.coat_n = frame.n;
    if (traits.has_coat != 0) s.coat_n = coat_normal(*job.material, p, frame);
    set_pbr_albedos(job, p, traits, s);
    return emission * (real(1.0f) - s.coat_reflectance);
}

inline lit::LightAlbedo light_albedo(const ShadeJob& job, const lit::MaterialTraits& traits, vec3 l,
                                     const lit::MaterialSurface& s) {
    lit::LightAlbedo albedo;
    albedo.lobe = albedo.sheen = real(0.0f);
    if (!is_pbr(job)) return albedo;
    const real n_dot_l = dot(s.base.n, l);
    if (traits.has_scattering != 0) {
        const real cosine = table_cosine(s, l, traits);
        albedo.lobe = lobe_albedo(job.full->albedo, cosine, s.table_roughness);
    }
    if (traits.has_sheen != 0) albedo.sheen = sheen_albedo(job.full->albedo, n_dot_l, s.sheen_alpha);
    return albedo;
}

/// A point of a draw that is lit before there are pixels, whose terms are those per unit of reflectance: of equal
/// widths, with no layers and no rise of Fresnel's term.
inline lit::MaterialSurface full_point(const ShadeJob& job, float mean_roughness, vec3 position, vec3 normal) {
    const MaterialView& m = *job.material;
    const vec3 one = vec3(real(1.0f));
    lit::MaterialSurface s;
    s.base = point_surface(job, mean_roughness, position, normal);
    s.base.v = viewer_of(job, position);
    s.diffuse_n = s.coat_n = normal;
    s.roughness = s.table_roughness = real(m.metallic_roughness != 0 ? mean_roughness : m.lobe_roughness);
    real alpha = s.roughness * s.roughness;
    if (m.ward_alpha[0] > 0.0f) alpha = sqrt(real(m.ward_alpha[0]) * real(m.ward_alpha[1]));
    s.alpha_x = s.alpha_y = max(alpha, real(1e-3f));
    s.tangent = lit::orthogonal_tangent(normal, vec3(real(1.0f), real(0.0f), real(0.0f)));
    s.bitangent = cross(normal, s.tangent);
    set_slopes(m, s);
    s.f90 = s.scattering = one;
    if (m.metallic_roughness != 0) {
        s.dielectric_f90 = real(m.specular_strength);
        s.dielectric_f0 = greatest(lit::dielectric_f0(splat(m.dielectric_color), s.dielectric_f90));
    } else {
        set_classical_dielectric(classical_f0(job, splat(m.specular)), s);
    }
    s.albedo = lobe_albedo(job.full->albedo, dot(normal, s.base.v), s.roughness);
    s.albedo_mean = lobe_mean(job.full->albedo, s.roughness);
    return s;
}

/// What such a point has.
inline lit::MaterialTraits point_traits(const ShadeJob& job) {
    return {job.full->ward_form, 0, job.full->multiple_scattering, 0, 0};
}

/// One light's terms at such a point.
inline lit::LightTerms point_terms(const ShadeJob& job, const lit::MaterialSurface& s, const lit::LightSample& light) {
    const lit::MaterialTraits traits = point_traits(job);
    return lit::surface_terms(s, light, real(1.0f), light_albedo(job, traits, light.l, s), traits, reflection_of(job));
}

/// One light's terms; `seen`, 0..1: how much of it reaches the surface.
inline lit::LightTerms material_terms(const ShadeJob& job, const lit::MaterialSurface& s, const lit::LightSample& light,
                                      real seen) {
    const lit::MaterialTraits traits = traits_of(job);
    return lit::surface_terms(s, light, seen, light_albedo(job, traits, light.l, s), traits, reflection_of(job));
}

}  // namespace rakelight::raster::RL_ISA
