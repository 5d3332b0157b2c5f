// SPDX-License-Identifier: Apache-2.0
// What a material of any lighting model is at a vector of points: its factors and texels given to the lighting text
// (docs/lighting.md has the mapping in words). Per instruction set.
#pragma once
#include "cpu_shading/kernels/maps.h"
#include "cpu_shading/kernels/texels.h"

namespace rakelight::cpu_shading::RL_ISA {

/// What the surface is painted with, vertex color times texture, and that times the material's factor; alpha with the
/// opacity map.
struct BaseColor {
    vec4 paint, color;
};

/// Inline, so that an alpha which nobody reads costs nothing.
template <class Kind>
[[gnu::always_inline]] inline BaseColor base_color(const Job<Kind>& job, const ShadingPoint& p) {
    const MaterialView& m = job.material();
    BaseColor base;
    const real one(1.0f);
    base.paint = vec4(one, one, one, one);
    if (m.map[role_base_color].view != nullptr) base.paint = texel(job, role_base_color, p);
    if (m.vertex_colors != 0) base.paint = p.color * base.paint;
    base.color =
        vec4(real(m.base_color[0]), real(m.base_color[1]), real(m.base_color[2]), real(m.base_color[3])) * base.paint;
    if (m.map[role_opacity].view != nullptr) base.color.w = base.color.w * texel(job, role_opacity, p).x;
    return base;
}

/// What several steps ask for.
struct MaterialTexels {
    vec4 metallic_roughness;
    real occlusion;  ///< 0..1
};

template <class Kind>
inline MaterialTexels material_texels(const Job<Kind>& job, const ShadingPoint& p) {
    const MaterialView& m = job.material();
    MaterialTexels t;
    t.metallic_roughness = texel_or_white(job, role_metallic_roughness, p);
    t.occlusion = real(1.0f);
    if (m.map[role_occlusion].view == nullptr || (job.is_pbr() && job.of.has_light_around == 0)) return t;
    const vec4 texel_of_map = m.occlusion_in_metallic != 0 ? t.metallic_roughness : texel(job, role_occlusion, p);
    t.occlusion = lit::occlusion_factor(real(m.occlusion_strength), texel_of_map);
    return t;
}

/// Something keeps light from the environment away.
template <class Kind>
inline bool is_occluded(const Job<Kind>& job) {
    return job.material().map[role_occlusion].view != nullptr || job.of.openness != nullptr;
}

/// What a metallic-roughness material is at a point, for every lighting model.
template <class Kind>
inline lit::MetallicRoughness metallic_roughness_at(const Job<Kind>& job, const ShadingPoint& p,
                                                    const MaterialTexels& t) {
    const MaterialView& m = job.material();
    lit::MetallicRoughness out;
    out.metallic = real(m.metallic), out.roughness = real(m.roughness);
    lit::apply_metallic_roughness(out, t.metallic_roughness);
    lit::apply_specular(out, splat(m.dielectric_color), real(m.specular_strength),
                        texel_or_white(job, role_specular_color, p), texel_or_white(job, role_specular_strength, p));
    return out;
}

template <class Kind>
inline void set_classical(const Job<Kind>& job, const ShadingPoint& p, vec3 paint, lit::Surface& s) {
    const MaterialView& m = job.material();
    lit::set_classical_reflectance(s, splat(m.ambient), splat(m.specular), real(m.shininess), paint,
                                   texel_or_white(job, role_specular, p));
}

/// What the material reflects under the sums of light_sum.glsl: metallic-roughness as the parameters of a normalized
/// lobe.
template <class Kind>
inline void set_classical_sum(const Job<Kind>& job, const ShadingPoint& p, const MaterialTexels& t,
                              const BaseColor& base, lit::Surface& s) {
    const MaterialView& m = job.material();
    s.diffuse = rgb(base.color);
    if (m.metallic_roughness != 0) {
        const lit::MetallicRoughness at = metallic_roughness_at(job, p, t);
        lit::set_metallic_reflectance(s, at, rgb(base.color));
        s.exponent = lit::exponent_of_roughness(at.roughness);
    } else {
        set_classical(job, p, rgb(base.paint), s);
    }
    if (is_occluded(job)) s.ambient = s.ambient * t.occlusion;
    s.lobe_scale = lit::lobe_scale(s.exponent, job.reflection());
}

/// KHR_materials_anisotropy: a missing map turns nothing.
template <class Kind>
inline vec4 anisotropy_texel(const Job<Kind>& job, const ShadingPoint& p) {
    const MaterialView& m = job.material();
    const real one(1.0f);
    return m.map[role_anisotropy].view != nullptr ? texel(job, role_anisotropy, p) : vec4(one, real(0.5f), one, one);
}

/// Widths of the lobe.
template <class Kind>
inline void set_widths(const Job<Kind>& job, const ShadingPoint& p, lit::MaterialSurface& s) {
    const MaterialView& m = job.material();
    lit::set_even_widths(s);
    if constexpr (!Kind::has_layers) return;
    if (job.model() == RL_WARD && m.ward_alpha[0] > 0.0f)
        lit::set_ward_widths(s, vec2(real(m.ward_alpha[0]), real(m.ward_alpha[1])));
    else if (m.metallic_roughness != 0 && m.anisotropy > 0.0f)
        lit::apply_anisotropy(s, real(m.anisotropy), anisotropy_texel(job, p));
}

template <class Kind>
inline void set_layers(const Job<Kind>& job, const ShadingPoint& p, const lit::MaterialTraits& traits,
                       lit::MaterialSurface& s) {
    const MaterialView& m = job.material();
    lit::set_no_layers(s);
    if (traits.has_sheen != 0)
        lit::set_sheen(s, splat(m.sheen_color), real(m.sheen_roughness), texel_or_white(job, role_sheen_color, p),
                       texel_or_white(job, role_sheen_roughness, p));
    if (traits.has_coat != 0)
        lit::set_coat(s, real(m.clearcoat), real(m.clearcoat_roughness), texel_or_white(job, role_clearcoat, p),
                      texel_or_white(job, role_clearcoat_roughness, p));
    if (traits.has_transmission != 0)
        lit::set_transmission(s, real(m.transmission), texel_or_white(job, role_transmission, p));
}

/// What a transmissive surface lets light through.
template <class Kind>
inline lit::Body body_at(const Job<Kind>& job, const ShadingPoint& p) {
    const MaterialView& m = job.material();
    lit::Body body;
    body.thickness = real(m.thickness * job.of.thickness_scale) * texel_or_white(job, role_thickness, p).y;
    body.eta = splat(m.through_eta), body.attenuation = splat(m.attenuation);
    body.blur = real(m.through_blur);
    body.bends = m.is_body, body.parts = m.through_parts;
    return body;
}

inline lit::BehindView behind_view(const BehindView& b) {
    const auto row = [](const float(&r)[4]) { return vec4(real(r[0]), real(r[1]), real(r[2]), real(r[3])); };
    return {row(b.to_u), row(b.to_v), row(b.to_w), real(b.last_level)};
}

/// @param job  of a transmissive material
template <class Kind>
inline lit::LightTerms terms_from_behind(const Job<Kind>& job, const ShadingPoint& p, const lit::MaterialSurface& s) {
    return lit::terms_from_behind(maps_of(job.of), behind_view(*job.of.behind), body_at(job, p), s, p.position);
}

template <class Kind>
inline void set_film(const Job<Kind>& job, const ShadingPoint& p, lit::MaterialSurface& s) {
    const MaterialView& m = job.material();
    const real thickness =
        lit::film_thickness(real(m.iridescence_thickness_min_nm), real(m.iridescence_thickness_max_nm),
                            texel_or_white(job, role_iridescence_thickness, p));
    lit::set_iridescence(s, real(m.iridescence) * texel_or_white(job, role_iridescence, p).x, thickness,
                         real(m.iridescence_ior));
}

inline void set_slopes(const MaterialView& m, vec3 facet_color, lit::MaterialSurface& s) {
    lit::set_oren_nayar(s, m.sigma >= 0.0f ? real(m.sigma) : lit::sigma_of_roughness(s.roughness), facet_color);
}

/// Lambert, Phong, Blinn-Phong; except for metals by Lambert, which show their base color.
template <class Kind>
inline bool has_classical_sum(const Job<Kind>& job) {
    if constexpr (Kind::models == Models::classical) return true;
    if constexpr (Kind::models == Models::pbr) return false;
    const int32_t model = job.model();
    return model == RL_PHONG || model == RL_BLINN_PHONG ||
           (model == RL_LAMBERT && job.material().metallic_roughness == 0);
}

/// All of a surface but its directions and what depends on them.
template <class Kind>
inline void set_material(const Job<Kind>& job, const ShadingPoint& p, const MaterialTexels& t, const BaseColor& base,
                         lit::Surface& s) {
    set_classical_sum(job, p, t, base, s);
}
template <class Kind>
inline void set_material(const Job<Kind>& job, const ShadingPoint& p, const MaterialTexels& t, const BaseColor& base,
                         lit::MaterialSurface& s) {
    if (has_classical_sum(job)) return set_classical_sum(job, p, t, base, s.base);
    const MaterialView& m = job.material();
    s.base.diffuse = rgb(base.color);
    s.base.exponent = s.base.lobe_scale = real(1.0f);
    if (m.metallic_roughness != 0) {
        lit::set_metallic_lobe(s, metallic_roughness_at(job, p, t), rgb(base.color), job.model());
    } else {
        set_classical(job, p, rgb(base.paint), s.base);
        lit::set_classical_lobe(s, real(m.lobe_roughness), job.of.reflection_form);
    }
    set_widths(job, p, s);
    lit::show_base_color(s, rgb(base.color), job.model());
    if (shading::is_oren_nayar(job.model())) set_slopes(m, s.base.diffuse, s);
    set_layers(job, p, job.traits(), s);
    if (!job.is_pbr()) s.base.ambient = s.base.ambient * t.occlusion;
}

template <class Kind>
inline void set_axes(const Job<Kind>& job, const ShadingPoint& p, lit::MaterialSurface& s) {
    const MaterialView& m = job.material();
    lit::set_lobe_axes(s, p.tangent.v, p.tangent.sign * p.normal.sign);
    if (m.metallic_roughness == 0 || !(m.anisotropy > 0.0f)) return;
    lit::turn_lobe_axes(s, vec2(real(m.anisotropy_axis[0]), real(m.anisotropy_axis[1])), anisotropy_texel(job, p));
}

/// @param n  without the bumps of the base, unit, on the seen side
template <class Kind>
inline vec3 coat_normal(const Job<Kind>& job, const ShadingPoint& p, vec3 n) {
    const MaterialView& m = job.material();
    if (m.map[role_clearcoat_normal].view == nullptr) return n;
    return lit::coat_normal(n, p.tangent.v, p.tangent.sign * p.normal.sign, texel(job, role_clearcoat_normal, p),
                            real(m.clearcoat_normal_scale));
}

/// What models other than pbr reflect of the environment.
template <class Kind>
inline void set_around(const Job<Kind>& job, const ShadingPoint& p, const MaterialTexels& t, lit::MaterialSurface& s) {
    const MaterialView& m = job.material();
    lit::set_around(s, t.occlusion, job.reflection());
    if (m.metallic_roughness != 0 && (job.model() == RL_PHONG || job.model() == RL_BLINN_PHONG))
        lit::set_split_sum(s, maps_of(job.of), lit::metallic_f90(metallic_roughness_at(job, p, t)), t.occlusion);
}

/// What depends on directions, once they are known; the emission, dimmed by what lies over it.
/// @param even  unit normal without bumps, on the seen side
template <class Kind>
inline vec3 finish_surface(const Job<Kind>& job, const ShadingPoint& p, const MaterialTexels& t, vec3 even,
                           vec3 emission, lit::MaterialSurface& s) {
    if (!job.is_pbr() && job.environment() != nullptr) set_around(job, p, t, s);
    if (job.model() != RL_WARD && !job.is_pbr()) return emission;
    const lit::MaterialTraits traits = job.traits();
    if (job.model() == RL_WARD || traits.is_anisotropic != 0) set_axes(job, p, s);
    if (!job.is_pbr()) return emission;
    s.coat_n = traits.has_coat != 0 ? coat_normal(job, p, even) : even;
    if (traits.has_iridescence != 0) set_film(job, p, s);
    lit::set_pbr_albedos(s, maps_of(job.of), t.occlusion, job.of.has_light_around, traits);
    return lit::emission_under_coat(s, emission);
}

/// First term of the sum.
template <class Kind>
inline vec3 emission_of(const Job<Kind>& job, const ShadingPoint& p) {
    return lit::emission_of(splat(job.material().emission), texel_or_white(job, role_emission, p));
}

}  // namespace rakelight::cpu_shading::RL_ISA
