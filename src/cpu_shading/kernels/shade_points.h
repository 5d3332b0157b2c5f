// SPDX-License-Identifier: Apache-2.0
// From points to colors, stage by stage: the one writing of it for every engine of the processor. Find the points, look into
// their relief, what the material is there, its frame; then the lights one by one with what hides them, the environment,
// fog. Per instruction set.
//
// The engine brings a Source of points, all of one draw:
// - place(k, point): the k-th vector's position
// - texcoords(k, set, texcoords): texture coordinates, as far as the job asks for them
// - color(k), normal(k), tangent(k), openness(k): where the job has it
// - of(k): has corners() and interpolate(a, b, c), the CornerFrames of its triangles, and from_viewer(position), the
//   vector from where it is seen, the eye or the surface that mirrors it
// - is_lit_at_corners(), corner_light(k): LightTerms that are interpolated (flat and Gouraud shading), or false
//
// It also brings a functor seen(k, i, light): 0..1, how much of light i arrives; shadow maps, or rays. It may color the
// light.
#pragma once
#include "cpu_shading/kernels/fog.h"
#include "cpu_shading/kernels/light_around.h"
#include "cpu_shading/kernels/material.h"
#include "cpu_shading/kernels/normals.h"

namespace rakelight::cpu_shading::RL_ISA {

/// What is kept of a vector of points from stage to stage; of kernels for few materials as little as can be.
template <class Kind>
struct PointState {
    using Surface = lit::MaterialSurface;
    ShadingPoint point;
    Surface surface;
    real alpha, occlusion;
};
template <>
struct PointState<ClassicalMaterial> {
    using Surface = lit::Surface;
    ShadingPoint point;
    Surface surface;
    real alpha;
};
template <>
struct PointState<EveryMaterial> {
    using Surface = lit::MaterialSurface;
    ShadingPoint point;
    Surface surface;
    BaseColor base;
    MaterialTexels texels;
    vec3 emission;  ///< what lies over it leaves of it
    Bumps bumps;
};

inline lit::Surface& base_of(lit::Surface& s) { return s; }
inline lit::Surface& base_of(lit::MaterialSurface& s) { return s.base; }
inline const lit::Surface& base_of(const lit::Surface& s) { return s; }
inline const lit::Surface& base_of(const lit::MaterialSurface& s) { return s.base; }

/// Vectors of points that go through the stages side by side: what one waits for another one fills (a point's own
/// operations mostly depend on one another). Stages are cut where a root or a division makes what follows wait.
template <class Kind, int32_t most_vectors>
struct Points {
    static constexpr int32_t most = most_vectors;
    int32_t count;  ///< of vectors
    PointState<Kind> of[most];
};

/// Nothing is in shadow.
struct AllSeen {
    real operator()(int32_t, int32_t, lit::LightSample&) const { return real(1.0f); }
};

template <class Source>
inline void find_texcoords(const MaterialView& m, const Source& source, int32_t k, ShadingPoint& p) {
    if (m.uses_texcoords[0] != 0) source.texcoords(k, 0, p.texcoords[0]);
    if (m.uses_texcoords[1] != 0) source.texcoords(k, 1, p.texcoords[1]);
}

/// Position, texture coordinates, and where the ray hits the relief.
template <class Kind, int32_t most, class Source>
inline void find_places(const Job<Kind>& job, Source& source, Points<Kind, most>& b) {
    for (int32_t k = 0; k < b.count; ++k) source.place(k, b.of[k].point);
    for (int32_t k = 0; k < b.count; ++k) find_texcoords(job.material(), source, k, b.of[k].point);
    if constexpr (Kind::has_bump_choices)
        for (int32_t k = 0; k < b.count; ++k) {
            ShadingPoint& p = b.of[k].point;
            p.normal = source.normal(k);
            p.tangent = source.tangent(k);
            b.of[k].bumps.frame = frame_at(job, source.of(k), p);
            if (job.has_relief()) enter_relief(job.of, source.of(k).from_viewer(p.position), p, b.of[k].bumps);
        }
    for (int32_t k = 0; k < b.count; ++k) find_map_place(job.of, job.has_relief(), b.of[k].point);
}

template <class Kind, class Source>
[[gnu::always_inline]] inline BaseColor find_base_color(const Job<Kind>& job, const Source& source, int32_t k,
                                                        ShadingPoint& p) {
    if (job.material().vertex_colors != 0) p.color = source.color(k);
    return base_color(job, p);
}

template <class Kind, class Source>
inline MaterialTexels find_texels(const Job<Kind>& job, const Source& source, int32_t k, const ShadingPoint& p) {
    MaterialTexels texels = material_texels(job, p);
    if (job.of.openness != nullptr) texels.occlusion = texels.occlusion * source.openness(k);
    return texels;
}

/// What a surface is, without its directions. @param needs_alpha  false: it is taken for 1
template <class Kind, int32_t most, class Source>
[[gnu::noinline]] inline void find_materials(const Job<Kind>& job, const Source& source, bool needs_alpha,
                                             Points<Kind, most>& b) {
    for (int32_t k = 0; k < b.count; ++k) {
        PointState<Kind>& s = b.of[k];
        const BaseColor base = find_base_color(job, source, k, s.point);
        if constexpr (Kind::has_bump_choices) {
            s.base = base;
            s.texels = find_texels(job, source, k, s.point);
            set_material(job, s.point, s.texels, base, s.surface);
            s.emission = emission_of(job, s.point);
        } else {
            s.alpha = needs_alpha ? base.color.w : real(1.0f);
            if (job.of.unlit != 0) {
                base_of(s.surface).diffuse = rgb(base.color);
                continue;
            }
            const MaterialTexels texels = find_texels(job, source, k, s.point);
            set_material(job, s.point, texels, base, s.surface);
            if constexpr (Kind::models != Models::classical) s.occlusion = texels.occlusion;
        }
    }
}

/// Normals and directions to the viewer without choices, in stages.
template <class Kind, int32_t most, class Source>
[[gnu::noinline]] inline void find_mapped_normals(const Job<Kind>& job, const Source& source, Points<Kind, most>& b) {
    const bool is_mapped = job.normal_map() != nullptr;
    vec3 mapped[most];
    SignedVector normal[most], tangent[most];
    for (int32_t k = 0; k < b.count && is_mapped; ++k) mapped[k] = map_vector(job, b.of[k].point);
    for (int32_t k = 0; k < b.count; ++k) {
        normal[k] = source.normal(k);
        normal[k].v = safe_normalize(normal[k].v);
    }
    for (int32_t k = 0; k < b.count && is_mapped; ++k) {
        tangent[k] = source.tangent(k);
        tangent[k].v = lit::map_tangent(normal[k].v, tangent[k].v, job.of.orthogonalize);
    }
    for (int32_t k = 0; k < b.count; ++k) {
        const vec3 n =
            is_mapped ? lit::perturb_normal(normal[k].v, tangent[k].v, tangent[k].sign, mapped[k]) : normal[k].v;
        base_of(b.of[k].surface).n = n * normal[k].sign;
    }
    for (int32_t k = 0; k < b.count; ++k)
        base_of(b.of[k].surface).v = lit::to_viewer(source.of(k).from_viewer(b.of[k].point.position),
                                                    splat(job.of.view_direction), job.has_parallel_viewer());
}

/// What depends on directions.
template <class Kind, int32_t most, class Source>
inline void find_directions(const Job<Kind>& job, const Source& source, Points<Kind, most>& b) {
    if constexpr (Kind::has_bump_choices) {
        for (int32_t k = 0; k < b.count; ++k) {
            PointState<Kind>& s = b.of[k];
            set_directions(job, source.of(k), s.point, s.bumps, s.surface);
            const vec3 even = s.bumps.frame.normal * s.bumps.frame.side;
            s.emission = finish_surface(job, s.point, s.texels, even, s.emission, s.surface);
        }
        return;
    }
    find_mapped_normals(job, source, b);
    if constexpr (Kind::models == Models::pbr)
        for (int32_t k = 0; k < b.count && job.of.unlit == 0; ++k)
            lit::set_pbr_albedos(b.of[k].surface, maps_of(job.of), b.of[k].occlusion, job.of.has_light_around,
                                 job.traits());
}

/// What somebody wants to know of surfaces.
struct Wanted {
    bool normals;  ///< kernels for every material always find them
    bool alpha;
};

/// All that is known of the points before light falls on them.
template <class Kind, int32_t most, class Source>
inline void find_surfaces(const Job<Kind>& job, Source& source, const Wanted& wanted, Points<Kind, most>& b) {
    find_places(job, source, b);
    find_materials(job, source, wanted.alpha, b);
    // What pbr reflects of ambient light depends on the direction to the viewer, wherever the lights are evaluated.
    const bool by_direction = Kind::has_bump_choices || (Kind::models == Models::pbr && job.of.unlit == 0);
    if (by_direction || wanted.normals) find_directions(job, source, b);
}

/// One light's terms; `seen`, 0..1: how much of it reaches the surface.
template <class Kind>
[[gnu::noinline]] inline lit::LightTerms material_terms(const Job<Kind>& job, const lit::MaterialSurface& s,
                                                        const lit::LightSample& light, real seen,
                                                        const lit::MaterialTraits& traits) {
    const lit::LightAlbedo albedo = lit::light_albedo(s, maps_of(job.of), light.l, traits, job.model());
    return lit::surface_terms(s, light, seen, albedo, traits, job.reflection());
}
/// Classical ones, with nothing in shadow.
template <class Kind>
inline lit::LightTerms material_terms(const Job<Kind>& job, const lit::Surface& s, const lit::LightSample& light, real,
                                      const lit::MaterialTraits&) {
    return lit::light_terms(s, light, job.reflection());
}

/// Light i as the k-th vector of points meets it.
template <class Kind, class Source>
inline lit::LightSample sample_light_at(const Job<Kind>& job, const Source& source, const PointState<Kind>& s,
                                        int32_t k, int32_t i) {
    lit::LightSample light = lit::sample_light(job.of.lights[i], s.point.position);
    if constexpr (Kind::has_bump_choices)
        light.l = light_in_tangent_space(job, source.of(k), s.bumps.frame, i, light.l);
    return light;
}

/// 0..1: how much of light i is not in shadow, the relief's own too.
template <class Kind, class Seen>
inline real seen_of(const Job<Kind>& job, const PointState<Kind>& s, int32_t k, int32_t i, lit::LightSample& light,
                    const Seen& seen) {
    if constexpr (Kind::has_bump_choices) return seen(k, i, light) * relief_shadow(job, i, s.bumps, light);
    return seen(k, i, light);
}

/// Calls add(k, i, terms) for each vector and light that is evaluated at the points.
template <class Kind, int32_t most, class Source, class Seen, class Add>
inline void for_each_light(const Job<Kind>& job, const Source& source, const Points<Kind, most>& b, const Seen& seen,
                           const Add& add) {
    const lit::MaterialTraits traits = job.traits();
    const Job<typename Kind::UnderLight> under_light{job.of};
    lit::LightSample light[most];
    for (int32_t i = 0; i < job.of.light_count; ++i) {
        for (int32_t k = 0; k < b.count; ++k) light[k] = sample_light_at(job, source, b.of[k], k, i);
        for (int32_t k = 0; k < b.count; ++k) {
            if (Kind::models != Models::classical && no_lane(light[k].attenuation > real(0.0f))) continue;
            const real part = seen_of(job, b.of[k], k, i, light[k], seen);
            add(k, i, material_terms(under_light, b.of[k].surface, light[k], part, traits));
        }
    }
}

/// Calls add(k, terms) for all that falls on the surfaces: the lights in their order, then the environment, then what is
/// seen through them. What comes from the environment is found at the points in flat and Gouraud pictures too.
template <class Kind, int32_t most, class Source, class Seen, class Add>
inline void add_light(const Job<Kind>& job, const Source& source, const Points<Kind, most>& b, const Seen& seen,
                      const Add& add) {
    if (job.of.unlit != 0) return;
    if (source.is_lit_at_corners())
        for (int32_t k = 0; k < b.count; ++k)
            add(k, lit::corner_terms(base_of(b.of[k].surface), source.corner_light(k)));
    else
        for_each_light(job, source, b, seen,
                       [&add](int32_t k, int32_t, const lit::LightTerms& terms) { add(k, terms); });
    if constexpr (Kind::has_environment)
        for (int32_t k = 0; k < b.count && job.environment() != nullptr; ++k)
            add(k, environment_terms(job, b.of[k].surface));
    if constexpr (Kind::has_layers)
        for (int32_t k = 0; k < b.count && job.traits().has_transmission != 0; ++k)
            add(k, terms_from_behind(job, b.of[k].point, b.of[k].surface));
}

/// What shines without light.
template <class Kind>
inline vec3 own_radiance(const Job<Kind>& job, const PointState<Kind>& s) {
    if constexpr (Kind::has_bump_choices)
        return job.of.unlit != 0 ? lit::unlit(rgb(s.base.color), s.emission) : s.emission;
    else {
        const vec3 emission = emission_of(job, s.point);
        return job.of.unlit != 0 ? lit::unlit(base_of(s.surface).diffuse, emission) : emission;
    }
}

/// The colors, before the fog.
template <class Kind, int32_t most, class Source, class Seen>
inline void find_radiance(const Job<Kind>& job, const Source& source, const Points<Kind, most>& b, const Seen& seen,
                          vec3 (&radiance)[most]) {
    for (int32_t k = 0; k < b.count; ++k) radiance[k] = own_radiance(job, b.of[k]);
    add_light(job, source, b, seen, [&radiance](int32_t k, const lit::LightTerms& terms) {
        radiance[k] = radiance[k] + lit::radiance_of_terms(terms);
    });
}

/// Alpha, < 0 where the point is not there.
template <class Kind>
inline real alpha_of(const Job<Kind>& job, const PointState<Kind>& s) {
    if constexpr (Kind::has_bump_choices)
        return alpha_in_silhouette(job, s.bumps, s.base.color.w);
    else
        return s.alpha;
}

}  // namespace rakelight::cpu_shading::RL_ISA
