// SPDX-License-Identifier: Apache-2.0
// Spheres, tori, blobs, terrain and rocks: mostly nothing is hard.
#include <algorithm>
#include <cmath>

#include "math/functions.h"
#include "math/linear.h"
#include "tools/bench/normal_shapes.h"
#include "tools/creases/model_families.h"

namespace rakelight {
namespace {

/// Triangles of one surface, or each its own.
Solid of_triangles(const KnownSurface& from, bool is_faceted = false) {
    Solid s;
    const Surface skin = s.new_surface();
    for (const auto& t : from.triangles)
        s.add({from.positions[t[0]], from.positions[t[1]], from.positions[t[2]]}, is_faceted ? s.new_surface() : skin);
    return s;
}

Solid sphere(int columns, int rows) {
    Path p(0, -1);
    p.arc({}, 1, -90, 90 - 180.0 / rows, rows - 1, 'a');
    Solid s;
    s.add_revolved(p.to(0, 1, 'a'), columns);
    return s;
}

Solid torus(int columns, int rows) {
    Solid s;
    s.add_revolved(circle({1, 0}, 0.4, rows, 'a'), columns);
    return s;
}

KnownSurface blob(int levels) {
    KnownSurface s = icosphere(levels);
    for (dvec3& p : s.positions) p = p * (1 + 0.25 * math::sin(3 * p.x + 1) * math::cos(2 * p.y) + 0.2 * p.z * p.z);
    return s;
}

KnownSurface rock(int levels, double roughness) {
    Random random(3);
    KnownSurface s = icosphere(levels);
    for (dvec3& p : s.positions) p = p * (1 + random.within(-roughness, roughness));
    return s;
}

/// Hills on a block with flat sides.
Solid terrain_block(int columns) {
    const auto point = [&](int i, int j) {
        const double x = 2.0 * i / columns - 1, y = 2.0 * j / columns - 1;
        return dvec3{x, y, 0.12 * math::sin(4 * x + 1) * math::cos(3 * y) + 0.06 * math::sin(7 * y + 2 * x)};
    };
    Solid s;
    const Surface hills = s.new_surface();
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < columns; ++j)
            s.add({point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)}, hills);
    const dvec2 corners[] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int side = 0; side < 4; ++side) {
        const dvec2 a = corners[side], b = corners[(side + 1) % 4];
        Loop loop = {{a.x, a.y, -0.6}, {b.x, b.y, -0.6}};
        for (int k = columns; k >= 0; --k)
            loop.push_back(side == 0   ? point(k, 0)
                           : side == 1 ? point(columns, k)
                           : side == 2 ? point(columns - k, columns)
                                       : point(0, columns - k));
        s.add_flat(loop, {}, s.new_surface());
    }
    s.add({{-1, 1, -0.6}, {1, 1, -0.6}, {1, -1, -0.6}, {-1, -1, -0.6}}, s.new_surface());
    return s;
}

/// A blob that stands on a flat base.
Solid cut_blob() {
    Solid s = of_triangles(blob(3));
    s.cut({0, 0, -0.5}, {0, 0, -1});
    return s;
}

Solid octahedron() {
    Solid s;
    for (const double z : {1.0, -1.0})
        for (int k = 0; k < 4; ++k) {
            const dvec3 a = around(1, 0.25 * k, 0), b = around(1, 0.25 * (k + 1), 0);
            s.add(z > 0 ? Loop{a, b, {0, 0, z}} : Loop{b, a, {0, 0, z}}, s.new_surface());
        }
    return s;
}

void add_freeform(CreaseModels& to) {
    to.push_back(make_model("UV sphere of 8 x 6", sphere(8, 6)));
    to.push_back(make_model("UV sphere of 12 x 8", sphere(12, 8), {.digits = 4}));
    to.push_back(make_model("UV sphere of 24 x 12, 12 bits", sphere(24, 12), {.bits = 12}));
    to.push_back(make_model("icosphere of level 0", of_triangles(icosphere(0)), {.is_decidable = false}));
    for (const int levels : {1, 2, 3})
        to.push_back(
            make_model("icosphere of level " + std::to_string(levels), of_triangles(icosphere(levels)), {.digits = 5}));
    to.push_back(make_model("torus of 12 x 8", torus(12, 8), {.digits = 5}));
    to.push_back(make_model("torus of 32 x 16", torus(32, 16), {.digits = 5}));
    to.push_back(
        make_model("torus of 20 x 10, mixed diagonals", torus(20, 10), {.digits = 4, .diagonals = Diagonals::random}));
    for (const int levels : {2, 3})
        to.push_back(make_model("blob of level " + std::to_string(levels), of_triangles(blob(levels)), {.digits = 4}));
    to.push_back(make_model("rough stone", of_triangles(rock(2, 0.05)), {.digits = 4}));
    to.push_back(make_model("rock, soft", of_triangles(rock(1, 0.12)), {.digits = 4, .is_decidable = false}));
    to.push_back(make_model("rock, faceted", of_triangles(rock(1, 0.12), true), {.digits = 4, .is_decidable = false}));
    to.push_back(make_model("octahedron", octahedron(), {.is_decidable = false}));
    to.push_back(make_model("block with hills", terrain_block(14), {.digits = 4}));
    to.push_back(make_model("block with hills, mixed diagonals", terrain_block(10),
                            {.digits = 4, .diagonals = Diagonals::random}));
    to.push_back(make_model("blob on a flat base", cut_blob(), {.digits = 4}));
}

}  // namespace

constinit const ModelFamily freeform_models{.add = add_freeform};

}  // namespace rakelight
