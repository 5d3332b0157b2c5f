// SPDX-License-Identifier: Apache-2.0
// The loop over a job's hits: stages of cpu_shading/kernels/shade_points.h, compiled for some of all materials. Shadow rays
// tell what light arrives. Per instruction set.
#pragma once
#include "cpu_shading/kernels/finite.h"
#include "engines/raytrace/kernels/next_rays.h"

namespace rakelight::raytrace::RL_ISA {

/// What light reaches a vector of hits, by a ray each to the light.
template <class Kind, int32_t most>
struct SeenByRays {
    const HitJob& job;
    const HitSource<most>& source;

    /// The place on the round surface that smooth normals pretend, which lies above the flat triangle and so is not shaded by its
    /// neighbors: Hanika 2021, "Hacking the Shadow Terminator".
    vec3 lifted_position(const Hits& h) const {
        if (job.mesh.normals == nullptr || job.lit_at != lit_at_points || job.shape.kind != shape_none)
            return h.position;
        vec3 normal[3];
        cpu::load_normals(job.mesh, h.corners, normal);
        vec3 lift[3];
        for (int32_t k = 0; k < 3; ++k) {
            const vec3 seen_normal = normal[k] * h.facing;
            lift[k] = seen_normal * -min(dot(h.position - h.corner[k], seen_normal), real(0.0f));
        }
        return h.position + h.interpolate(lift[0], lift[1], lift[2]);
    }

    /// Along which rays leave the surface, unit. Triangles of splats are tilted against the surface that they stand for.
    vec3 off_surface(const Hits& h) const {
        if (job.is_of_splats == 0 || job.mesh.normals == nullptr) return safe_normalize(h.normal);
        vec3 normal[3];
        cpu::load_normals(job.mesh, h.corners, normal);
        return safe_normalize(normal[0]);
    }

    real operator()(int32_t k, int32_t i, lit::LightSample& light) const {
        const lighting::LightParameters& from = job.lights[i];
        if (job.find_seen == nullptr || !from.casts_shadow || from.kind == lighting::LightKind::ambient)
            return real(1.0f);
        const Hits& h = source.hits[k];
        const bool is_far = from.kind == lighting::LightKind::directional;
        // About the world's axes, also where `light.l` is in tangent space.
        const vec3 at = lifted_position(h);
        const vec3 to_light = is_far ? -splat(from.direction) : splat(from.position) - at;
        const vec3 n = off_surface(h);
        const real side = select(dot(n, to_light) < real(0.0f), real(-1.0f), real(1.0f));
        float origin[3][lanes], direction[3][lanes], length[lanes], seen[3][lanes];
        const auto put = [](float(&to)[3][lanes], vec3 v) { store(to[0], v.x), store(to[1], v.y), store(to[2], v.z); };
        put(origin, at + n * (side * h.offset(job, n)));
        put(direction, to_light);
        store(length, select(light.attenuation > real(0.0f), real(is_far ? __builtin_inff() : 1.0f), real(-1.0f)));
        const int32_t first = source.first + k * lanes;
        for (int32_t lane = job.count - first; lane < lanes; ++lane) length[lane] = -1.0f;
        ShadowRays rays = {lanes,
                           first,
                           {origin[0], origin[1], origin[2]},
                           {direction[0], direction[1], direction[2]},
                           length,
                           {seen[0], seen[1], seen[2]}};
        job.find_seen(job.tracer, &rays);
        const vec3 color(load(seen[0]), load(seen[1]), load(seen[2]));
        const real part = max(max(color.x, color.y), color.z);
        const vec3 tint = color * reciprocal(max(part, real(1e-20f)));
        light.diffuse = light.diffuse * tint, light.specular = light.specular * tint;
        return part;
    }
};

/// `most` vectors at a time. @return how many components came out not finite
template <class Kind, int32_t most>
inline int32_t shade_hits(const HitJob& job) {
    const cpu::Job<Kind> material{job};
    const bool needs_alpha = job.material->blend != 0 || job.material->alpha_cutoff >= 0;
    int32_t not_finite = 0;
    for (int32_t first = 0; first < job.count; first += most * lanes) {
        HitSource<most> source(job, first);
        cpu::Points<Kind, most> b;
        const int32_t vectors = (job.count - first + lanes - 1) / lanes;
        b.count = vectors < most ? vectors : most;
        cpu::find_surfaces(material, source,
                           {.normals = job.unlit == 0 && job.lit_at == lit_at_points, .alpha = needs_alpha}, b);
        if constexpr (Kind::has_bump_choices)
            if (job.next != nullptr) find_next(material, job, source.hits[0], first, b.of[0]);
        vec3 radiance[most];
        cpu::find_radiance(material, source, b, SeenByRays<Kind, most>{job, source}, radiance);
        if constexpr (Kind::has_bump_choices)
            if (job.is_opened != 0)
                radiance[0] = radiance[0] * clamp(cpu::alpha_of(material, b.of[0]), real(0.0f), real(1.0f));
        for (int32_t k = 0; k < b.count; ++k) {
            const int32_t at = first + k * lanes;
            const vec3 color = cpu::behind_fog(material, b.of[k].point.position - source.hits[k].origin, radiance[k]);
            const int32_t alive = job.count - at < lanes ? job.count - at : lanes;
            store(job.red + at, cpu::only_finite(color.x, alive, not_finite));
            store(job.green + at, cpu::only_finite(color.y, alive, not_finite));
            store(job.blue + at, cpu::only_finite(color.z, alive, not_finite));
            store(job.alpha + at, cpu::alpha_of(material, b.of[k]));
        }
    }
    return not_finite;
}

// One for each KernelNumber.
int32_t shade_classical(const HitJob& job);
int32_t shade_pbr(const HitJob& job);
int32_t shade_pbr_environment(const HitJob& job);
int32_t shade_every(const HitJob& job);

}  // namespace rakelight::raytrace::RL_ISA
