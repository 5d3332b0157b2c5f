// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/scene/shapes.h"

#include <cmath>
#include <utility>

#include "engines/raytrace/kernels/trace_types.h"
#include "engines/raytrace/scene/polynomial_roots.h"
#include "math/linear.h"

namespace rakelight::raytrace {
namespace {

using Kind = ExactShape::Kind;

static_assert(int(Kind::sphere) == shape_sphere && int(Kind::cylinder) == shape_cylinder &&
              int(Kind::cone) == shape_cone && int(Kind::torus) == shape_torus && int(Kind::plane) == shape_plane);

/// A ray whose origin is its place nearest to the shape's middle, so that numbers stay small: Haines et al. 2019, "Precision
/// Improvements for Ray/Sphere Intersection". The direction is unit; t = (s + before) * per_length.
struct CenteredRay {
    dvec3 o, d;
    double before, per_length;
};

void add(ShapeHits& hits, double s, std::uint32_t face) {
    if (hits.count < 4) hits.at[std::size_t(hits.count++)] = {s, face};
}

void meet_sphere(const ExactShape& shape, const CenteredRay& ray, ShapeHits& hits) {
    const double squared = shape.radius * shape.radius - dot(ray.o, ray.o);
    if (squared < 0) return;
    const double half = std::sqrt(squared);
    add(hits, -half, face_side), add(hits, half, face_side);
}

/// The disc of a cap, or of a base.
void meet_disc(double y, double radius, std::uint32_t face, const CenteredRay& ray, ShapeHits& hits) {
    if (ray.d.y == 0) return;
    const double s = (y - ray.o.y) / ray.d.y;
    const dvec3 p = ray.o + ray.d * s;
    if (p.x * p.x + p.z * p.z <= radius * radius) add(hits, s, face);
}

void meet_side(const Roots& roots, double height, const CenteredRay& ray, ShapeHits& hits) {
    for (int i = 0; i < roots.count; ++i) {
        const double s = roots.at[std::size_t(i)];
        if (std::abs(ray.o.y + ray.d.y * s) <= height / 2) add(hits, s, face_side);
    }
}

void meet_cylinder(const ExactShape& shape, const CenteredRay& ray, ShapeHits& hits) {
    const dvec3 o = ray.o, d = ray.d;
    const double a = d.x * d.x + d.z * d.z, b = o.x * d.x + o.z * d.z;
    meet_side(quadratic_roots(a, b, o.x * o.x + o.z * o.z - shape.radius * shape.radius), shape.height, ray, hits);
    meet_disc(shape.height / 2, shape.radius, face_top, ray, hits);
    meet_disc(-shape.height / 2, shape.radius, face_bottom, ray, hits);
}

/// x^2 + z^2 = (k (tip - y))^2
void meet_cone(const ExactShape& shape, const CenteredRay& ray, ShapeHits& hits) {
    const dvec3 o = ray.o, d = ray.d;
    const double k = shape.radius / shape.height, w = k * (shape.height / 2 - o.y), g = -k * d.y;
    const double a = d.x * d.x + d.z * d.z - g * g, b = o.x * d.x + o.z * d.z - w * g,
                 c = o.x * o.x + o.z * o.z - w * w;
    if (a != 0)
        meet_side(quadratic_roots(a, b, c), shape.height, ray, hits);
    else if (b != 0)  // along a line of the cone
        meet_side(Roots{{-c / (2 * b)}, 1}, shape.height, ray, hits);
    meet_disc(-shape.height / 2, shape.radius, face_bottom, ray, hits);
}

/// (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2), in units of R + r; o.d = 0.
void meet_torus(const ExactShape& shape, const CenteredRay& ray, ShapeHits& hits) {
    const double unit = shape.radius + shape.tube_radius;
    const dvec3 o = ray.o / unit, d = ray.d;
    const double squared = 1 - dot(o, o);
    if (squared < 0) return;
    const double reach = std::sqrt(squared), ring = shape.radius / unit, tube = shape.tube_radius / unit;
    const double g = dot(o, o) + ring * ring - tube * tube, four = 4 * ring * ring;
    const std::array<double, 5> c = {g * g - four * (o.x * o.x + o.z * o.z), -2 * four * (o.x * d.x + o.z * d.z),
                                     2 * g - four * (d.x * d.x + d.z * d.z), 0, 1};
    const Roots roots = quartic_roots(c, -reach * 1.001, reach * 1.001);
    for (int i = 0; i < roots.count; ++i) add(hits, roots.at[std::size_t(i)] * unit, face_side);
}

void meet_plane(const ExactShape& shape, const CenteredRay& ray, ShapeHits& hits) {
    if (ray.d.y == 0) return;
    const double s = -ray.o.y / ray.d.y;
    const dvec3 p = ray.o + ray.d * s;
    if (std::abs(p.x) <= shape.width / 2 && std::abs(p.z) <= shape.depth / 2) add(hits, s, face_side);
}

}  // namespace

ShapeHits meet(const ExactShape& shape, dvec3 origin, dvec3 direction) {
    ShapeHits hits;
    const double length = std::sqrt(dot(direction, direction));
    if (!(length > 0) || !std::isfinite(length)) return hits;
    const dvec3 d = direction / length;
    const double before = -dot(origin, d);
    const CenteredRay ray{origin + d * before, d, before, 1 / length};
    switch (shape.kind) {
        case Kind::sphere:
            meet_sphere(shape, ray, hits);
            break;
        case Kind::cylinder:
            meet_cylinder(shape, ray, hits);
            break;
        case Kind::cone:
            meet_cone(shape, ray, hits);
            break;
        case Kind::torus:
            meet_torus(shape, ray, hits);
            break;
        case Kind::plane:
            meet_plane(shape, ray, hits);
            break;
    }
    for (int i = 0; i < hits.count; ++i) {
        double& t = hits.at[std::size_t(i)].t;
        t = (t + ray.before) * ray.per_length;
    }
    for (std::size_t i = 1; i < std::size_t(hits.count); ++i)
        for (std::size_t k = i; k > 0 && hits.at[k].t < hits.at[k - 1].t; --k) std::swap(hits.at[k], hits.at[k - 1]);
    return hits;
}

dvec3 outward(const ExactShape& shape, std::uint32_t face, dvec3 p) {
    if (shape.kind == Kind::plane) return {0, 1, 0};
    if (shape.kind == Kind::sphere) return p;
    if (face != face_side) return {0, face == face_top ? 1.0 : -1.0, 0};
    const double rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (shape.kind == Kind::torus) return rho > 0 ? p - dvec3{p.x, 0, p.z} * (shape.radius / rho) : dvec3{0, p.y, 0};
    const double up = shape.kind == Kind::cone ? rho * shape.radius / shape.height : 0;
    return {p.x, up, p.z};
}

Bounds bounds_of(const ExactShape& s) {
    const bool is_torus = s.kind == Kind::torus, is_plane = s.kind == Kind::plane;
    const double around = s.radius + (is_torus ? s.tube_radius : 0);
    const dvec3 half = {is_plane ? s.width / 2 : around,
                        is_plane                 ? 0
                        : s.kind == Kind::sphere ? s.radius
                        : is_torus               ? s.tube_radius
                                                 : s.height / 2,
                        is_plane ? s.depth / 2 : around};
    return {-half, half};
}

}  // namespace rakelight::raytrace
