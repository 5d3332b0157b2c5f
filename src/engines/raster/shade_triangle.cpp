// SPDX-License-Identifier: Apache-2.0
// The kernel's record of a triangle: edge functions about the tile, attributes of the corners in world axes about the eye.
#include <algorithm>
#include <cmath>

#include "engines/raster/tile.h"
#include "math/linear.h"

namespace rakelight::raster {
namespace {

void set_planes(const FrontEnd& front, const ScreenTriangle& s, const std::uint32_t (&index)[3], int tile_x, int tile_y,
                ShadeTriangle& out) {
    ClipVertex v[3];
    double scale = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        v[k] = front.clip[s.draw][index[k]];
        scale = std::max(scale, std::fabs(double(v[k].w)));  // keeps the sum of the three near 1 at any size of the model
    }
    EdgePlanes e;
    if (!edge_planes(v, front.view, tile_x + 0.5, tile_y + 0.5, e)) e = {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}};
    for (std::size_t k = 0; k < 3; ++k) {
        out.ex[k] = float(e.ex[k] * scale);
        out.ey[k] = float(e.ey[k] * scale);
        out.e0[k] = float(e.e0[k] * scale);
    }
}

/// As normalize_or(), whose care for overflow and underflow few vectors need.
dvec3 unit_or(dvec3 v, dvec3 fallback) {
    const double square = dot(v, v);
    return square > 1e-200 && square < 1e200 ? v * (1 / std::sqrt(square)) : normalize_or(v, fallback);
}

/// a0, a1 - a0, a2 - a0 of a vector attribute.
void set_deltas(float (&to)[3][3], const dvec3 (&a)[3]) {
    for (std::size_t c = 0; c < 3; ++c) {
        to[0][c] = float(a[0][c]);
        to[1][c] = float(a[1][c] - a[0][c]);
        to[2][c] = float(a[2][c] - a[0][c]);
    }
}

void set_texcoords(float (&to)[3][2], const Mesh& mesh, std::size_t set, const std::uint32_t (&index)[3]) {
    if (set >= mesh.texcoords.size() || mesh.texcoords[set].empty()) return;
    const Block<vec2>& uv = mesh.texcoords[set];
    for (std::size_t c = 0; c < 2; ++c) {
        to[0][c] = uv[index[0]][c];
        to[1][c] = uv[index[1]][c] - to[0][c];
        to[2][c] = uv[index[2]][c] - to[0][c];
    }
}

void set_colors(float (&to)[3][4], const Mesh& mesh, const std::uint32_t (&index)[3]) {
    for (std::size_t c = 0; c < 4; ++c) {
        to[0][c] = mesh.colors.empty() ? 1.0f : mesh.colors[index[0]][c];
        to[1][c] = mesh.colors.empty() ? 0.0f : mesh.colors[index[1]][c] - to[0][c];
        to[2][c] = mesh.colors.empty() ? 0.0f : mesh.colors[index[2]][c] - to[0][c];
    }
}

/// Whether the shading normal is turned round. A surface that is shown from both sides is lit from the side it is seen from:
/// by winding where the format gives winding a meaning, else so that the normals agree with the side that faces the viewer.
float facing(const FrontEnd& front, const ScreenTriangle& s, const dvec3 (&position)[3], const dvec3 (&normal)[3]) {
    const DrawMaterial& material = front.list.materials[front.list.draws[s.draw].material];
    if (!material.classical) return s.is_back ? -1.0f : 1.0f;
    const dvec3 face = cross(position[1] - position[0], position[2] - position[0]);
    const dvec3 to_viewer = front.view.orthographic ? front.view.camera_to_world[2].xyz() : -position[0];
    const double seen = dot(face, to_viewer), agree = dot(face, normal[0] + normal[1] + normal[2]);
    return (seen < 0) != (agree < 0) ? -1.0f : 1.0f;
}

}  // namespace

void make_shade_triangle(const FrontEnd& front, const ScreenTriangle& s, int tile_x, int tile_y, ShadeTriangle& out) {
    const Draw& draw = front.list.draws[s.draw];
    const Mesh& mesh = front.list.scene.meshes[draw.mesh];
    const dmat4& to_eye = front.to_eye[s.draw];
    const dmat3 linear = upper_left(to_eye), to_normal = cofactor(linear);
    const double mirror = draw.mirrored ? -1 : 1;
    std::uint32_t index[3];
    for (std::size_t k = 0; k < 3; ++k) index[k] = mesh.indices[3 * std::size_t(s.triangle) + k];

    out = {};
    set_planes(front, s, index, tile_x, tile_y, out);
    dvec3 position[3], normal[3], tangent[3];
    out.handedness = float(mirror);
    for (std::size_t k = 0; k < 3; ++k) {
        position[k] = transform_point(to_eye, cast<double>(mesh.positions[index[k]]));
        if (!mesh.normals.empty()) normal[k] = unit_or(to_normal * cast<double>(mesh.normals[index[k]]) * mirror, dvec3{0, 0, 1});
        if (!mesh.tangents.empty()) tangent[k] = unit_or(linear * cast<double>(mesh.tangents[index[k]].xyz()), dvec3{});
    }
    if (mesh.normals.empty()) {
        const dvec3 face = unit_or(cross(position[1] - position[0], position[2] - position[0]) * mirror, dvec3{0, 0, 1});
        std::fill(normal, normal + 3, face);
    }
    if (!mesh.tangents.empty()) out.handedness = float(mirror) * mesh.tangents[index[0]].w;
    set_deltas(out.position, position);
    set_deltas(out.normal, normal);
    set_deltas(out.tangent, tangent);
    set_texcoords(out.texcoord0, mesh, 0, index);
    set_texcoords(out.texcoord1, mesh, 1, index);
    set_colors(out.color, mesh, index);
    out.facing = facing(front, s, position, normal);
}

}  // namespace rakelight::raster
