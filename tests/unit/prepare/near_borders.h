// SPDX-License-Identifier: Apache-2.0
// Parts whose borders run along each other without sharing vertices.
#pragma once
#include <rakelight/scene/scene.h>

#include <cmath>
#include <vector>

#include "math/linear.h"

namespace rakelight::near_borders {

inline Node at(std::uint32_t mesh, dmat4 place = {}) {
    Node node;
    node.meshes = {mesh};
    node.local.matrix = place;
    return node;
}

/// Normals that lean by `lean` along x, tangents along x.
inline void lean(Mesh& mesh, float lean) {
    const vec3 n = cast<float>(normalize_or(dvec3{lean, 1, 0}, dvec3{})),
               t = cast<float>(normalize_or(dvec3{1, -lean, 0}, dvec3{}));
    mesh.normals = std::vector<vec3>(mesh.positions.size(), n);
    mesh.tangents = std::vector<vec4>(mesh.positions.size(), vec4{t.x, t.y, t.z, -1});
}

/// A square in y = 0 whose border at x = 1 has the vertices 2 and 3.
inline Mesh plain_square(float leaning) {
    Mesh mesh;
    mesh.positions = std::vector<vec3>{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
    mesh.indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
    lean(mesh, leaning);
    return mesh;
}

/// One whose border at x = `from` has the vertices 0, 1 and 2.
inline Mesh cut_square(float from, float leaning) {
    Mesh mesh;
    mesh.positions = std::vector<vec3>{{from, 0, 0}, {from, 0, 0.5f}, {from, 0, 1}, {2, 0, 1}, {2, 0, 0}};
    mesh.indices = std::vector<std::uint32_t>{0, 1, 4, 1, 3, 4, 1, 2, 3};
    lean(mesh, leaning);
    return mesh;
}

/// Both, 0.01 apart, leaning apart.
inline Scene two_squares() {
    Scene scene;
    scene.meshes = {plain_square(-0.1f), cut_square(1.01f, 0.3f)};
    scene.nodes = {at(0), at(1)};
    return scene;
}

/// Half of a tube of radius 1 about z, from z = 0 to `length`, without normals: 9 vertices a ring, `rings` + 1 rings.
/// @param first_deg  from there it goes 180 degrees on
inline Mesh half_tube(double first_deg, int rings, double length) {
    Mesh mesh;
    std::vector<vec3> positions;
    std::vector<std::uint32_t> indices;
    for (int ring = 0; ring <= rings; ++ring)
        for (int k = 0; k <= 8; ++k) {
            const double angle = radians(first_deg + 22.5 * k);
            positions.push_back(
                {float(std::cos(angle)), float(std::sin(angle)), float(length * double(ring) / double(rings))});
        }
    for (int ring = 0; ring < rings; ++ring)
        for (int k = 0; k < 8; ++k) {
            const std::uint32_t a = std::uint32_t(9 * ring + k), b = a + 1, c = a + 9, d = a + 10;
            indices.insert(indices.end(), {a, b, d, a, d, c});
        }
    mesh.positions = std::move(positions);
    mesh.indices = std::move(indices);
    return mesh;
}

/// A tube of two halves, the second with twice as many rings and `gap` apart along x.
inline Scene two_halves(int rings, double gap) {
    Scene scene;
    scene.meshes = {half_tube(90, rings, 4), half_tube(-90, 2 * rings, 4)};
    scene.nodes = {at(0), at(1, translation(dvec3{gap, 0, 0}))};
    return scene;
}

}  // namespace rakelight::near_borders
