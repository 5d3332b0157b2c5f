// SPDX-License-Identifier: Apache-2.0
// Where rays hit triangles, as the points that are shaded: what cpu_shading/kernels/shade_points.h calls a Source. Which
// triangle it is was found before; place, weights of the corners and differentials are made here, the same whoever found it.
// Per instruction set.
#pragma once
#include "engines/raytrace/kernels/shape_points.h"

namespace rakelight::raytrace::RL_ISA {

/// Three numbers of each lane's ray.
inline vec3 ray_vector(const RayView& rays, int32_t plane, integer ray) {
    const auto at = [&](int32_t c) { return gather(rays.planes + int64_t(plane + c) * rays.capacity, ray); };
    return vec3(at(0), at(1), at(2));
}

inline vec3 to_eye(const HitJob& job, vec3 p) { return rows_of(job.to_eye, p); }

inline constexpr float ray_offset = 4e-7f;  ///< by which rays begin and end off surfaces: of the largest coordinate

inline real largest_component(vec3 v) { return max(max(abs(v.x), abs(v.y)), abs(v.z)); }

/// One vector of hits.
struct Hits {
    cpu::Corners corners;
    integer ray;
    vec3 corner[3];             ///< about the eye
    vec3 origin, along;         ///< of the ray; the direction as it comes
    vec3 position, normal;      ///< the triangle's by the order of its corners, of any length
    vec3 change_b1, change_b2;  ///< [1/m] of the weights of corners 1 and 2 over the plane
    real b1, b2, t, facing;
    real shows_front;  ///< 1, or -1: the ray hits the back
    real per_cosine;   ///< 1 / dot(normal, along)

    ShapePoint shape;  ///< where the job has one

    void find(const HitJob& job, int32_t first) {
        ray = load_i(job.ray + first);
        origin = ray_vector(job.rays, ray_o, ray);
        along = ray_vector(job.rays, ray_d, ray);
        if (job.shape.kind != shape_none) return meet_shape(job, first);
        corners.find(job.mesh, load_i(job.triangle + first));
        for (int32_t k = 0; k < 3; ++k) corner[k] = to_eye(job, cpu::load_corner3(job.mesh.positions, corners, k));
        meet(job);
        set_weights();
    }

    /// Where the differentials lead on the plane (Igehy 1999, eq. 10). @param axis  0: x, 3: y
    vec3 change_of_position(const HitJob& job, int32_t axis) const {
        const vec3 q = ray_vector(job.rays, ray_o_dx + axis, ray) + ray_vector(job.rays, ray_d_dx + axis, ray) * t;
        return q - along * (dot(normal, q) * per_cosine);
    }
    vec3 interpolate(vec3 a, vec3 b, vec3 c) const { return a + (b - a) * b1 + (c - a) * b2; }
    /// [m] The distance off the surface at which rays begin. It is some rounding errors of the surface's place and of
    /// its plane, as the ray's and Embree's coordinates have them. For splats it is their radius. @param n  unit normal
    /// of the plane
    real offset(const HitJob& job, vec3 n) const {
        const vec3 size(abs(n.x), abs(n.y), abs(n.z));
        const auto off_plane = [&](vec3 v) { return dot(size, vec3(abs(v.x), abs(v.y), abs(v.z))); };
        const real plane = max(max(off_plane(corner[0]), off_plane(corner[1])), off_plane(corner[2]));
        const real place = max(largest_component(position), largest_component(position + splat(job.to_rays)));
        const real rounding = max(max(place, plane), largest_component(origin)) * real(ray_offset);
        return job.is_of_splats != 0 ? rounding + length(corner[1] - corner[0]) : rounding;
    }
    /// How the normal turns when the place moves so on the surface. @param unit  the interpolated normal, unit
    vec3 change_of_normal(const HitJob& job, vec3 unit, vec3 move) const;

private:
    /// Of the shape by its formula; the normal is the one that its triangles' corners would give.
    void meet_shape(const HitJob& job, int32_t first) {
        t = load(job.t + first);
        position = origin + along * t;
        shape = shape_point(job.shape, load_i(job.triangle + first), rows_of(job.shape.to_object, position));
        normal = safe_normalize(cpu::transformed(job.mesh.to_normal, shape.n)) * real(job.mesh.mirror);
        set_side(job);
        b1 = b2 = real(0.0f);
        for (int32_t k = 0; k < 3; ++k) corner[k] = position;
    }

    void set_side(const HitJob& job) {
        const real cosine = dot(normal, along);
        const mask is_against = cosine < real(0.0f), is_back = job.front_is_negative != 0 ? !is_against : is_against;
        per_cosine = reciprocal(select(cosine == real(0.0f), real(1.0f), cosine));
        shows_front = select(is_back, real(-1.0f), real(1.0f));
        facing = job.mesh.turned != 0 ? -shows_front : shows_front;
    }
    /// The ray and the triangle's plane. The normal is of edges at most 1 long, so that nothing leaves the range of floats.
    void meet(const HitJob& job) {
        const vec3 e1 = corner[1] - corner[0], e2 = corner[2] - corner[0];
        const real scale = reciprocal(max(max(largest_component(e1), largest_component(e2)), real(1e-30f)));
        const vec3 a = e1 * scale, b = e2 * scale;
        normal = cross(a, b);
        const real cosine = dot(normal, along);
        const mask is_against = cosine < real(0.0f), is_back = job.front_is_negative != 0 ? !is_against : is_against;
        per_cosine = reciprocal(select(cosine == real(0.0f), real(1.0f), cosine));
        t = dot(normal, corner[0] - origin) * per_cosine;
        position = origin + along * t;
        facing = cpu::facing_of(job.mesh, corners, is_back);
        shows_front = select(is_back, real(-1.0f), real(1.0f));
        const real square = dot(normal, normal);
        const real per_square = scale * reciprocal(select(square > real(0.0f), square, real(1.0f)));
        change_b1 = cross(b, normal) * per_square;
        change_b2 = cross(normal, a) * per_square;
    }

    /// By rounding a hit may lie outside of its triangle, and that would throw its attributes far out: they stay inside.
    void set_weights() {
        const vec3 in_plane = position - corner[0];
        b1 = clamp(dot(in_plane, change_b1), real(0.0f), real(1.0f));
        b2 = clamp(dot(in_plane, change_b2), real(0.0f), real(1.0f) - b1);
    }
};

/// A vector's triangles, for lighting in the tangent space of their vertices.
struct HitTriangles {
    const HitJob& job;
    const Hits& hits;

    cpu::CornerFrames corners() const {
        cpu::CornerFrames out;
        if (job.shape.kind != shape_none) {
            for (int32_t k = 0; k < 3; ++k) {
                out.position[k] = hits.position;
                out.normal[k] = shape_normal(job, hits.shape);
                out.tangent[k] = shape_tangent(job, hits.shape);
                out.bitangent[k] = vec3(real(0.0f));  // the frame's own
            }
            out.handedness = shape_handedness(job);
            return out;
        }
        for (int32_t k = 0; k < 3; ++k) out.position[k] = hits.corner[k];
        cpu::load_normals(job.mesh, hits.corners, out.normal);
        out.handedness = cpu::load_tangents(job.mesh, hits.corners, out.tangent);
        cpu::load_bitangents(job.mesh, hits.corners, out.bitangent);
        return out;
    }
    vec3 from_viewer(vec3 position) const { return position - hits.origin; }
    vec3 interpolate(vec3 a, vec3 b, vec3 c) const { return hits.interpolate(a, b, c); }
};

/// `most` vectors of hits from `first` on.
template <int32_t most>
struct HitSource {
    const HitJob& job;
    int32_t first;
    Hits hits[most];

    HitSource(const HitJob& from, int32_t first_hit) : job(from), first(first_hit) {}

    void place(int32_t k, ShadingPoint& p) {
        hits[k].find(job, first + k * lanes);
        p.position = hits[k].position;
    }
    void texcoords(int32_t k, int32_t set, TexCoords& to) const {
        const Hits& h = hits[k];
        if (job.shape.kind != shape_none) return shape_texcoords(h, set, to);
        const float* const base = job.mesh.texcoords[set];
        if (base == nullptr) {
            to = {vec2(real(0.0f)), vec2(real(0.0f)), vec2(real(0.0f))};
            return;
        }
        real uv[3][2];
        for (int32_t c = 0; c < 3; ++c) cpu::load_corner<2>(base, h.corners, c, uv[c]);
        const vec2 at(uv[0][0], uv[0][1]);
        const vec2 to_1(uv[1][0] - uv[0][0], uv[1][1] - uv[0][1]), to_2(uv[2][0] - uv[0][0], uv[2][1] - uv[0][1]);
        const auto change = [&](vec3 move) { return to_1 * dot(move, h.change_b1) + to_2 * dot(move, h.change_b2); };
        to.uv = at + to_1 * h.b1 + to_2 * h.b2;
        to.dx = change(h.change_of_position(job, 0));
        to.dy = change(h.change_of_position(job, ray_o_dy - ray_o_dx));
    }
    vec4 color(int32_t k) const {
        if (job.mesh.colors == nullptr || job.shape.kind != shape_none) return vec4(real(1.0f));
        real at[3][4];
        for (int32_t c = 0; c < 3; ++c) cpu::load_corner<4>(job.mesh.colors, hits[k].corners, c, at[c]);
        const auto mixed = [&](int32_t i) {
            return at[0][i] + (at[1][i] - at[0][i]) * hits[k].b1 + (at[2][i] - at[0][i]) * hits[k].b2;
        };
        return vec4(mixed(0), mixed(1), mixed(2), mixed(3));
    }
    SignedVector normal(int32_t k) const {
        if (job.lit_at == lit_at_faces) return {face_normal(hits[k]), real(1.0f)};
        if (job.shape.kind != shape_none) return {shape_normal(job, hits[k].shape), hits[k].facing};
        vec3 at[3];
        cpu::load_normals(job.mesh, hits[k].corners, at);
        return {hits[k].interpolate(at[0], at[1], at[2]), hits[k].facing};
    }
    SignedVector tangent(int32_t k) const {
        if (job.shape.kind != shape_none) return {shape_tangent(job, hits[k].shape), shape_handedness(job)};
        vec3 at[3];
        const real handedness = cpu::load_tangents(job.mesh, hits[k].corners, at);
        return {hits[k].interpolate(at[0], at[1], at[2]), handedness};
    }
    real openness(int32_t k) const { return load(job.openness + first + k * lanes); }
    HitTriangles of(int32_t k) const { return {job, hits[k]}; }
    vec3 weights(int32_t k) const { return vec3(real(1.0f) - hits[k].b1 - hits[k].b2, hits[k].b1, hits[k].b2); }

    bool is_lit_at_corners() const { return job.lit_at != lit_at_points; }
    lit::LightTerms corner_light(int32_t k) const;

    void shape_texcoords(const Hits& h, int32_t set, TexCoords& to) const {
        const bool has_any = set == 0 && job.mesh.texcoords[0] != nullptr;
        const auto change = [&](int32_t axis) {
            const vec3 move = turned_by(job.shape.to_object, h.change_of_position(job, axis));
            return vec2(dot(move, h.shape.du) * h.shape.per_u, dot(move, h.shape.dv) * h.shape.per_v);
        };
        to.uv = has_any ? h.shape.uv : vec2(real(0.0f));
        to.dx = has_any ? change(0) : vec2(real(0.0f));
        to.dy = has_any ? change(ray_o_dy - ray_o_dx) : vec2(real(0.0f));
    }
    /// Unit, towards the viewer.
    static vec3 face_normal(const Hits& h) {
        const vec3 n = safe_normalize(h.normal);
        return select(dot(n, h.along) > real(0.0f), -n, n);
    }
};

/// Flat shading: at the middle of the face. Gouraud shading: at the corners, interpolated.
template <int32_t most>
lit::LightTerms HitSource<most>::corner_light(int32_t k) const {
    const cpu::Job<cpu::EveryMaterial> material{job};
    const Hits& h = hits[k];
    const auto light_at = [&](vec3 position, vec3 normal) {
        return cpu::light_of_point(material, job.roughness, position, position - h.origin, normal);
    };
    if (job.lit_at == lit_at_faces)
        return light_at((h.corner[0] + h.corner[1] + h.corner[2]) * real(1.0f / 3), face_normal(h));
    if (job.shape.kind != shape_none) return light_at(h.position, shape_normal(job, h.shape) * h.facing);
    vec3 normal[3];
    cpu::load_normals(job.mesh, h.corners, normal);
    lit::LightTerms at[3];
    for (int32_t c = 0; c < 3; ++c) at[c] = light_at(h.corner[c], normal[c] * h.facing);
    return {h.interpolate(at[0].ambient, at[1].ambient, at[2].ambient),
            h.interpolate(at[0].diffuse, at[1].diffuse, at[2].diffuse),
            h.interpolate(at[0].specular, at[1].specular, at[2].specular)};
}

inline vec3 Hits::change_of_normal(const HitJob& job, vec3 unit, vec3 move) const {
    if (job.lit_at == lit_at_faces) return vec3(real(0.0f));
    if (job.shape.kind != shape_none) {
        const ShapePoint& s = shape;
        const vec3 m = turned_by(job.shape.to_object, move);
        const vec3 turn = s.du * (dot(m, s.du) * s.bend_u) + s.dv * (dot(m, s.dv) * s.bend_v);
        const vec3 whole = cpu::transformed(job.mesh.to_normal, s.n), part = cpu::transformed(job.mesh.to_normal, turn);
        return change_of_unit(unit, whole, part) * facing;
    }
    vec3 at[3];
    cpu::load_normals(job.mesh, corners, at);
    const vec3 part = (at[1] - at[0]) * dot(move, change_b1) + (at[2] - at[0]) * dot(move, change_b2);
    return change_of_unit(unit, interpolate(at[0], at[1], at[2]), part) * facing;
}

}  // namespace rakelight::raytrace::RL_ISA
