// SPDX-License-Identifier: Apache-2.0
// Where paths hit surfaces: light of lights without an area, the ray to an emitter, and the continuation of the path.
// Sources: Kajiya 1986, "The Rendering Equation"; Veach 1997, "Robust Monte Carlo Methods for Light Transport
// Simulation", section 9.2.4 (the balance heuristic). Compiled once per instruction set.
#include "engines/raytrace/kernels/path_lobes.h"

namespace rakelight::raytrace::RL_ISA {
namespace {

using Seen = SeenByRays<cpu::EveryMaterial, 1>;

/// Light that a rough thin wall lets through. @param l  to the light, behind the wall
vec3 through_terms(const PathSurface& p, const PathLobes& lobes, const lit::LightSample& light) {
    const lit::MaterialSurface& s = p.surface();
    const real zero(0.0f);
    if (!lobes.border.is_there || lobes.border.bends) return vec3(zero);
    const vec3 n = s.base.n, mirrored = light.l - n * (dot(light.l, n) * real(2.0f));
    const mask is_behind = !is_above_even(p, light.l) && is_rough_border(p) && lobes.border.acts;
    if (no_lane(is_behind)) return vec3(zero);
    const vec3 h = lit::half_vector(mirrored, s.base.v, n);
    const lit::Transport t = border_weights(p, lobes.border, clamp(dot(h, s.base.v), zero, real(1.0f)));
    const real brdf = lit::pbr_lobe(s, mirrored, p.traits);
    const vec3 radiance = lit::radiance_of(t.refracted * brdf, light.specular, abs(dot(n, light.l)), light.attenuation);
    return select(is_behind, radiance, vec3(zero));
}

/// What light i brings to lanes. @param scale  0: not to this lane
vec3 light_terms_of(const PathSurface& p, const PathLobes& lobes, int32_t i, real scale) {
    const Seen seen{p.source.job, p.source};
    const vec3 none(real(0.0f));
    lit::LightSample light = cpu::sample_light_at(p.job, p.source, p.point, 0, i);
    const bool is_thin = lobes.border.is_there && !lobes.border.bends;
    const mask is_before = is_above_even(p, light.l);
    if (!is_thin) light.attenuation = select(is_before, light.attenuation, real(0.0f));
    light.attenuation = light.attenuation * scale;
    const mask arrives = light.attenuation > real(0.0f);
    if (no_lane(arrives)) return none;
    const real part = cpu::seen_of(p.job, p.point, 0, i, light, seen);
    const vec3 sum = reflected_terms(p, lobes.lit_surface, light, is_before) + through_terms(p, lobes, light);
    return select(arrives, sum * part, none);
}

/// All lights, or for each lane those that were picked for it.
vec3 light_of_lights(const PathJob& job, const PathSurface& p, const PathLobes& lobes, const PathPlanes& planes) {
    vec3 sum(real(0.0f));
    if (job.picked_lights < 0) {
        for (int32_t i = 0; i < job.hits.light_count; ++i) sum = sum + light_terms_of(p, lobes, i, real(1.0f));
        return sum;
    }
    for (int32_t k = 0; k < job.picked_lights; ++k) {
        const real picked = planes.in(in_lights + k);
        float numbers[lanes];
        store(numbers, picked);
        for (int32_t lane = 0; lane < lanes; ++lane) {
            bool is_first = numbers[lane] >= 0.0f;
            for (int32_t before = 0; before < lane; ++before) is_first = is_first && numbers[before] != numbers[lane];
            if (!is_first) continue;
            const auto i = int32_t(numbers[lane]);
            sum = sum + light_terms_of(p, lobes, i,
                                       select(picked == real(numbers[lane]), real(job.light_scale[i]), real(0.0f)));
        }
    }
    return sum;
}

/// The place on an emitter, as far off its plane as rays begin off surfaces: they end before it.
vec3 before_emitter(const PathSurface& p, vec3 place, vec3 normal, real size, vec3 origin) {
    const real largest =
        max(max(largest_component(place), size), largest_component(place + splat(p.source.job.to_rays)));
    const real offset = largest * real(ray_offset);
    return place + normal * select(dot(normal, origin - place) < real(0.0f), -offset, offset);
}

/// The ray to the emitter that was sampled, and what its radiance counts. @param share  what fog leaves on the way to the surface
void put_emitter(const PathSurface& p, const PathLobes& lobes, real share, const PathPlanes& planes) {
    const Hits& h = p.hit();
    const real zero(0.0f), density = planes.in(in_emitter_pdf);
    const mask is_far = planes.in(in_emitter_is_far) > zero;
    const vec3 normal = planes.in3(in_emitter_n);
    const vec3 origin = h.position + p.plane * h.offset(p.source.job, p.plane);
    const vec3 place = before_emitter(p, planes.in3(in_emitter), normal, planes.in(in_emitter_size), origin);
    const vec3 way = select(is_far, planes.in3(in_emitter), place - origin), l = safe_normalize(way);
    const real towards = -dot(normal, l), squared = dot(way, way);
    const real per_sr = select(is_far, density, density * squared * reciprocal(max(abs(towards), real(1e-9f))));
    const real faces = select(planes.in(in_emitter_both) > zero, abs(towards), towards);
    const mask can_shine = density > zero && is_above(p, l) && (is_far || faces > real(1e-6f));
    vec3 weight(zero);
    if (any_lane(can_shine)) {
        const vec3 terms = reflected_terms(p, lobes.rest, unit_light(l), can_shine);
        if (p.job.has_fog()) share = share * select(is_far, real(1.0f), cpu::fog_at(p.source.job, way));
        const real both = planes.job.asks_alone != 0 ? per_sr : per_sr + pdf_of(p, lobes, l);
        weight = select(can_shine, terms * (share * reciprocal(max(both, real(1e-30f)))), vec3(zero));
    }
    planes.put3(out_emitter_o, origin), planes.put3(out_emitter_d, way);
    planes.put3(out_emitter_weight, weight);
}

/// @param share  what fog leaves
/// @param there  0..1, of the surface
void put_step(const PathSurface& p, const PathLobes& lobes, real share, real there, const PathPlanes& planes) {
    const Hits& h = p.hit();
    const PathStep step =
        next_step(p, lobes, there, planes.in(in_choice), vec2(planes.in(in_direction), planes.in(in_direction + 1)));
    const real zero(0.0f), offset = h.offset(p.source.job, p.plane);
    const mask is_through = step.is_through > zero;
    planes.put3(out_o, h.position + p.plane * select(is_through, -offset, offset));
    planes.put3(out_d, safe_normalize(step.d));
    // The ray that goes straight on is in the fog from its own beginning.
    planes.put3(out_weight, step.weight * select(step.is_straight > zero, real(1.0f), share));
    planes.put(out_pdf, step.pdf), planes.put(out_through, step.is_through);
    planes.put(out_straight, step.is_straight), planes.put(out_mirrored, step.is_mirrored);
}

/// Emission: from the front, or from both sides.
vec3 own_light(const PathJob& job, const PathSurface& p) {
    const vec3 own = cpu::own_radiance(p.job, p.point);
    if (job.shines_behind != 0 || p.job.of.unlit != 0) return own;
    return select(p.hit().shows_front > real(0.0f), own, vec3(real(0.0f)));
}

void put_hit(const PathSurface& p, const PathPlanes& planes) {
    const Hits& h = p.hit();
    const vec3 way = h.position - h.origin;
    const real cosine = abs(dot(p.plane, p.view));
    planes.put(out_per_area, dot(way, way) * reciprocal(max(cosine, real(1e-9f))));
    planes.put(out_side, h.shows_front);
    planes.put3(out_normal, p.surface().base.n);
}

}  // namespace

int32_t walk(const PathJob* from) {
    const PathJob& job = *from;
    int32_t not_finite = 0;
    for (int32_t first = 0; first < job.hits.count; first += lanes) {
        const PathPlanes planes{job, first};
        PathSurface p(job.hits, first);
        find_path_surface(p);
        const Hits& h = p.hit();
        const mask is_front = h.shows_front > real(0.0f);
        // What is opened by alpha is as much thinner as it lets light through.
        const real there =
            job.hits.is_opened != 0 ? clamp(cpu::alpha_of(p.job, p.point), real(0.0f), real(1.0f)) : real(1.0f);
        const PathLobes lobes =
            find_lobes(p, select(is_front, load(job.eta_front + first), load(job.eta_back + first)), there);
        const real share = p.job.has_fog() ? cpu::fog_at(job.hits, h.position - h.origin) : real(1.0f);
        const bool is_lit = p.job.of.unlit == 0;
        put_hit(p, planes);
        planes.put3(out_own, own_light(job, p) * share);
        planes.put3(out_albedo, is_lit ? lobes.albedo : vec3(real(0.0f)));
        vec3 light(real(0.0f));
        if (is_lit) {
            light = light_of_lights(job, p, lobes, planes) * there;
            put_emitter(p, lobes, share * there, planes);
            put_step(p, lobes, share, there, planes);
        } else {
            for (int32_t plane = out_emitter_o; plane < out_side; ++plane) planes.put(plane, real(0.0f));
        }
        const vec3 color = cpu::behind_fog(p.job, h.position - h.origin, light);
        const int32_t alive = job.hits.count - first < lanes ? job.hits.count - first : lanes;
        store(job.hits.red + first, cpu::only_finite(color.x, alive, not_finite));
        store(job.hits.green + first, cpu::only_finite(color.y, alive, not_finite));
        store(job.hits.blue + first, cpu::only_finite(color.z, alive, not_finite));
        store(job.hits.alpha + first, cpu::alpha_of(p.job, p.point));
    }
    return not_finite;
}

void emission(const HitJob* job) {
    for (int32_t first = 0; first < job->count; first += lanes) {
        PathSurface p(*job, first);
        find_path_surface(p);
        const vec3 own = cpu::own_radiance(p.job, p.point);
        store(job->red + first, own.x), store(job->green + first, own.y), store(job->blue + first, own.z);
        store(job->alpha + first, cpu::alpha_of(p.job, p.point));
    }
}

}  // namespace rakelight::raytrace::RL_ISA
