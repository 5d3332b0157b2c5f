// SPDX-License-Identifier: Apache-2.0
// Surfaces whose normals and heights are known, for bakes.
#pragma once
#include <cmath>

#include "support/scene_builder.h"

namespace rakelight::test {

/// A direction of the sphere at a place of its map: u from +Z over +X, v from +Y down.
inline dvec3 sphere_direction(double u, double v) {
    const double phi = 2 * pi * u, theta = pi * v;
    return {std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
}

/// r(d) = 1 + 0.05 * sin(6 x) * sin(5 y + 1), and the normal of that surface.
struct Dented {
    static double radius(dvec3 d) { return 1 + 0.05 * std::sin(6 * d.x) * std::sin(5 * d.y + 1); }
    static dvec3 normal(dvec3 d) {
        const dvec3 slope{0.3 * std::cos(6 * d.x) * std::sin(5 * d.y + 1),
                          0.25 * std::sin(6 * d.x) * std::cos(5 * d.y + 1), 0};
        const dvec3 along = slope - d * dot(slope, d);  // of r over the unit sphere
        return normalize_or(d * radius(d) - along, d);
    }
};

/// Rows and columns of a sphere; radius(direction) and normal(direction) of its vertices.
template <class Radius, class Normal>
Mesh sphere_mesh(int rows, int columns, const Radius& radius, const Normal& normal) {
    std::vector<vec3> positions, normals;
    std::vector<vec2> uv;
    std::vector<std::uint32_t> indices;
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c <= columns; ++c) {
            const double u = double(c) / columns, v = double(r) / rows;
            const dvec3 d = sphere_direction(c == columns ? 0 : u, v);
            positions.push_back(cast<float>(d * radius(d)));
            normals.push_back(cast<float>(normal(d)));
            uv.push_back({float(u), float(v)});
        }
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const auto at = [&](int row, int column) { return std::uint32_t(row * (columns + 1) + column); };
            if (r > 0) indices.insert(indices.end(), {at(r, c), at(r + 1, c), at(r, c + 1)});
            if (r < rows - 1) indices.insert(indices.end(), {at(r, c + 1), at(r + 1, c), at(r + 1, c + 1)});
        }
    Mesh mesh;
    mesh.name = "sphere";
    mesh.positions = std::move(positions), mesh.normals = std::move(normals), mesh.indices = std::move(indices);
    mesh.texcoords.emplace_back(std::move(uv));
    return mesh;
}

inline Mesh plain_sphere(int rows, int columns, double radius = 1) {
    return sphere_mesh(
        rows, columns, [radius](dvec3) { return radius; }, [](dvec3 d) { return d; });
}

inline Mesh dented_sphere(int rows, int columns) { return sphere_mesh(rows, columns, Dented::radius, Dented::normal); }

inline Scene scene_of(Mesh mesh, const dmat4& to_world = {}) {
    Scene scene;
    scene.source = "made in code";
    add_object(scene, std::move(mesh), to_world);
    return scene;
}

inline double angle_deg(dvec3 a, dvec3 b) {
    return degrees(2 * std::asin(std::min(1.0, length(normalize_or(a, dvec3{}) - normalize_or(b, dvec3{})) / 2)));
}

}  // namespace rakelight::test
