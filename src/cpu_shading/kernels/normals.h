// SPDX-License-Identifier: Apache-2.0
// The normals that are lit: interpolated ones, bent by normal maps and by the slopes of heights. Per instruction set.
#pragma once
#include "cpu_shading/kernels/relief.h"
#include "cpu_shading/kernels/tangent_space.h"

namespace rakelight::cpu_shading::RL_ISA {

/// The normal map's vector in (tangent, bitangent, normal), not unit.
template <class Kind>
inline vec3 map_vector(const Job<Kind>& job, const ShadingPoint& p) {
    const MaterialView& m = job.material();
    const bool has_choices = Kind::has_bump_choices && (job.of.centered_normals != 0 || job.of.green_down != 0);
    if (is_shared(p, role_normal) && m.normal_scale == 1.0f && !has_choices)
        return lit::decode_twice_normal(rgb(sample<Kind::formats>(*m.map[role_normal].view, p.footprint, 2.0f)));
    return lit::decode_mapped(rgb(texel(job, role_normal, p)), real(m.normal_scale),
                              has_choices ? job.of.centered_normals : 0, has_choices ? job.of.green_down : 0);
}

/// The normal that the maps give, on the side that is lit.
template <class Kind>
inline vec3 bumped_normal(const Job<Kind>& job, const ShadingPoint& p, const Bumps& bumps) {
    const lit::Frame& f = bumps.frame;
    if (uses_slopes(job)) return lit::sloped_normal(f, slope_vector(job.of, p, bumps));
    if (job.normal_map() == nullptr) return f.normal * f.side;
    return lit::mapped_normal(f, map_vector(job, p), job.of.tangent_space == space_world);
}

/// Normals and direction to the viewer, with all that a job can ask for.
template <class Kind, class Source>
inline void set_directions(const Job<Kind>& job, const Source& of, const ShadingPoint& p, const Bumps& bumps,
                           lit::MaterialSurface& s) {
    const lit::Frame& f = bumps.frame;
    lit::set_normals(s, bumped_normal(job, p, bumps), f.normal * f.side, job.of.bump_terms);
    const vec3 v = lit::to_viewer(of.from_viewer(p.position), splat(job.of.view_direction), job.has_parallel_viewer());
    s.base.v = viewer_in_tangent_space(job, of, f, v);
}

}  // namespace rakelight::cpu_shading::RL_ISA
