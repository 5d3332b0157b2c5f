// SPDX-License-Identifier: Apache-2.0
// Crumpled sheets whose averaged normals stand away from some of their own triangles.
#pragma once
#include "unit/geometry/shapes.h"

namespace rakelight::test {

/// A sheet of 16 x 16 quads over -1..1, counter-clockwise as seen from +Z, thrown about so far that it folds.
inline Shape make_crumpled_sheet(unsigned seed) {
    std::mt19937 random(seed);
    const auto any = [&](double by) { return by * (2 * double(random()) / double(std::mt19937::max()) - 1); };
    return make_grid(16, 16, [&](double u, double v) {
        return vec3{float(2 * u - 1 + any(0.05)), float(2 * v - 1 + any(0.05)), float(any(0.3))};
    });
}

/// With the normals that smoothing over all of it makes.
inline std::vector<Shape> smoothed(std::vector<Shape> shapes, CornerWeight weight) {
    AttributeOptions options = published();
    options.weight = weight;
    options.tangents = false;
    const std::vector<MeshAttributes> made = compute(shapes, options);
    for (std::size_t i = 0; i < shapes.size(); ++i) shapes[i].normals = made[i].normals;
    return shapes;
}

/// A quarter of it each, and a single triangle.
inline std::vector<Shape> in_parts(const Shape& sheet) {
    return cut(sheet, 5, [](std::size_t t) { return t == 100 ? 4u : std::uint32_t(t % 4); });
}

inline int count_against_own(const Shape& s) {
    int count = 0;
    for (std::size_t t = 0; t < s.indices.size(); t += 3) {
        const vec3 a = s.positions[s.indices[t]], b = s.positions[s.indices[t + 1]], c = s.positions[s.indices[t + 2]];
        const vec3 sum = s.normals[s.indices[t]] + s.normals[s.indices[t + 1]] + s.normals[s.indices[t + 2]];
        count += dot(cross(b - a, c - a), sum) < 0;
    }
    return count;
}

}  // namespace rakelight::test
