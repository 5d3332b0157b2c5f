// SPDX-License-Identifier: Apache-2.0
// Surfaces known by formula, cut in two whose borders do not share vertices.
#pragma once
#include <rakelight/geometry/matching_borders.h>

#include <random>

#include "unit/geometry/shapes.h"

namespace rakelight::test {

/// A closed or open surface of revolution-like parameters, with its outward normal.
struct Surface {
    std::function<dvec3(double u, double v)> point, normal;  ///< u goes round once in 0..1
    bool closes = true;                                      ///< in u
};

inline dvec3 numeric_normal(const std::function<dvec3(double, double)>& point, double u, double v) {
    const double h = 1e-5;
    const dvec3 du = point(u + h, v) - point(u - h, v), dv = point(u, v + h) - point(u, v - h);
    return normalize_or(cross(du, dv), dvec3{0, 0, 1});
}

/// A sphere of radius 1 with bumps; v in 0..1 from pole to pole, cut at 0.5.
inline Surface bumpy_sphere(double bumps = 0.08) {
    Surface s;
    s.point = [bumps](double u, double v) {
        const double a = 2 * pi * u, b = pi * v, r = 1 + bumps * std::sin(3 * a) * std::sin(4 * b + 0.7);
        return dvec3{r * std::sin(b) * std::cos(a), -r * std::cos(b), -r * std::sin(b) * std::sin(a)};
    };
    s.normal = [p = s.point](double u, double v) { return numeric_normal(p, u, v); };
    return s;
}
inline Surface torus() {
    Surface s;
    s.point = [](double u, double v) {
        const double a = 2 * pi * u, b = 2 * pi * (v + 0.1), ring = 2 + 0.7 * std::cos(b);
        return dvec3{ring * std::cos(a), 0.7 * std::sin(b), -ring * std::sin(a)};
    };
    s.normal = [p = s.point](double u, double v) { return numeric_normal(p, u, v); };
    return s;
}
inline Surface cylinder() {
    Surface s;
    s.point = [](double u, double v) { return dvec3{std::cos(2 * pi * u), 2 * v, -std::sin(2 * pi * u)}; };
    s.normal = [p = s.point](double u, double v) { return numeric_normal(p, u, v); };
    return s;
}

/// How two halves meet at v = 0.5.
struct Cut {
    std::uint32_t columns = 24, rows = 6;  ///< of the lower half
    std::uint32_t times = 1;               ///< the upper half is finer by
    double phase = 0;                      ///< [columns of the upper half] turned against the lower one
    double gap = 0;                        ///< [edges of the lower half] along the surface
    double noise = 0;                      ///< [edges of the lower half] at border vertices, in all directions
};

/// Two halves, of which the second is finer; `truth` has the surface's own normals of their vertices.
struct CutSurface {
    std::vector<Shape> halves;
    std::vector<std::vector<dvec3>> truth;
    double edge = 0;  ///< [m] the mean border edge of the lower half
};

inline CutSurface cut_surface(const Surface& surface, const Cut& cut) {
    CutSurface out;
    std::mt19937 random(7);
    for (std::uint32_t c = 0; c < cut.columns; ++c)
        out.edge +=
            length(surface.point(double(c + 1) / cut.columns, 0.5) - surface.point(double(c) / cut.columns, 0.5)) /
            cut.columns;
    const double step = 1e-4, v_per_m = step / length(surface.point(0, 0.5 + step) - surface.point(0, 0.5));
    for (std::uint32_t half = 0; half < 2; ++half) {
        const std::uint32_t times = half == 0 ? 1 : cut.times, columns = cut.columns * times, rows = cut.rows * times;
        std::vector<dvec3> truth;
        Shape shape = make_grid(columns, rows, [&](double u, double v) {
            const bool is_border = half == 0 ? v >= 1 : v <= 0;
            if (u >= 1) u = 0;  // bit-equal where it closes
            const double at = half == 0 ? 0.05 + 0.45 * v : 0.5 + cut.gap * out.edge * v_per_m + 0.4 * v,
                         turned = u + (half == 1 ? cut.phase / columns : 0);
            dvec3 p = surface.point(turned, at);
            truth.push_back(surface.normal(turned, at));
            if (is_border && cut.noise > 0) {
                std::mt19937 local(std::uint32_t(u * columns + 0.5) * 2 + half);
                const auto offset = [&] { return (double(local()) / 4294967295.0 - 0.5) * 2 * cut.noise * out.edge; };
                p += dvec3{offset(), offset(), offset()};
            }
            return cast<float>(p);
        });
        shape.object = half;
        out.halves.push_back(std::move(shape));
        out.truth.push_back(std::move(truth));
    }
    return out;
}

/// With normals and tangents by compute_attributes(), vertices that were split appended.
inline Shape with_attributes(Shape shape, const MeshAttributes& made) {
    for (const std::uint32_t v : made.source_vertex) {
        shape.positions.push_back(shape.positions[v]);
        if (!shape.texcoords.empty()) shape.texcoords.push_back(shape.texcoords[v]);
    }
    if (!made.indices.empty()) shape.indices = made.indices;
    shape.normals = made.normals;
    return shape;
}

}  // namespace rakelight::test
