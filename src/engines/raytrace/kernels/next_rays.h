// SPDX-License-Identifier: Apache-2.0
// Where rays continue from hits, with what weight, and how they differ from pixel to pixel: Igehy 1999, "Tracing Ray Differentials",
// eq. 10 to 17. The weights are those of lighting/material/transport.glsl. Per instruction set.
#pragma once
#include "engines/raytrace/kernels/hits.h"

namespace rakelight::raytrace::RL_ISA {

using EveryJob = cpu::Job<cpu::EveryMaterial>;
using EveryPoint = cpu::PointState<cpu::EveryMaterial>;

static_assert(RL_MIRROR_ALPHA >= shading::widest_mirror * shading::widest_mirror &&
              RL_MIRROR_ALPHA < 1.02f * shading::widest_mirror * shading::widest_mirror);
static_assert(shading::mirror_constant == RL_MIRROR_CONSTANT && shading::mirror_fresnel == RL_MIRROR_FRESNEL);

/// What is mirrored and let through at a vector of hits, and what is left of the surface's own light.
struct HitTransport {
    lit::Transport weights;
    real kept;     ///< of the diffuse terms
    mask mirrors;  ///< lanes whose gloss rays bring
    mask coats;    ///< lanes whose coat's gloss rays bring
};

/// Matte models have no gloss that could mirror.
inline bool has_gloss(const EveryJob& job) { return !RL_IS_MATTE(job.model()); }

inline HitTransport classical_transport(const EveryJob& job, const EveryPoint& s, real cosine, real eta) {
    const cpu_shading::MaterialView& m = job.material();
    const vec4 texel = cpu::texel_or_white(job, role_specular, s.point);
    const vec3 k_s = has_gloss(job) ? splat(m.specular) * cpu::rgb(texel) : vec3(real(0.0f));
    const real open = m.blend != 0 ? real(1.0f) - clamp(s.base.color.w, real(0.0f), real(1.0f)) : real(1.0f);
    const mask none(false);
    return {lit::classical_transport(k_s, splat(m.filter) * open, m.mirror, m.is_body, cosine, eta), real(1.0f),
            mask(m.mirror != shading::mirror_none), none};
}

inline real transmission_at(const EveryJob& job, const EveryPoint& s) {
    return real(job.material().transmission) * cpu::texel_or_white(job, role_transmission, s.point).x;
}

inline HitTransport metallic_transport(const EveryJob& job, const EveryPoint& s, real cosine, real eta) {
    const cpu_shading::MaterialView& m = job.material();
    const lit::MetallicRoughness at = cpu::metallic_roughness_at(job, s.point, s.texels);
    const real transmission = transmission_at(job, s);
    const int32_t bends = m.is_body;
    HitTransport out;
    const int32_t has_film = job.is_pbr() && job.traits().has_iridescence;
    out.weights = lit::metallic_transport(at, cpu::rgb(s.base.color), transmission, bends, cosine, eta, has_film,
                                          has_film != 0 ? s.surface.base.specular : vec3(real(0.0f)));
    out.kept = real(1.0f) - transmission;
    const real alpha = job.is_pbr() ? max(s.surface.alpha_x, s.surface.alpha_y) : lit::alpha_of_roughness(at.roughness);
    out.mirrors = alpha <= real(RL_MIRROR_ALPHA) && mask(has_gloss(job));
    const mask is_total = lit::refracted_cosine_squared(cosine, eta) <= real(0.0f) && transmission > real(0.0f);
    out.weights.reflected = select(out.mirrors || is_total, out.weights.reflected, vec3(real(0.0f)));
    out.coats = mask(false);
    if (!job.is_pbr()) return out;
    const lit::MaterialTraits traits = job.traits();
    lit::add_transport_layers(out.weights, s.surface, traits.has_sheen, traits.has_coat);
    if (traits.has_coat != 0) out.coats = s.surface.coat_alpha <= real(RL_MIRROR_ALPHA);
    return out;
}

/// Planes of the rays that continue, of one vector of hits.
struct NextPlanes {
    const NextRays& to;
    int32_t first;
    void put(int32_t plane, real v) const { store(to.planes + int64_t(plane) * to.stride + first, v); }
    void put3(int32_t plane, vec3 v) const { put(plane, v.x), put(plane + 1, v.y), put(plane + 2, v.z); }
};

/// Of the ray that comes: unit, with its change.
struct UnitRay {
    vec3 d, dx, dy;
};
inline UnitRay unit_ray(const HitJob& job, const Hits& h) {
    const vec3 d = safe_normalize(h.along);
    const auto change = [&](int32_t plane) { return change_of_unit(d, h.along, ray_vector(job.rays, plane, h.ray)); };
    return {d, change(ray_d_dx), change(ray_d_dy)};
}

/// The mirrored direction, kept on the seen side of the surface's plane, where bumped and interpolated normals lead below it.
inline vec3 above(vec3 d, vec3 plane) {
    const real depth = dot(d, plane), least(1e-3f);
    return select(depth < least, safe_normalize_or(d + plane * (least - depth), plane), d);
}

/// Igehy's eq. 15. @param n  unit, against the ray; `turn`: its change
inline vec3 change_of_mirrored(vec3 d, vec3 n, vec3 change, vec3 turn) {
    return change - (turn * dot(d, n) + n * (dot(change, n) + dot(d, turn))) * real(2.0f);
}

/// Eq. 17.
inline vec3 change_of_refracted(vec3 d, vec3 n, vec3 out, real eta, vec3 change, vec3 turn) {
    const real in_cosine = dot(d, n), out_cosine = min(dot(out, n), real(-1e-3f));
    const real factor = eta * in_cosine - out_cosine;
    const real part = dot(change, n) + dot(d, turn);
    const real grows = (eta - eta * eta * in_cosine / out_cosine) * part;
    return change * eta - (turn * factor + n * grows);
}

/// @param n  unit normal of the lobe, on the seen side
inline void put_lobes(const HitJob& job, const Hits& h, const EveryPoint& s, const lit::Transport& weights, real eta,
                      vec3 plane, real share, const NextPlanes& to) {
    const UnitRay ray = unit_ray(job, h);
    const vec3 move_x = h.change_of_position(job, 0), move_y = h.change_of_position(job, ray_o_dy - ray_o_dx);
    to.put3(next_o, h.position), to.put3(next_n, plane), to.put(next_side, h.shows_front);
    to.put(next_offset, h.offset(job, plane));
    to.put3(next_o_dx, move_x), to.put3(next_o_dy, move_y);
    const auto lobe = [&to](int32_t number, vec3 d, vec3 dx, vec3 dy, vec3 weight) {
        const int32_t base = next_lobes + number * lobe_planes;
        to.put3(base + lobe_d, d), to.put3(base + lobe_d_dx, dx), to.put3(base + lobe_d_dy, dy);
        to.put3(base + lobe_weight, weight);
    };
    const vec3 n = s.surface.base.n;
    const vec3 turn_x = h.change_of_normal(job, n, move_x), turn_y = h.change_of_normal(job, n, move_y);
    const auto mirrored = [&](int32_t number, vec3 normal, vec3 weight) {
        lobe(number, above(lit::mirrored_about(normal, -ray.d), plane),
             change_of_mirrored(ray.d, normal, ray.dx, turn_x), change_of_mirrored(ray.d, normal, ray.dy, turn_y),
             weight * share);
    };
    mirrored(lobe_reflected, n, weights.reflected);
    mirrored(lobe_coat, s.surface.coat_n, weights.coat);
    const bool bends = job.material->is_body != 0;
    const vec3 out = bends ? -above(-lit::refracted(n, -ray.d, eta), plane) : ray.d;
    lobe(lobe_refracted, out, bends ? change_of_refracted(ray.d, n, out, eta, ray.dx, turn_x) : ray.dx,
         bends ? change_of_refracted(ray.d, n, out, eta, ray.dy, turn_y) : ray.dy, weights.refracted * share);
}

/// Writes the rays that continue from a vector of hits, and takes out of the surface what they bring.
inline void find_next(const EveryJob& job, const HitJob& hits, const Hits& h, int32_t first, EveryPoint& s) {
    const vec3 n = s.surface.base.n;
    const mask is_front = h.shows_front > real(0.0f);
    const real eta = select(is_front, load(hits.next->eta_front + first), load(hits.next->eta_back + first));
    const bool bends = hits.material->is_body != 0;
    const vec3 v = -safe_normalize(h.along);
    const real cosine = clamp(dot(n, v), real(0.0f), real(1.0f)), used = bends ? eta : real(1.0f);
    if (!job.is_pbr()) s.surface.coat_n = n, s.surface.coat_alpha = real(1.0f);
    const HitTransport t = job.material().metallic_roughness != 0 ? metallic_transport(job, s, cosine, used)
                                                                  : classical_transport(job, s, cosine, used);
    const vec3 plane = HitSource<1>::face_normal(h);
    const real share = job.has_fog() ? cpu::fog_at(hits, h.position - h.origin) : real(1.0f);
    put_lobes(hits, h, s, t.weights, used, plane, share, {*hits.next, first});
    lit::leave_to_rays(s.surface, t.kept, t.mirrors, t.coats, job.is_pbr() && hits.has_light_around != 0);
}

/// 1, or 1 over what would be more than arrives: of the light that a classical surface sends on.
/// @param mirrors  its gloss does, as the weights say
/// @param there    0..1, of the surface; the weights know it
inline vec3 classical_kept(const lit::Surface& s, bool has_gloss, bool mirrors, const lit::Transport& weights,
                           real there) {
    const vec3 own = (has_gloss && !mirrors ? s.diffuse + s.specular : s.diffuse) * there;
    const vec3 sum = own + weights.refracted + weights.reflected * real(mirrors ? 1.0f : 0.0f);
    const real one(1.0f);
    return vec3(reciprocal(max(sum.x, one)), reciprocal(max(sum.y, one)), reciprocal(max(sum.z, one)));
}

inline vec3 straight_through_classical(const EveryJob& job, const HitJob& hits, real cosine, EveryPoint& s) {
    const cpu_shading::MaterialView& m = job.material();
    const real one(1.0f), covered = one - clamp(s.base.color.w, real(0.0f), one);
    if (m.blend != 0 && !(m.filter[0] > 0.0f || m.filter[1] > 0.0f || m.filter[2] > 0.0f)) return vec3(covered);
    // Straight on, from either side: no total reflection.
    const float index = m.refraction > 0.0f ? m.refraction : 1.0f;
    const lit::Transport t = classical_transport(job, s, cosine, real(index > 1.0f ? 1.0f / index : index)).weights;
    if (hits.is_path == 0) return t.refracted;
    cpu::set_material(job, s.point, s.texels, s.base, s.surface);
    const real there = m.blend != 0 ? one - covered : one;
    return t.refracted * classical_kept(s.surface.base, has_gloss(job), m.mirror != shading::mirror_none, t, there);
}

/// What goes straight through a vector of surfaces, as shadows see it: without refraction.
inline vec3 straight_through(const EveryJob& job, const HitJob& hits, const Hits& h, EveryPoint& s) {
    const vec3 n = HitSource<1>::face_normal(h), v = -safe_normalize(h.along);
    const real one(1.0f), cosine = clamp(dot(n, v), real(0.0f), one);
    s.texels = cpu::material_texels(job, s.point);
    if (job.material().metallic_roughness == 0) return straight_through_classical(job, hits, cosine, s);
    const lit::MetallicRoughness at = cpu::metallic_roughness_at(job, s.point, s.texels);
    const real transmission = transmission_at(job, s);
    vec3 share = lit::metallic_transport(at, cpu::rgb(s.base.color), transmission, 0, cosine, one, 0, vec3(real(0.0f)))
                     .refracted;
    if (hits.is_path != 0 && job.is_pbr()) {
        cpu::set_material(job, s.point, s.texels, s.base, s.surface);
        share = select(s.surface.alpha_x > real(RL_MIRROR_ALPHA), vec3(real(0.0f)), share);
    }
    if (job.material().blend == 0) return share;
    const real alpha = clamp(s.base.color.w, real(0.0f), one);
    return vec3(one - alpha) + share * alpha;  // what the surface does not cover passes whole
}

}  // namespace rakelight::raytrace::RL_ISA
