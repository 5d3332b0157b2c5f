// SPDX-License-Identifier: Apache-2.0
#include "cpu_shading/make_mesh_view.h"

#include <algorithm>
#include <cmath>

namespace rakelight::cpu_shading {
namespace {

/// Rows of a matrix as floats, scaled so that none is out of their range: only directions count.
void set_rows(float (&to)[3][3], const dmat3& m) {
    double largest = 0;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t r = 0; r < 3; ++r) largest = std::max(largest, std::fabs(m[c][r]));
    const double scale = largest > 0 && std::isfinite(largest) ? 1 / largest : 1;
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t r = 0; r < 3; ++r) to[r][c] = float(m[c][r] * scale);
}

}  // namespace

MeshView make_mesh_view(const Mesh& mesh, const shading::DrawFrame& frame) {
    MeshView view{};
    view.indices = mesh.indices.data();
    view.vertices = std::int32_t(mesh.positions.size());
    view.positions = &mesh.positions[0].x;
    if (!mesh.normals.empty()) view.normals = &mesh.normals[0].x;
    if (!mesh.tangents.empty()) view.tangents = &mesh.tangents[0].x;
    if (!mesh.bitangents.empty()) view.bitangents = &mesh.bitangents[0].x;
    for (std::size_t set = 0; set < std::min<std::size_t>(2, mesh.texcoords.size()); ++set)
        if (!mesh.texcoords[set].empty()) view.texcoords[set] = &mesh.texcoords[set][0].x;
    if (!mesh.colors.empty()) view.colors = &mesh.colors[0].x;
    set_rows(view.to_normal, frame.to_normal());
    set_rows(view.linear, frame.linear());
    view.mirror = float(frame.mirror());
    view.turned = frame.side().front_turns();
    view.against = frame.side().against();
    return view;
}

}  // namespace rakelight::cpu_shading
