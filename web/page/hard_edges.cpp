// SPDX-License-Identifier: Apache-2.0
#include "hard_edges.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <rakelight/math/linear.h>
#include <rakelight/tools/inspect.h>

#include "../../apps/viewer/view/view_box.h"

namespace rakelight::web {
namespace {

constexpr vec4 hard{1, 0.36f, 0.1f, 1}, smooth{0.25f, 0.6f, 1, 1};
constexpr double bent_deg = 30;  // from where on a smooth edge is worth showing

using Place = std::array<double, 3>;

/// A side of a face, from the smaller position to the larger one.
struct Edge {
    Place a, b;
    vec3 normal_a, normal_b, face;  ///< unit; of the face by its corners
};

Place place_of(const Mesh& mesh, std::uint32_t vertex) {
    const dvec3 p = mesh.origin + cast<double>(mesh.positions[vertex]);
    return {p.x, p.y, p.z};
}

void add_edges(const Mesh& mesh, std::vector<Edge>& to) {
    if (mesh.topology != Topology::triangles || mesh.normals.empty()) return;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto at = [&](std::size_t k) { return mesh.positions[mesh.indices[3 * t + k]]; };
        const vec3 face = normalize_or(cross(at(1) - at(0), at(2) - at(0)), vec3{});
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t u = mesh.indices[3 * t + k], v = mesh.indices[3 * t + (k + 1) % 3];
            Edge edge{place_of(mesh, u), place_of(mesh, v), mesh.normals[u], mesh.normals[v], face};
            if (edge.b < edge.a) std::swap(edge.a, edge.b), std::swap(edge.normal_a, edge.normal_b);
            to.push_back(edge);
        }
    }
}

bool differ(vec3 a, vec3 b) { return length(a - b) > float(radians(continuous_deg)); }

bool is_hard(const Edge& e, const Edge& f) { return differ(e.normal_a, f.normal_a) || differ(e.normal_b, f.normal_b); }

bool is_bent(const Edge& e, const Edge& f) { return dot(e.face, f.face) < float(std::cos(radians(bent_deg))); }

dvec3 placed(const dmat4& world, const Place& p) { return transform_point(world, dvec3{p[0], p[1], p[2]}); }

}  // namespace

std::vector<Line> hard_edge_lines(const Scene& prepared, std::size_t most) {
    const std::vector<dmat4> world = viewer::node_matrices(prepared);
    std::vector<Line> lines;
    for (std::size_t n = 0; n < prepared.nodes.size() && lines.size() < most; ++n) {
        std::vector<Edge> edges;
        for (const std::uint32_t m : prepared.nodes[n].meshes) add_edges(prepared.meshes[m], edges);
        std::ranges::sort(edges, {}, [](const Edge& e) { return std::pair(e.a, e.b); });
        for (std::size_t i = 0; i + 1 < edges.size() && lines.size() < most; ++i)
            if (const Edge& e = edges[i], &f = edges[i + 1];
                e.a == f.a && e.b == f.b && (is_hard(e, f) || is_bent(e, f)))
                lines.push_back({placed(world[n], e.a), placed(world[n], e.b), is_hard(e, f) ? hard : smooth, 2});
    }
    return lines;
}

}  // namespace rakelight::web
