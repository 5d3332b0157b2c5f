// SPDX-License-Identifier: Apache-2.0
// Meshes for the tests of normals and tangents: closed forms, ways of cutting them into objects, and small conveniences.
#pragma once
#include <rakelight/geometry/attributes.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include "math/linear.h"

namespace rakelight::test {

/// A mesh that owns its arrays.
struct Shape {
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    std::vector<vec2> texcoords;
    std::vector<vec3> normals;
    std::vector<std::uint32_t> smoothing;
    std::vector<vec3> hints;
    GroupKind kind = GroupKind::none;
    std::uint32_t object = 0;
    dmat4 to_world;

    AttributeMesh view() const {
        AttributeMesh m;
        m.object = object;
        m.positions = positions;
        m.indices = indices;
        m.texcoords = texcoords;
        m.normals = normals;
        m.smoothing = smoothing;
        m.group_kind = kind;
        m.smoothing_hint = hints;
        m.to_world = to_world;
        return m;
    }
};

inline std::vector<AttributeMesh> views(const std::vector<Shape>& shapes) {
    std::vector<AttributeMesh> all;
    for (const Shape& s : shapes) all.push_back(s.view());
    return all;
}

/// Options of the published sum: uniform weights, everything at a position joined.
inline AttributeOptions published() {
    AttributeOptions options;
    options.weight = CornerWeight::uniform;
    options.crease_angle_rad = pi;
    return options;
}

inline std::vector<MeshAttributes> compute(const std::vector<Shape>& shapes, const AttributeOptions& options,
                                           int threads = 2) {
    Context context({.threads = threads});
    return compute_attributes(views(shapes), options, context);
}

/// The output vertex of a corner.
inline std::uint32_t output_vertex(const Shape& shape, const MeshAttributes& out, std::size_t corner) {
    return out.indices.empty() ? shape.indices[corner] : out.indices[corner];
}
inline vec3 corner_normal(const Shape& shape, const MeshAttributes& out, std::size_t corner) {
    return out.normals[output_vertex(shape, out, corner)];
}

/// A grid of (columns + 1) x (rows + 1) vertices over point(u, v), 0 <= u, v <= 1. Vertices that wrap round stand twice, with
/// bit-equal positions if point() gives these; triangles are counter-clockwise if dP/du x dP/dv points outwards.
inline Shape make_grid(std::uint32_t columns, std::uint32_t rows, const std::function<vec3(double, double)>& point) {
    Shape s;
    for (std::uint32_t r = 0; r <= rows; ++r)
        for (std::uint32_t c = 0; c <= columns; ++c) {
            s.positions.push_back(point(double(c) / columns, double(r) / rows));
            s.texcoords.push_back({float(c) / float(columns), float(r) / float(rows)});
        }
    const std::uint32_t w = columns + 1;
    for (std::uint32_t r = 0; r < rows; ++r)
        for (std::uint32_t c = 0; c < columns; ++c) {
            const std::uint32_t a = r * w + c, b = a + 1, d = a + w, e = d + 1;
            s.indices.insert(s.indices.end(), {a, b, e, a, e, d});
        }
    return s;
}

inline double wrapped(double u) { return u >= 1 ? 0 : 2 * pi * u; }  // bit-equal where the surface closes

inline Shape make_sphere(std::uint32_t columns, std::uint32_t rows) {
    return make_grid(columns, rows, [](double u, double v) {
        const double a = wrapped(u), b = pi * v;
        const double ring = v <= 0 || v >= 1 ? 0 : std::sin(b);
        return vec3{float(ring * std::cos(a)), float(-std::cos(b)), float(-ring * std::sin(a))};
    });
}

inline Shape make_cylinder(std::uint32_t columns, std::uint32_t rows) {
    return make_grid(columns, rows, [](double u, double v) {
        const double a = wrapped(u);
        return vec3{float(std::cos(a)), float(v), float(-std::sin(a))};
    });
}

inline Shape make_torus(std::uint32_t columns, std::uint32_t rows) {
    return make_grid(columns, rows, [](double u, double v) {
        const double a = wrapped(u), b = wrapped(v), ring = 2 + 0.5 * std::cos(b);
        return vec3{float(ring * std::cos(a)), float(0.5 * std::sin(b)), float(-ring * std::sin(a))};
    });
}

/// The unit cube with 8 shared vertices, 12 triangles.
inline Shape make_cube() {
    Shape s;
    for (int i = 0; i < 8; ++i) s.positions.push_back({float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1)});
    s.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    return s;
}

/// Two quads that share the edge from (0,0,0) to (0,0,1), bent by an angle: normals (0,1,0) and turned about z.
inline std::vector<Shape> make_hinge(double bend_rad) {
    Shape a, b;
    a.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
    a.indices = {0, 1, 2, 0, 2, 3};
    const float x = float(-std::cos(bend_rad)), y = float(-std::sin(bend_rad));
    b.positions = {{0, 0, 0}, {0, 0, 1}, {x, y, 1}, {x, y, 0}};
    b.indices = {0, 2, 1, 0, 3, 2};
    b.object = 1;
    return {a, b};
}

/// Triangle t goes to part(t); every part gets its own vertices, only those it uses, and its own object number.
inline std::vector<Shape> cut(const Shape& whole, std::uint32_t parts,
                              const std::function<std::uint32_t(std::size_t)>& part) {
    std::vector<Shape> out(parts);
    std::vector<std::map<std::uint32_t, std::uint32_t>> number(parts);
    for (std::uint32_t p = 0; p < parts; ++p) {
        out[p].object = p;
        out[p].kind = whole.kind;
        out[p].to_world = whole.to_world;
    }
    for (std::size_t t = 0; t < whole.indices.size() / 3; ++t) {
        const std::uint32_t p = part(t);
        if (!whole.smoothing.empty()) out[p].smoothing.push_back(whole.smoothing[t]);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = whole.indices[3 * t + k];
            const auto [at, is_new] = number[p].try_emplace(v, std::uint32_t(out[p].positions.size()));
            if (is_new) {
                out[p].positions.push_back(whole.positions[v]);
                if (!whole.texcoords.empty()) out[p].texcoords.push_back(whole.texcoords[v]);
            }
            out[p].indices.push_back(at->second);
        }
    }
    return out;
}

inline dvec3 centroid(const Shape& s, std::size_t t) {
    dvec3 sum;
    for (std::size_t k = 0; k < 3; ++k) sum += cast<double>(s.positions[s.indices[3 * t + k]]);
    return sum / 3.0;
}

/// Cross product of a triangle's edges; exactly 0 for zero area.
inline dvec3 edge_product(const Shape& s, std::size_t t) {
    const auto at = [&](std::size_t k) { return cast<double>(s.positions[s.indices[3 * t + k]]); };
    return cross(at(1) - at(0), at(2) - at(0));
}

/// By slabs across x.
inline std::vector<Shape> cut_by_planes(const Shape& whole, std::uint32_t parts) {
    double low = 1e30, high = -1e30;
    for (const vec3 p : whole.positions) {
        low = std::fmin(low, p.x);
        high = std::fmax(high, p.x);
    }
    return cut(whole, parts, [&](std::size_t t) {
        return std::min(parts - 1, std::uint32_t((centroid(whole, t).x - low) / (high - low) * parts));
    });
}

inline std::vector<Shape> cut_at_random(const Shape& whole, std::uint32_t parts, std::uint32_t seed) {
    std::mt19937 random(seed);
    return cut(whole, parts, [&](std::size_t) { return random() % parts; });
}

/// A rotation by three quarter turns of a random kind, scale and shift, all exact in binary; or any affine matrix.
inline dmat4 random_affine(std::mt19937& random, bool mirrored) {
    std::uniform_real_distribution<double> value(-1, 1);
    dmat4 m;
    do {
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t r = 0; r < 3; ++r) m[c][r] = value(random);
    } while (std::fabs(determinant(upper_left(m))) < 0.1 || (determinant(upper_left(m)) < 0) != mirrored);
    return m;
}

/// [rad] between two unit vectors.
inline double angle_between(dvec3 a, dvec3 b) { return std::atan2(length(cross(a, b)), dot(a, b)); }
inline double angle_between(vec3 a, vec3 b) { return angle_between(cast<double>(a), cast<double>(b)); }

/// Largest difference of a component of normals, tangents and bitangents; infinite if the topologies differ.
inline double largest_difference(const std::vector<MeshAttributes>& a, const std::vector<MeshAttributes>& b) {
    constexpr double other = std::numeric_limits<double>::infinity();
    if (a.size() != b.size()) return other;
    double most = 0;
    const auto add = [&most](const auto& x, const auto& y) {
        if (x.size() != y.size()) most = other;
        for (std::size_t v = 0; v < std::min(x.size(), y.size()); ++v)
            for (std::size_t i = 0; i < sizeof(x[v]) / sizeof(float); ++i)
                most = std::max(most, std::fabs(double(x[v][i]) - double(y[v][i])));
    };
    for (std::size_t m = 0; m < a.size(); ++m) {
        const MeshAttributes &x = a[m], &y = b[m];
        if (x.indices != y.indices || x.source_vertex != y.source_vertex || x.degenerate_faces != y.degenerate_faces ||
            x.isolated_vertices != y.isolated_vertices)
            return other;
        add(x.normals, y.normals), add(x.tangents, y.tangents), add(x.bitangents, y.bitangents);
    }
    return most;
}
/// What rounding of float makes of it.
constexpr double float_rounding = 5e-6;

}  // namespace rakelight::test
