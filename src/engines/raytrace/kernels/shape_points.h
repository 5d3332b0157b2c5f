// SPDX-License-Identifier: Apache-2.0
// Points of surfaces given by their formulas: normal, texture coordinates and how both change, as the triangles of
// prepare/primitives.h have them at their vertices. Per instruction set.
#pragma once
#include "cpu_shading/kernels/corners.h"
#include "cpu_shading/kernels/light_points.h"
#include "engines/raytrace/kernels/trace_types.h"

namespace rakelight::raytrace::RL_ISA {
RL_USE_WIDE;
namespace cpu = rakelight::cpu_shading::RL_ISA;
namespace lit = rakelight::lighting::RL_ISA;
using cpu::ShadingPoint, cpu::SignedVector, cpu::TexCoords, cpu::splat;

inline vec3 rows_of(const float (&m)[3][4], vec3 p) {
    const auto row = [&](int r) {
        return real(m[r][0]) * p.x + real(m[r][1]) * p.y + real(m[r][2]) * p.z + real(m[r][3]);
    };
    return vec3(row(0), row(1), row(2));
}
/// The same of a direction.
inline vec3 turned_by(const float (&m)[3][4], vec3 v) {
    const auto row = [&](int r) { return real(m[r][0]) * v.x + real(m[r][1]) * v.y + real(m[r][2]) * v.z; };
    return vec3(row(0), row(1), row(2));
}

/// The change of a unit vector when `whole`, whose direction it has, changes by `part`.
inline vec3 change_of_unit(vec3 unit, vec3 whole, vec3 part) {
    const real square = max(dot(whole, whole), real(1e-30f));
    return (part - unit * dot(unit, part)) * reciprocal(sqrt(square));
}

/// A point of a shape, in its own space. Of caps and planes u and v run along X and Z.
struct ShapePoint {
    vec3 n;               ///< unit, outward
    vec2 uv;              ///< v down
    vec3 du, dv;          ///< unit: where u and v grow
    real per_u, per_v;    ///< [1/m] how fast
    real bend_u, bend_v;  ///< [1/m] how fast the normal turns along them
};

/// On the side of a body of revolution. @param along  of its profile, (distance from the axis, height), unit, where v grows
inline ShapePoint turned_point(vec3 p, vec2 along, vec2 normal, real v, real per_v, real bend_v) {
    const real rho = sqrt(p.x * p.x + p.z * p.z);
    const real per_rho = reciprocal(max(rho, real(1e-20f)));
    const mask is_on_axis = rho <= real(1e-20f);
    const real x = select(is_on_axis, real(0.0f), p.x * per_rho), z = select(is_on_axis, real(1.0f), p.z * per_rho);
    ShapePoint s;
    s.n = vec3(normal.x * x, normal.y, normal.x * z);
    s.du = vec3(z, real(0.0f), -x);
    s.dv = vec3(along.x * x, along.y, along.x * z);
    s.uv = vec2(real(0.5f) + lit::angle_of(x, z) * real(0.159154943f), v);
    s.per_u = per_rho * real(0.159154943f);
    s.per_v = per_v;
    s.bend_u = normal.x * per_rho;
    s.bend_v = bend_v;
    return s;
}

/// On a cap, or on the plane: u along +X. @param down  -1: v grows against Z
inline ShapePoint flat_point(vec3 p, real up, real down, real per_u, real per_v) {
    ShapePoint s;
    const real zero(0.0f);
    s.n = vec3(zero, up, zero);
    s.du = vec3(real(1.0f), zero, zero);
    s.dv = vec3(zero, zero, down);
    s.uv = vec2(real(0.5f) + p.x * per_u, real(0.5f) + p.z * down * per_v);
    s.per_u = per_u, s.per_v = per_v;
    s.bend_u = s.bend_v = zero;
    return s;
}

inline ShapePoint select_point(mask m, const ShapePoint& a, const ShapePoint& b) {
    return {select(m, a.n, b.n),           select(m, a.uv, b.uv),        select(m, a.du, b.du),
            select(m, a.dv, b.dv),         select(m, a.per_u, b.per_u),  select(m, a.per_v, b.per_v),
            select(m, a.bend_u, b.bend_u), select(m, a.bend_v, b.bend_v)};
}

inline ShapePoint sphere_point(const ShapeView& s, vec3 p) {
    const vec3 n = safe_normalize(p);
    const real rho = sqrt(n.x * n.x + n.z * n.z), per_radius(1.0f / s.radius);
    return turned_point(p, vec2(n.y, -rho), vec2(rho, n.y), lit::angle_of(rho, n.y) * real(0.318309886f),
                        real(0.318309886f / s.radius), per_radius);
}

inline ShapePoint torus_point(const ShapeView& s, vec3 p) {
    const real out = sqrt(p.x * p.x + p.z * p.z) - real(s.radius);
    const real scale = reciprocal(max(sqrt(out * out + p.y * p.y), real(1e-20f)));
    const vec2 n(out * scale, p.y * scale);
    // v: 0 on the inside, then over the top
    const real turn = lit::angle_of(n.y, -n.x) * real(0.159154943f);
    return turned_point(p, vec2(n.y, -n.x), n, select(turn < real(0.0f), turn + real(1.0f), turn),
                        real(0.159154943f / s.tube_radius), real(1.0f / s.tube_radius));
}

inline ShapePoint side_point(const ShapeView& s, vec3 p) {
    const real v = real(0.5f) - p.y * real(1.0f / s.height);
    if (s.kind == shape_cylinder)
        return turned_point(p, vec2(real(0.0f), real(-1.0f)), vec2(real(1.0f), real(0.0f)), v, real(1.0f / s.height),
                            real(0.0f));
    const float slant = __builtin_sqrtf(s.radius * s.radius + s.height * s.height);
    const real out(s.radius / slant), down(s.height / slant);
    return turned_point(p, vec2(out, -down), vec2(down, out), v, real(1.0f / slant), real(0.0f));
}

/// @param face  ShapeFaceNumber
inline ShapePoint shape_point(const ShapeView& s, integer face, vec3 p) {
    if (s.kind == shape_sphere) return sphere_point(s, p);
    if (s.kind == shape_torus) return torus_point(s, p);
    const real one(1.0f);
    if (s.kind == shape_plane) return flat_point(p, one, one, real(1.0f / s.width), real(1.0f / s.depth));
    const real up = select(face == integer(face_top), one, -one), per_radius(0.5f / s.radius);
    return select_point(face == integer(face_side), side_point(s, p), flat_point(p, up, up, per_radius, per_radius));
}

/// In world axes, not unit.
inline vec3 shape_normal(const HitJob& job, const ShapePoint& s) { return cpu::transformed(job.mesh.to_normal, s.n); }
/// 0 where the mesh has none, as of triangles.
inline vec3 shape_tangent(const HitJob& job, const ShapePoint& s) {
    if (job.mesh.tangents == nullptr) return vec3(real(0.0f));
    const float along_u = job.shape.tangent_uv[0], along_v = job.shape.tangent_uv[1];
    vec3 t = s.du * real(along_u);
    if (along_v != 0.0f) t = t * s.per_v + s.dv * (s.per_u * real(along_v));  // dP/du = du / per_u
    return safe_normalize_or(cpu::transformed(job.mesh.linear, t), vec3(real(0.0f)));
}

/// All vertices of the shape's triangles have the same.
inline real shape_handedness(const HitJob& job) {
    return real(job.mesh.tangents != nullptr ? job.mesh.tangents[3] * job.mesh.mirror : job.mesh.mirror);
}

}  // namespace rakelight::raytrace::RL_ISA
