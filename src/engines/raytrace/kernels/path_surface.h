// SPDX-License-Identifier: Apache-2.0
// A vector of hits as paths of light see it: the surface of cpu_shading/kernels/shade_points.h, with normals
// that lead nothing below it, and what it reflects. Per instruction set.
#pragma once
#include "cpu_shading/kernels/finite.h"
#include "engines/raytrace/kernels/shade_hits.h"

namespace rakelight::raytrace::RL_ISA {

/// Planes of a job's hits, one vector of them.
struct PathPlanes {
    const PathJob& job;
    int32_t first;
    real in(int32_t plane) const { return load(job.in + int64_t(plane) * job.stride + first); }
    vec3 in3(int32_t plane) const { return vec3(in(plane), in(plane + 1), in(plane + 2)); }
    void put(int32_t plane, real v) const { store(job.out + int64_t(plane) * job.stride + first, v); }
    void put3(int32_t plane, vec3 v) const { put(plane, v.x), put(plane + 1, v.y), put(plane + 2, v.z); }
};

struct PathSurface {
    const EveryJob job;
    HitSource<1> source;
    EveryPoint point;
    vec3 plane;  ///< unit normal of the triangle, on the seen side
    vec3 view;   ///< unit, to where the ray comes from
    vec3 even;   ///< unit, the interpolated normal without bumps, on the seen side
    lit::MaterialTraits traits;
    lit::Reflection reflection;

    PathSurface(const HitJob& hits, int32_t first) : job{hits}, source(hits, first) {}
    const Hits& hit() const { return source.hits[0]; }
    lit::MaterialSurface& surface() { return point.surface; }
    const lit::MaterialSurface& surface() const { return point.surface; }
};

/// A normal of the gloss that leads no light below the surface; the diffuse term keeps its own. The view is along the ray.
inline void set_valid_normals(PathSurface& p) {
    lit::MaterialSurface& s = p.surface();
    s.base.v = p.view;
    s.base.n = lit::valid_normal(s.base.n, p.view, p.plane);
    p.traits.has_two_normals = 1;
}

/// All that is known of a vector of hits.
inline void find_path_surface(PathSurface& p) {
    const EveryJob& job = p.job;
    cpu::Points<cpu::EveryMaterial, 1> b;
    b.count = 1;
    cpu::find_places(job, p.source, b);
    cpu::find_materials(job, p.source, true, b);
    p.point = b.of[0];
    EveryPoint& s = p.point;
    p.traits = job.traits(), p.reflection = job.reflection();
    p.plane = HitSource<1>::face_normal(p.hit());
    p.view = -safe_normalize(p.hit().along);
    cpu::set_directions(job, p.source.of(0), s.point, s.bumps, s.surface);
    set_valid_normals(p);
    p.even = s.bumps.frame.normal * s.bumps.frame.side;
    s.texels.occlusion = real(1.0f);  // paths find what lies around
    s.emission = cpu::finish_surface(job, s.point, s.texels, p.even, s.emission, s.surface);
    if (!job.is_pbr()) s.surface.coat_n = s.surface.base.n, s.surface.coat_alpha = real(1.0f);
    s.surface.coat_n = lit::valid_normal(s.surface.coat_n, p.view, p.plane);
}

/// Lanes where light from l arrives on the seen side of the triangle.
inline mask is_above(const PathSurface& p, vec3 l) { return dot(l, p.plane) > real(0.0f); }
/// The same of the round surface that smooth normals pretend: for lights without an area, whose shadow rays begin on it.
inline mask is_above_even(const PathSurface& p, vec3 l) { return dot(l, p.even) > real(0.0f); }

/// What the surface sends back of a light; nothing is in shadow. @param arrives  lanes where it does
inline vec3 reflected_terms(const PathSurface& p, const lit::MaterialSurface& s, const lit::LightSample& light,
                            mask arrives) {
    const lit::LightTerms terms = cpu::material_terms(p.job, s, light, real(1.0f), p.traits);
    return select(arrives, terms.diffuse + terms.specular, vec3(real(0.0f)));
}

/// A light whose terms are f cos.
inline lit::LightSample unit_light(vec3 l) {
    const vec3 color(real(0.318309886f));
    return {l, real(1.0f), vec3(real(0.0f)), color, color};
}

}  // namespace rakelight::raytrace::RL_ISA
