// SPDX-License-Identifier: Apache-2.0
#include "hard_edges.h"

#include <algorithm>
#include <compare>

#include <rakelight/math/linear.h>
#include <rakelight/tools/inspect.h>

#include "../../apps/viewer/view/view_box.h"

namespace rakelight::web {
namespace {

constexpr vec4 color{1, 0.36f, 0.1f, 1};

/// A side of a face, from the smaller position to the larger one.
struct Edge {
    vec3 a, b, normal_a, normal_b;
};

auto order_of(vec3 p) { return std::array{p.x, p.y, p.z}; }

std::vector<Edge> edges_of(const Mesh& mesh) {
    std::vector<Edge> edges;
    edges.reserve(mesh.indices.size());
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t u = mesh.indices[3 * t + k], v = mesh.indices[3 * t + (k + 1) % 3];
            Edge edge{mesh.positions[u], mesh.positions[v], mesh.normals[u], mesh.normals[v]};
            if (order_of(edge.b) < order_of(edge.a)) std::swap(edge.a, edge.b), std::swap(edge.normal_a, edge.normal_b);
            edges.push_back(edge);
        }
    std::ranges::sort(edges, {}, [](const Edge& e) { return std::pair(order_of(e.a), order_of(e.b)); });
    return edges;
}

bool differ(vec3 a, vec3 b) { return length(a - b) > float(radians(continuous_deg)); }

bool is_hard(const Edge& e, const Edge& f) { return differ(e.normal_a, f.normal_a) || differ(e.normal_b, f.normal_b); }

dvec3 placed(const dmat4& world, vec3 p) { return transform_point(world, dvec3{p.x, p.y, p.z}); }

}  // namespace

std::vector<Line> hard_edge_lines(const Scene& prepared, std::size_t most) {
    const std::vector<dmat4> world = viewer::node_matrices(prepared);
    std::vector<Line> lines;
    for (std::size_t n = 0; n < prepared.nodes.size(); ++n)
        for (const std::uint32_t m : prepared.nodes[n].meshes) {
            const Mesh& mesh = prepared.meshes[m];
            if (mesh.topology != Topology::triangles || mesh.normals.empty()) continue;
            const std::vector<Edge> edges = edges_of(mesh);
            for (std::size_t i = 0; i + 1 < edges.size() && lines.size() < most; ++i) {
                const Edge &e = edges[i], &f = edges[i + 1];
                if (order_of(e.a) != order_of(f.a) || order_of(e.b) != order_of(f.b) || !is_hard(e, f)) continue;
                lines.push_back({placed(world[n], e.a), placed(world[n], e.b), color, 2});
            }
        }
    return lines;
}

}  // namespace rakelight::web
