// SPDX-License-Identifier: Apache-2.0
// Lighting in tangent space: directions taken through the inverse (or the transposed) of the frame's matrix, at the
// pixel, or at the vertices with interpolation between them. What comes out is turned back into the world by an
// orthonormal frame, which changes no angle: all that follows is as ever. Per instruction set.
#pragma once
#include "engines/raster/kernels/surface.h"

namespace rakelight::raster::RL_ISA {

/// Frames and places of each pixel's three vertices.
struct VertexFrames {
    vec3 position[3], n[3], t[3];
    real w;
};

inline vec3 part_of_corner(const real (&a)[corner_frame_floats], int first) {
    return vec3(a[first], a[first + 1], a[first + 2]);
}

inline VertexFrames vertex_frames(const ShadeJob& job, const Pixels& p) {
    const Records records(reinterpret_cast<const float*>(job.full->frames), corner_frame_floats, p.triangle);
    real a[corner_frame_floats];
    records.each<corner_frame_floats>(0, [&](int part, const part::real(&v)[corner_frame_floats]) {
        for (int k = 0; k < corner_frame_floats; ++k) part_of(a[k], part) = v[k];
    });
    VertexFrames out;
    out.w = a[27];
    for (int k = 0; k < 3; ++k) {
        out.position[k] = part_of_corner(a, 3 * k);
        out.n[k] = safe_normalize(part_of_corner(a, 9 + 3 * k));
        out.t[k] = lit::map_tangent(out.n[k], part_of_corner(a, 18 + 3 * k), job.orthogonalize);
    }
    return out;
}

/// `to(position)`: the vector of the world from a vertex to the light or to the viewer. Not unit: interpolated as a
/// vertex stage hands it on.
template <class To>
inline vec3 through_vertices(const ShadeJob& job, const Pixels& p, const To& to) {
    const VertexFrames f = vertex_frames(job, p);
    const bool is_transposed = job.full->tangent_space == space_transposed;
    vec3 at[3];
    for (int k = 0; k < 3; ++k) at[k] = lit::to_tangent_space(f.n[k], f.t[k], f.w, is_transposed, to(f.position[k]));
    return at[0] + (at[1] - at[0]) * p.b.b1 + (at[2] - at[0]) * p.b.b2;
}

/// A direction of the world as the lighting of the job's tangent space has it: `world` at the pixel, to(position) from
/// the vertices.
template <class To>
inline vec3 in_tangent_space(const ShadeJob& job, const Pixels& p, const lit::Frame& f, vec3 world, const To& to) {
    if (job.full->has_bumps == 0 || job.bump == 0 || job.full->tangent_space == space_world) return world;
    const vec3 d = job.full->tangent_space == space_pixel
                       ? lit::to_tangent_space(f.map_normal, f.map_tangent, f.w, 0, world)
                       : through_vertices(job, p, to);
    return lit::tangent_space_direction(f, d, world);
}

inline vec3 viewer_in_tangent_space(const ShadeJob& job, const Pixels& p, const lit::Frame& f, vec3 v) {
    return in_tangent_space(job, p, f, v, [&](vec3 position) {
        return lit::vertex_to_viewer(position, splat(job.view_direction),
                                     job.orthographic | job.full->viewer_at_infinity);
    });
}

inline vec3 light_in_tangent_space(const ShadeJob& job, const Pixels& p, const lit::Frame& f, int32_t i, vec3 l) {
    const lighting::LightParameters& light = job.lights[i];
    if (light.kind == lighting::LightKind::ambient) return l;
    return in_tangent_space(job, p, f, l, [&](vec3 position) {
        return lit::vertex_to_light(position, lit::broadcast3(light.position), lit::broadcast3(light.direction),
                                    light.kind == lighting::LightKind::directional);
    });
}

}  // namespace rakelight::raster::RL_ISA
