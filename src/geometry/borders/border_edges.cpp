// SPDX-License-Identifier: Apache-2.0
#include "geometry/borders/border_edges.h"

#include <utility>

#include "base/cancel_check.h"
#include "geometry/groups/authored_normals.h"
#include "geometry/input/face_vote.h"

namespace rakelight::geometry {
namespace {

/// False if the edge is unusable.
bool edge_at(const PlacedMeshes& placed, std::uint32_t corner, BorderEdge& edge) {
    const AttributeInput& input = placed.input;
    const std::uint32_t m = edge.mesh = input.mesh_of_triangle(corner / 3), k = corner % 3;
    const AttributeMesh& mesh = input.meshes[m];
    const Placement& placement = input.placements[m];
    const std::uint32_t* const index = mesh.indices.data() + (corner - k - 3 * input.triangle_base[m]);
    std::uint32_t from = index[k], to = index[(k + 1) % 3];
    if (placement.flip < 0) std::swap(from, to);
    edge.a = placement.position(mesh.positions[from]), edge.b = placement.position(mesh.positions[to]);
    edge.vertex_a = input.vertex_base[m] + from, edge.vertex_b = input.vertex_base[m] + to;
    const Direction along = direction_of(edge.b - edge.a);
    edge.along = along.unit, edge.length = along.length;
    edge.face = face_normal(placement, face_corners(mesh, index)).unit;
    edge.inward = cross(edge.face, edge.along);
    edge.normal_a = given_normal(placement, mesh.normals[from]);
    edge.normal_b = given_normal(placement, mesh.normals[to]);
    dvec3 corners[3];
    for (int i = 0; i < 3; ++i) corners[i] = given_normal(placement, mesh.normals[index[i]]);
    edge.is_flat =
        are_authored_flat(corners, edge.face,
                          square_normal(mesh, placement, std::uint32_t((index - mesh.indices.data()) / 3), corners[0]));
    return edge.length > 0 && edge.face != dvec3{} && edge.normal_a != dvec3{} && edge.normal_b != dvec3{};
}

}  // namespace

void check_matching_memory(std::size_t open_edges, Context& context) {
    context.memory().check(open_edges * (2 * sizeof(BorderEdge) + 512), "matching open borders");
}

std::vector<BorderEdge> border_edges(const PlacedMeshes& placed, std::span<const std::uint32_t> open_corners,
                                     Context& context) {
    check_matching_memory(open_corners.size(), context);
    std::vector<BorderEdge> edges;
    edges.reserve(open_corners.size());
    CancelCheck check(context);
    for (const std::uint32_t corner : open_corners) {
        check();
        BorderEdge edge;
        if (edge_at(placed, corner, edge)) edges.push_back(edge);
    }
    return edges;
}

}  // namespace rakelight::geometry
