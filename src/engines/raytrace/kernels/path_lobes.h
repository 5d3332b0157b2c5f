// SPDX-License-Identifier: Apache-2.0
// How a path leaves a surface: by its lobes, or, where light goes through or a classical surface mirrors, by the border of the
// two sides: Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces". Per instruction set.
#pragma once
#include "engines/raytrace/kernels/path_surface.h"

namespace rakelight::raytrace::RL_ISA {

/// What the border sends back and lets through, apart from the other lobes; uniform: whether there is such a thing at all.
struct PathBorder {
    bool is_there;
    mask acts;   ///< lanes that have it
    real share;  ///< 0..1 with which paths go there
    real eta;
    bool bends;
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
    if (job.material().metallic_roughness == 0) return classical_transport(job, p.point, cosine, border.eta).weights;
    const lit::MetallicRoughness at = cpu::metallic_roughness_at(job, p.point.point, p.point.texels);
    lit::Transport t = lit::metallic_transport(at, cpu::rgb(p.point.base.color), transmission_at(job, p.point),
                                               border.bends, cosine, border.eta);
    if (job.is_pbr()) lit::add_transport_layers(t, p.surface(), p.traits.has_sheen, p.traits.has_coat);
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

/// Takes the border's part out of the other lobes.
inline void part_border(const PathSurface& p, PathLobes& out) {
    const EveryJob& job = p.job;
    const bool is_metallic = job.material().metallic_roughness != 0;
    PathBorder& border = out.border;
    const real transmission = is_metallic ? transmission_at(job, p.point) : real(0.0f);
    border.acts = is_metallic ? transmission > real(0.0f) : mask(true);
    const real kept = is_metallic ? real(1.0f) - transmission : real(1.0f);
    const bool mirrors = is_metallic || job.material().mirror != shading::mirror_none;
    const mask takes_gloss = border.acts && mask(mirrors), none(false);
    const vec3 black(real(0.0f));
    out.lit_surface.base.diffuse = out.lit_surface.base.diffuse * kept;
    if (job.is_pbr())
        lit::leave_to_rays(out.rest, kept, takes_gloss, none, 1);
    else
        out.rest.base.diffuse = out.rest.base.diffuse * kept;
    out.rest.base.specular = select(takes_gloss, black, out.rest.base.specular);
    out.rest.f90 = select(takes_gloss, black, out.rest.f90);
    out.rest.scattering = select(takes_gloss, black, out.rest.scattering);
    const real cosine = clamp(dot(p.surface().base.n, p.surface().base.v), real(0.0f), real(1.0f));
    const lit::Transport t = border_weights(p, border, cosine);
    const vec3 both = select(border.acts, t.reflected * real(mirrors ? 1.0f : 0.0f) + t.refracted, black);
    const real own = max(greatest_of(both), real(0.0f)), others = max(greatest_of(albedo_of(p, out.rest)), real(0.0f));
    border.share = own * reciprocal(max(own + others, real(1e-20f)));
    out.albedo = out.albedo + both;
}

inline PathLobes find_lobes(const PathSurface& p, real eta) {
    PathLobes out;
    out.lit_surface = out.rest = p.surface();
    out.border = {has_border(p.job), mask(false), real(0.0f), eta, p.job.material().is_body != 0};
    if (!out.border.bends) out.border.eta = real(1.0f);
    out.albedo = vec3(real(0.0f));
    if (out.border.is_there) part_border(p, out);
    out.albedo = out.albedo + albedo_of(p, out.rest);
    out.shares = lit::lobe_shares(out.rest, p.traits, p.reflection);
    return out;
}

/// Density of directions on the seen side that emitters are sampled for, too.
inline real pdf_of(const PathSurface& p, const PathLobes& lobes, vec3 l) {
    return lit::surface_pdf(lobes.rest, lobes.shares, l, p.traits, p.reflection) * (real(1.0f) - lobes.border.share);
}

/// Where a path goes on.
struct PathStep {
    vec3 d, weight;
    real pdf;         ///< 0: this lobe is not that of any sampled emitter
    real is_through;  ///< 1 or 0
};

/// What masking leaves of a visible facet's light: G / G1(v) of the height-correlated form, Heitz 2014, eq. 99.
inline real masked_share(const PathSurface& p, vec3 l) {
    const lit::MaterialSurface& s = p.surface();
    const real alpha = max(s.alpha_x, s.alpha_y), n_l = abs(dot(s.base.n, l)), n_v = abs(dot(s.base.n, s.base.v));
    const real stretch_l = lit::ggx_stretch_isotropic(n_l, alpha), stretch_v = lit::ggx_stretch_isotropic(n_v, alpha);
    return min(n_l * (n_v + stretch_v) * reciprocal(max(n_l * stretch_v + n_v * stretch_l, real(1e-9f))), real(1.0f));
}

/// By the border. @param choice  [0, 1)
inline PathStep step_by_border(const PathSurface& p, const PathLobes& lobes, real choice, vec2 u) {
    const lit::MaterialSurface& s = p.surface();
    const PathBorder& border = lobes.border;
    const bool is_metallic = p.job.material().metallic_roughness != 0, has_lobe = is_metallic && p.job.is_pbr();
    const real one(1.0f), zero(0.0f);
    const vec3 n = s.base.n, v = s.base.v;
    const mask is_rough = has_lobe ? s.alpha_x > real(RL_MIRROR_ALPHA) : mask(false);
    vec3 h = n;
    if (any_lane(is_rough))
        h = select(is_rough, lit::half_vector(lit::sample_ggx_isotropic(n, v, s.alpha_x, u), v, n), n);
    const real cosine = clamp(dot(h, v), zero, one);
    const lit::Transport t = border_weights(p, border, cosine);
    const bool mirrors = is_metallic || p.job.material().mirror != shading::mirror_none;
    const vec3 reflected = mirrors ? t.reflected : vec3(zero);
    const real q_through = max(greatest_of(t.refracted), zero), q_back = max(greatest_of(reflected), zero);
    const real total = max(q_through + q_back, real(1e-20f));
    const mask is_through = choice * total < q_through;
    // A thin wall leads light on as it would mirror it, but behind the wall: glTF's KHR_materials_transmission.
    const vec3 mirrored = lit::mirrored_about(h, v), behind = mirrored - n * (dot(mirrored, n) * real(2.0f));
    const vec3 bent = lit::refracted(h, v, border.eta);
    const vec3 on = border.bends ? bent : has_lobe ? select(is_rough, behind, -v) : -v;
    PathStep step;
    step.d = select(is_through, on, mirrored);
    const real q = select(is_through, q_through, q_back);
    const real masked = select(is_rough, masked_share(p, step.d), one);
    step.weight = select(is_through, t.refracted, reflected) * (masked * total * reciprocal(max(q, real(1e-20f))));
    step.pdf = zero;
    step.is_through = select(is_through, one, zero);
    const real side = dot(step.d, p.plane);
    const mask is_right = select(is_through, -side, side) > zero;
    // Bumped and interpolated normals may lead to the wrong side: along the surface then.
    const vec3 kept = select(is_through, -above(-step.d, p.plane), above(step.d, p.plane));
    step.d = select(is_right || !is_rough, kept, step.d);
    step.weight = select(is_right || !is_rough, step.weight, vec3(zero));
    return step;
}

inline PathStep step_by_lobes(const PathSurface& p, const PathLobes& lobes, real choice, vec2 u) {
    const real zero(0.0f);
    PathStep step;
    step.d = lit::sample_surface(lobes.rest, lobes.shares, p.traits, p.reflection, choice, u);
    step.pdf = pdf_of(p, lobes, step.d);
    const vec3 terms = reflected_terms(p, lobes.rest, unit_light(step.d));
    const mask is_sound = step.pdf > real(1e-20f);
    step.weight = select(is_sound, terms * reciprocal(max(step.pdf, real(1e-20f))), vec3(zero));
    step.is_through = zero;
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
    return step;
}

}  // namespace rakelight::raytrace::RL_ISA
