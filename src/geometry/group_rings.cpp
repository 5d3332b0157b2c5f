// SPDX-License-Identifier: Apache-2.0
#include "geometry/group_rings.h"

#include <algorithm>

#include "geometry/face_vote.h"

namespace rakelight::geometry {
namespace {

/// Fills face_normals and group_of_corner.
void read_faces(GroupRings& rings, const Topology& topology, const AttributeInput& input, Context& context) {
    rings.face_normals.reserve(input.triangle_count());
    rings.group_of_corner.reserve(3 * std::size_t(input.triangle_count()));
    const std::vector<Chunk> chunks = make_chunks(input.triangle_base, triangles_per_chunk);
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        for_each_range(chunks[c], input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const AttributeMesh& mesh = input.meshes[m];
            for (std::uint32_t t = first; t != last; ++t) {
                const FaceCorners face = face_corners(mesh, mesh.indices.data() + 3 * std::size_t(t));
                const std::uint32_t at = input.triangle_base[m] + t;
                rings.face_normals[at] = cast<float>(face_normal(input.placements[m], face).unit);
                for (std::uint32_t corner = 3 * at; corner != 3 * at + 3; ++corner)
                    rings.group_of_corner[corner] = topology.group[topology.vertex_of(input, m, corner)];
            }
        });
    });
}

void add_once(std::vector<std::uint32_t>& to, std::size_t first, std::uint32_t group) {
    if (std::find(to.begin() + std::ptrdiff_t(first), to.end(), group) == to.end()) to.push_back(group);
}

/// Appends the ring of a group.
void put_ring(const GroupRings& rings, std::uint32_t group, std::vector<std::uint32_t>& to) {
    constexpr std::size_t few = 64;
    const std::size_t first = to.size();
    const std::span<const std::uint32_t> corners = rings.corners[group];
    for (const std::uint32_t corner : corners) {
        if (!rings.is_face(corner / 3)) continue;
        for (const std::uint32_t other : {rings.next(corner), rings.previous(corner)}) {
            if (other == group) continue;
            if (corners.size() > few)
                to.push_back(other);
            else
                add_once(to, first, other);
        }
    }
    if (corners.size() <= few) return;
    std::sort(to.begin() + std::ptrdiff_t(first), to.end());
    to.erase(std::unique(to.begin() + std::ptrdiff_t(first), to.end()), to.end());
}

}  // namespace

GroupRings group_rings(const Topology& topology, const AttributeInput& input, Context& context) {
    GroupRings rings;
    const std::size_t count = topology.group.size(), step = vertices_per_chunk, chunks = (count + step - 1) / step;
    context.memory().check(count * (sizeof(dvec3) + 12) + input.triangle_count() * (sizeof(vec3) + 12 * 4ull),
                           "neighbors of vertices");
    read_faces(rings, topology, input, context);
    rings.corners = bin_corners(topology, input, {}, context);
    rings.ring_size.assign(count, 0);
    rings.ring_begin.assign(count, 0);
    rings.ring_members.resize(chunks);
    rings.places.reserve(count);
    context.parallel_for(chunks, [&](std::size_t c) {
        const std::size_t first = c * step, last = std::min(count, first + step);
        std::vector<std::uint32_t> members;
        members.reserve(rings.corners.begin[last] - rings.corners.begin[first] + step / 8);
        for_each_group(topology, first, last, [&](std::uint32_t g) {
            rings.ring_begin[g] = std::uint32_t(members.size());
            put_ring(rings, g, members);
            rings.ring_size[g] = std::uint32_t(members.size()) - rings.ring_begin[g];
            const std::uint32_t v = topology.source_of(input, g), m = input.mesh_of_vertex(v);
            rings.places[g] = input.placements[m].position(input.meshes[m].positions[v - input.vertex_base[m]]);
        });
        rings.ring_members[c] = std::move(members);
    });
    return rings;
}

}  // namespace rakelight::geometry
