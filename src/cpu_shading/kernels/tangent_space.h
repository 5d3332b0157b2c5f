// SPDX-License-Identifier: Apache-2.0
// Lighting in tangent space: directions taken through the inverse (or the transposed) of the frame's matrix, at the
// pixel, or at the vertices with interpolation between them. What comes out is turned back into the world by an
// orthonormal frame, which changes no angle: all that follows is as ever. Per instruction set.
#pragma once
#include "cpu_shading/kernels/job.h"

namespace rakelight::cpu_shading::RL_ISA {

/// `to(position)`: the vector of the world from a vertex to the light or to the viewer. Not unit: interpolated as a
/// vertex stage hands it on. @param of  CornerFrames corners(), and interpolate(a, b, c) between three corners
template <class Source, class To>
inline vec3 through_vertices(const MaterialJob& job, const Source& of, const To& to) {
    const CornerFrames f = of.corners();
    const bool is_transposed = job.tangent_space == space_transposed;
    vec3 at[3];
    for (int k = 0; k < 3; ++k) {
        const vec3 n = safe_normalize(f.normal[k]);
        const vec3 t = lit::map_tangent(n, f.tangent[k], job.orthogonalize), crossed = cross(n, t) * f.handedness;
        const vec3 b = job.has_bitangents != 0 ? safe_normalize_or(f.bitangent[k], crossed) : crossed;
        at[k] = lit::to_tangent_space(n, t, b, is_transposed, to(f.position[k]));
    }
    return of.interpolate(at[0], at[1], at[2]);
}

/// A direction of the world as the lighting of the job's tangent space has it: `world` at the pixel, to(position) from
/// the vertices.
template <class Kind, class Source, class To>
inline vec3 in_tangent_space(const Job<Kind>& job, const Source& of, const lit::Frame& f, vec3 world, const To& to) {
    if (!job.in_tangent_space()) return world;
    const vec3 d = job.of.tangent_space == space_pixel
                       ? lit::to_tangent_space(f.map_normal, f.map_tangent, f.map_bitangent, 0, world)
                       : through_vertices(job.of, of, to);
    return lit::tangent_space_direction(f, d, world);
}

template <class Kind, class Source>
inline vec3 viewer_in_tangent_space(const Job<Kind>& job, const Source& of, const lit::Frame& f, vec3 v) {
    return in_tangent_space(job, of, f, v, [&](vec3 position) {
        return lit::vertex_to_viewer(of.from_viewer(position), splat(job.of.view_direction), job.has_parallel_viewer());
    });
}

template <class Kind, class Source>
inline vec3 light_in_tangent_space(const Job<Kind>& job, const Source& of, const lit::Frame& f, int32_t i, vec3 l) {
    const lighting::LightParameters& light = job.of.lights[i];
    if (light.kind == lighting::LightKind::ambient) return l;
    return in_tangent_space(job, of, f, l, [&](vec3 position) {
        return lit::vertex_to_light(position, lit::broadcast3(light.position), lit::broadcast3(light.direction),
                                    light.kind == lighting::LightKind::directional);
    });
}

}  // namespace rakelight::cpu_shading::RL_ISA
