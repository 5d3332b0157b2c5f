// SPDX-License-Identifier: Apache-2.0
// How a path leaves a surface: by its lobes, or, where light goes through or a classical surface mirrors, by the border of the
// two sides: Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces". Per instruction set.
#pragma once
#include "engines/raytrace/kernels/path_surface.h"

namespace rakelight::raytrace::RL_ISA {

/// What the border sends back and lets through, apart from the other lobes; uniform: whether there is such a thing at all.
struct PathBorder {
    bool is_there;
    bool bends;
    mask acts;   ///< lanes that have it
    real share;  ///< 0..1 with which paths go there
    real eta;
    vec3 reflects, lets_through;  ///< 0..1 of what lighting/material/transport.glsl says
};

/// A surface in its parts.
struct PathLobes {
    lit::MaterialSurface lit_surface;  ///< for lights without an area
    lit::MaterialSurface rest;         ///< for all else: without what the border does
    lit::LobeShares shares;            ///< of `rest`
    PathBorder border;
    vec3 albedo;
};

inline vec3 albedo_of(const PathSurface& p, const lit::MaterialSurface& s) {
    if (p.job.is_pbr()) return s.around_diffuse + s.around_specular + s.around_sheen + vec3(s.around_coat);
    return has_gloss(p.job) ? s.base.diffuse + s.base.specular : s.base.diffuse;
}

/// Weights of both ways for facets that the view meets at this cosine.
inline lit::Transport border_weights(const PathSurface& p, const PathBorder& border, real cosine) {
    const EveryJob& job = p.job;
    lit::Transport t;
    if (job.material().metallic_roughness == 0) {
        t = classical_transport(job, p.point, cosine, border.eta).weights;
    } else {
        const lit::MetallicRoughness at = cpu::metallic_roughness_at(job, p.point.point, p.point.texels);
        const int32_t has_film = job.is_pbr() && p.traits.has_iridescence;
        t = lit::metallic_transport(at, cpu::rgb(p.point.base.color), transmission_at(job, p.point), border.bends,
                                    cosine, border.eta, has_film, p.surface().base.specular);
        if (job.is_pbr()) lit::add_transport_layers(t, p.surface(), p.traits.has_sheen, p.traits.has_coat);
    }
    t.reflected = t.reflected * border.reflects;
    t.refracted = t.refracted * border.lets_through;
    return t;
}

/// Classical surfaces mirror and let through; others let through.
inline bool has_border(const EveryJob& job) {
    const cpu_shading::MaterialView& m = job.material();
    if (job.of.unlit != 0) return false;
    if (m.metallic_roughness != 0) return m.transmission > 0.0f;
    return (m.mirror != shading::mirror_none && has_gloss(job)) || m.filter[0] > 0.0f || m.filter[1] > 0.0f ||
           m.filter[2] > 0.0f;
}

inline void scale_diffuse(lit::MaterialSurface& s, vec3 kept) {
    s.base.diffuse = s.base.diffuse * kept;
    s.around_diffuse = s.around_diffuse * kept;
}

inline void scale_gloss(lit::MaterialSurface& s, vec3 kept) {
    s.base.specular = s.base.specular * kept;
    s.f90 = s.f90 * kept;
    s.scattering = s.scattering * kept;
    s.around_specular = s.around_specular * kept;
}

/// By classical models surfaces send on no more than arrives; those that mirror leave their gloss to the border.
/// @return what the border of a classical material does
inline vec3 part_classical(const PathSurface& p, real there, real cosine, PathLobes& out) {
    const cpu_shading::MaterialView& m = p.job.material();
    const bool mirrors = m.mirror != shading::mirror_none,
               has_border = out.border.is_there && m.metallic_roughness == 0;
    const real zero(0.0f), one(1.0f);
    PathBorder& border = out.border;
    border.acts = mask(has_border);
    border.reflects = mirrors ? vec3(one) : vec3(zero), border.lets_through = vec3(one);
    lit::Transport t{vec3(zero), vec3(zero), vec3(zero)};
    if (has_border) t = border_weights(p, border, cosine);
    const vec3 kept = classical_kept(p.surface().base, has_gloss(p.job), mirrors, t, there);
    border.reflects = border.reflects * kept, border.lets_through = border.lets_through * kept;
    scale_diffuse(out.lit_surface, kept), scale_gloss(out.lit_surface, kept);
    scale_diffuse(out.rest, kept), scale_gloss(out.rest, mirrors ? vec3(zero) : kept);
    return (t.reflected + t.refracted) * kept;
}

/// The border transmits, and has as much of the gloss. @return what it does
inline vec3 part_metallic(const PathSurface& p, real cosine, PathLobes& out) {
    PathBorder& border = out.border;
    const real one(1.0f), transmission = transmission_at(p.job, p.point);
    border.acts = transmission > real(0.0f);
    border.reflects = vec3(transmission), border.lets_through = vec3(one);
    scale_diffuse(out.lit_surface, vec3(one - transmission));
    scale_diffuse(out.rest, vec3(one - transmission)), scale_gloss(out.rest, vec3(one - transmission));
    const lit::Transport t = border_weights(p, border, cosine);
    return select(border.acts, t.reflected + t.refracted, vec3(real(0.0f)));
}

/// @param there  0..1, of the surface; what its border does knows it
inline PathLobes find_lobes(const PathSurface& p, real eta, real there) {
    PathLobes out;
    out.lit_surface = out.rest = p.surface();
    const real zero(0.0f);
    const vec3 none(zero);
    const cpu_shading::MaterialView& m = p.job.material();
    out.border = {has_border(p.job), m.is_body != 0, mask(false), zero, eta, none, none};
    if (!out.border.bends) out.border.eta = real(1.0f);
    const real cosine = clamp(dot(p.surface().base.n, p.surface().base.v), zero, real(1.0f));
    vec3 both = none;
    const bool is_classical = m.metallic_roughness == 0;
    if (!p.job.is_pbr() || (is_classical && out.border.is_there)) both = part_classical(p, there, cosine, out);
    if (!is_classical && out.border.is_there) both = part_metallic(p, cosine, out);
    const vec3 rest = albedo_of(p, out.rest);
    const real own = max(lit::greatest(both), zero), others = max(lit::greatest(rest), zero);
    out.border.share = own * reciprocal(max(own + others, real(1e-20f)));
    out.albedo = rest + both;
    out.shares = lit::lobe_shares(out.rest, p.traits, p.reflection);
    return out;
}

/// Density of directions on the seen side that emitters are sampled for, too.
inline real pdf_of(const PathSurface& p, const PathLobes& lobes, vec3 l) {
    return lit::surface_pdf(lobes.rest, lobes.shares, l, p.traits, p.reflection) * (real(1.0f) - lobes.border.share);
}

/// Where a path continues.
struct PathStep {
    vec3 d, weight;
    real pdf;          ///< 0: this lobe is not that of any sampled emitter
    real is_through;   ///< 1 or 0
    real is_straight;  ///< likewise: on the same line
    real is_mirrored;  ///< likewise: by a mirror or clear glass
};

/// What masking leaves of a visible facet's light: G / G1(v) of the height-correlated form, Heitz 2014, eq. 99.
inline real masked_share(const PathSurface& p, vec3 l) {
    const lit::MaterialSurface& s = p.surface();
    const real n_l = abs(dot(s.base.n, l)), n_v = abs(dot(s.base.n, s.base.v));
    const auto stretch = [&](vec3 d, real cosine) {
        return p.traits.is_anisotropic != 0
                   ? lit::ggx_stretch(s.base.n, s.tangent, s.bitangent, d, s.alpha_x, s.alpha_y)
                   : lit::ggx_stretch_isotropic(cosine, s.alpha_x);
    };
    const real stretch_l = stretch(l, n_l), stretch_v = stretch(s.base.v, n_v);
    return min(n_l * (n_v + stretch_v) * reciprocal(max(n_l * stretch_v + n_v * stretch_l, real(1e-9f))), real(1.0f));
}

/// The facet that a path meets. @param is_rough  else the surface itself
inline vec3 facet_of(const PathSurface& p, mask is_rough, vec2 u) {
    const lit::MaterialSurface& s = p.surface();
    const vec3 n = s.base.n, v = s.base.v;
    if (no_lane(is_rough)) return n;
    const vec3 l = p.traits.is_anisotropic != 0 ? lit::sample_ggx(n, s.tangent, s.bitangent, v, s.alpha_x, s.alpha_y, u)
                                                : lit::sample_ggx_isotropic(n, v, s.alpha_x, u);
    return select(is_rough, lit::half_vector(l, v, n), n);
}

/// Lanes whose border is of facets.
inline mask is_rough_border(const PathSurface& p) {
    const bool has_lobe = p.job.material().metallic_roughness != 0 && p.job.is_pbr();
    return has_lobe ? p.surface().alpha_x > real(RL_MIRROR_ALPHA) : mask(false);
}

/// By the border. @param choice  [0, 1)
inline PathStep step_by_border(const PathSurface& p, const PathLobes& lobes, real choice, vec2 u) {
    const PathBorder& border = lobes.border;
    const real one(1.0f), zero(0.0f);
    const vec3 n = p.surface().base.n, v = p.surface().base.v;
    const mask is_rough = is_rough_border(p);
    const vec3 h = facet_of(p, is_rough, u);
    const lit::Transport t = border_weights(p, border, clamp(dot(h, v), zero, one));
    const real q_through = max(lit::greatest(t.refracted), zero), q_back = max(lit::greatest(t.reflected), zero);
    const real total = max(q_through + q_back, real(1e-20f));
    const mask is_through = choice * total < q_through;
    // A thin wall leads light on as it would mirror it, but behind the wall: glTF's KHR_materials_transmission.
    const vec3 mirrored = lit::mirrored_about(h, v), behind = mirrored - n * (dot(mirrored, n) * real(2.0f));
    const vec3 on = border.bends ? lit::refracted(h, v, border.eta) : select(is_rough, behind, -v);
    PathStep step;
    step.d = select(is_through, on, mirrored);
    const real q = select(is_through, q_through, q_back);
    const real masked = select(is_rough, masked_share(p, step.d), one);
    step.weight = select(is_through, t.refracted, t.reflected) * (masked * total * reciprocal(max(q, real(1e-20f))));
    step.pdf = zero;
    step.is_through = select(is_through, one, zero);
    step.is_mirrored = one;
    step.is_straight = border.bends ? zero : select(is_through && !is_rough, one, zero);
    const real side = dot(step.d, p.plane);
    const mask is_right = select(is_through, -side, side) > zero;
    // Bumped and interpolated normals may lead to the wrong side: along the surface then.
    const vec3 kept = select(is_through, -above(-step.d, p.plane), above(step.d, p.plane));
    step.d = select(is_right || !is_rough, kept, step.d);
    step.weight = select(is_right || !is_rough, step.weight, vec3(zero));
    return step;
}

/// Lanes where sample_surface() draws the direction of a mirror's lobe.
inline mask draws_mirror(const PathSurface& p, const PathLobes& lobes, real choice) {
    if (!p.job.is_pbr()) return mask(false);
    const lit::LobeShares& shares = lobes.shares;
    const lit::MaterialSurface& s = lobes.rest;
    const mask is_gloss = choice >= shares.diffuse && choice < shares.diffuse + shares.specular;
    const mask is_coat = choice >= real(1.0f) - shares.coat && shares.coat > real(0.0f);
    return (is_gloss && max(s.alpha_x, s.alpha_y) <= real(RL_MIRROR_ALPHA)) ||
           (is_coat && s.coat_alpha <= real(RL_MIRROR_ALPHA));
}

inline PathStep step_by_lobes(const PathSurface& p, const PathLobes& lobes, real choice, vec2 u) {
    const real zero(0.0f);
    PathStep step;
    step.d = lit::sample_surface(lobes.rest, lobes.shares, p.traits, p.reflection, choice, u);
    step.pdf = pdf_of(p, lobes, step.d);
    const vec3 terms = reflected_terms(p, lobes.rest, unit_light(step.d), is_above(p, step.d));
    const mask is_sound = step.pdf > real(1e-20f);
    step.weight = select(is_sound, terms * reciprocal(max(step.pdf, real(1e-20f))), vec3(zero));
    step.is_through = step.is_straight = zero;
    step.is_mirrored = select(draws_mirror(p, lobes, choice), real(1.0f), zero);
    return step;
}

/// @param there   0..1, of the surface; the border's weights know it
/// @param choice  [0, 1)
inline PathStep next_step(const PathSurface& p, const PathLobes& lobes, real there, real choice, vec2 u) {
    const real share = lobes.border.share, one(1.0f);
    if (!lobes.border.is_there) return step_by_lobes(p, lobes, choice, u);
    const mask by_border = choice < share;
    const real own = choice * reciprocal(max(share, real(1e-20f)));
    const real others = (choice - share) * reciprocal(max(one - share, real(1e-20f)));
    const PathStep border = step_by_border(p, lobes, own, u), lobe = step_by_lobes(p, lobes, others, u);
    PathStep step;
    step.d = select(by_border, border.d, lobe.d);
    step.weight = select(by_border, border.weight * reciprocal(max(share, real(1e-20f))), lobe.weight * there);
    step.pdf = select(by_border, border.pdf, lobe.pdf);
    step.is_through = select(by_border, border.is_through, lobe.is_through);
    step.is_straight = select(by_border, border.is_straight, lobe.is_straight);
    step.is_mirrored = select(by_border, border.is_mirrored, lobe.is_mirrored);
    return step;
}

}  // namespace rakelight::raytrace::RL_ISA
