// SPDX-License-Identifier: Apache-2.0
// Surfaces P(u, v), u and v from 0 to 1, v down, seen from outside with u to the right. Normals by central differences.
#include "tools/bench/bench_shapes.h"

#include <algorithm>
#include <cmath>

#include "math/functions.h"
#include "math/linear.h"

namespace rakelight {
namespace {

dvec3 on_sphere(double u, double v, double variant) {
    const double a = 2 * pi * u, b = pi * v, s = math::sin(b);
    const double r = 0.92 + 0.08 * s * s * math::sin(5 * a) * math::sin((4 + variant) * 2 * b);
    return {r * s * math::sin(a), r * math::cos(b), r * s * math::cos(a)};
}

dvec3 on_torus(double u, double v, double variant) {
    const double a = 2 * pi * u, b = 2 * pi * v;
    const double tube = 0.3 * (1 + (0.08 + 0.1 * variant) * math::sin(9 * a) * math::cos(2 * b));
    const double ring = 0.66 + tube * math::cos(b);
    return {ring * math::sin(a), -tube * math::sin(b), ring * math::cos(a)};
}

// C(t) = ((2 + cos 3t) cos 2t, (2 + cos 3t) sin 2t, sin 3t) / 3.2, and a tube in its Frenet frame: it bends everywhere.
dvec3 on_knot(double u, double v, double variant) {
    const double t = 2 * pi * u, b = 2 * pi * v;
    const double c2 = math::cos(2 * t), s2 = math::sin(2 * t), c3 = math::cos(3 * t), s3 = math::sin(3 * t);
    const double r = 2 + c3, r1 = -3 * s3, r2 = -9 * c3;
    const dvec3 first{r1 * c2 - 2 * r * s2, r1 * s2 + 2 * r * c2, 3 * c3};
    const dvec3 second{r2 * c2 - 4 * r1 * s2 - 4 * r * c2, r2 * s2 + 4 * r1 * c2 - 4 * r * s2, -9 * s3};
    const dvec3 binormal = normalize_or(cross(first, second), dvec3{0, 0, 1});
    const dvec3 normal = normalize_or(cross(binormal, first), dvec3{1, 0, 0});
    const double tube = 0.5 * (1 + 0.15 * variant * math::sin(20 * t));
    return (dvec3{r * c2, r * s2, s3} + normal * (tube * math::cos(b)) + binormal * (tube * math::sin(b))) / 3.5;
}

struct Grid {
    BenchShape shape;
    double variant;
    std::uint32_t rows, columns;
    vec2 repeats;  ///< of the texture, around and down

    bool has_poles() const { return shape == BenchShape::sphere; }
    dvec3 at(double u, double v) const {
        switch (shape) {
            case BenchShape::sphere:
                return on_sphere(u, v, variant);
            case BenchShape::knot:
                return on_knot(u, v, variant);
            case BenchShape::torus:
                break;
        }
        return on_torus(u, v, variant);
    }
};

Grid grid_for(BenchShape shape, std::uint64_t triangles, double variant) {
    const double n = double(std::max<std::uint64_t>(triangles, 20));
    const double around_to_down = shape == BenchShape::knot ? 7 : 2;
    const auto rows = std::max(3u, std::uint32_t(std::lround(std::sqrt(n / (2 * around_to_down)))));
    const double strips = shape == BenchShape::sphere ? rows - 1 : rows;  // a row at a pole is half a strip
    const auto columns = std::max(3u, std::uint32_t(std::lround(n / (2 * strips))));
    const vec2 repeats[] = {{2, 1}, {8, 1}, {3, 1}};
    return {shape, variant, rows, columns, repeats[std::size_t(shape)]};
}

struct Arrays {
    std::vector<vec3> positions, normals;
    std::vector<vec4> tangents;
    std::vector<vec2> texcoords;
    std::vector<std::uint32_t> indices;
};

void add_vertex(const Grid& g, std::uint32_t row, std::uint32_t column, Arrays& out) {
    // What closes has equal places: the last column is the first one again, and so is the last row of a tube.
    const double u = double(column % g.columns) / g.columns,
                 v = g.has_poles() ? double(row) / g.rows : double(row % g.rows) / g.rows;
    constexpr double step = 1e-5, off_pole = 1e-3;
    const double at = g.has_poles() ? std::clamp(v, off_pole, 1 - off_pole) : v;
    const dvec3 along_u = g.at(u + step, at) - g.at(u - step, at), along_v = g.at(u, at + step) - g.at(u, at - step);
    const dvec3 n = normalize_or(cross(along_v, along_u), dvec3{0, 1, 0});
    const dvec3 t = normalize_or(along_u - n * dot(n, along_u), dvec3{1, 0, 0});
    out.positions.push_back(cast<float>(g.at(u, v)));
    out.normals.push_back(cast<float>(n));
    // Textures lie with v down and maps with green up: the bitangent cross(n, t) w points against v.
    const float w = dot(cross(n, t), along_v) < 0 ? 1.0f : -1.0f;
    out.tangents.push_back({float(t.x), float(t.y), float(t.z), w});
    out.texcoords.push_back({g.repeats.x * float(column) / float(g.columns), g.repeats.y * float(row) / float(g.rows)});
}

}  // namespace

Mesh make_bench_shape(BenchShape shape, std::uint64_t triangles, double variant, const Context& context) {
    const Grid g = grid_for(shape, triangles, variant);
    Arrays a;
    for (std::uint32_t row = 0; row <= g.rows; ++row) {
        context.throw_if_cancelled();
        for (std::uint32_t column = 0; column <= g.columns; ++column) add_vertex(g, row, column, a);
    }
    for (std::uint32_t row = 0; row < g.rows; ++row)
        for (std::uint32_t column = 0; column < g.columns; ++column) {
            const std::uint32_t v = row * (g.columns + 1) + column, below = v + g.columns + 1;
            if (!g.has_poles() || row + 1 < g.rows) a.indices.insert(a.indices.end(), {v, below, below + 1});
            if (!g.has_poles() || row > 0) a.indices.insert(a.indices.end(), {v, below + 1, v + 1});
        }
    Mesh mesh;
    mesh.positions = std::move(a.positions);
    mesh.normals = std::move(a.normals);
    mesh.tangents = std::move(a.tangents);
    mesh.texcoords.emplace_back(std::move(a.texcoords));
    mesh.indices = std::move(a.indices);
    return mesh;
}

}  // namespace rakelight
