// SPDX-License-Identifier: Apache-2.0
#include "prepare/refine/refined_mesh.h"

#include "math/linear.h"

namespace rakelight {
namespace {

/// The attribute at the middle of an edge.
template <class T>
T halfway(T a, T b) {
    return (a + b) * 0.5f;
}
vec4 halfway_tangent(vec4 a, vec4 b) { return {(a.x + b.x) * 0.5f, (a.y + b.y) * 0.5f, (a.z + b.z) * 0.5f, a.w}; }

template <class T, class Half>
Block<T> refined(const Block<T>& from, const geometry::FineMesh& fine, const Half& half) {
    if (from.empty()) return {};
    std::vector<T> out(from.begin(), from.end());
    out.reserve(fine.places.size());
    for (const auto& [a, b] : fine.middle_of) out.push_back(half(out[a], out[b]));
    return out;
}

}  // namespace

Mesh refined_mesh(const Mesh& coarse, const geometry::FineMesh& fine) {
    Mesh mesh = coarse;
    mesh.positions = refined(coarse.positions, fine, halfway<vec3>);
    mesh.normals = refined(coarse.normals, fine, halfway<vec3>);
    mesh.tangents = refined(coarse.tangents, fine, halfway_tangent);
    for (Block<vec2>& set : mesh.texcoords) set = refined(set, fine, [](vec2 a, vec2 b) { return (a + b) * 0.5f; });
    mesh.colors = refined(coarse.colors, fine, halfway<vec4>);
    if (!coarse.smoothing.empty()) {
        std::vector<std::uint32_t> groups;
        for (const std::uint32_t t : fine.source_triangle) groups.push_back(coarse.smoothing[t]);
        mesh.smoothing = std::move(groups);
    }
    mesh.indices = fine.indices;
    mesh.smoothing_hint = {};
    mesh.polygons = {};
    mesh.influences = {}, mesh.more_influences = {};
    mesh.targets = {};
    return mesh;
}

}  // namespace rakelight
