// SPDX-License-Identifier: Apache-2.0
#include "geometry/group_rings.h"

#include <algorithm>

namespace rakelight::geometry {
namespace {

std::vector<std::uint32_t> groups_of_corners(const Topology& topology, const AttributeInput& input, Context& context) {
    std::vector<std::uint32_t> groups(3 * std::size_t(input.triangle_count()));
    const std::vector<Chunk> chunks = make_chunks(input.triangle_base, triangles_per_chunk);
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        for_each_range(chunks[c], input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const std::uint32_t base = 3 * input.triangle_base[m];
            for (std::uint32_t corner = base + 3 * first; corner != base + 3 * last; ++corner)
                groups[corner] = topology.group[topology.vertex_of(input, m, corner)];
        });
    });
    return groups;
}

/// @param to  room for two of each corner
std::uint32_t put_ring(const GroupRings& rings, std::uint32_t group, std::uint32_t* to) {
    std::uint32_t* end = to;
    for (const std::uint32_t corner : rings.corners[group]) {
        const std::uint32_t t = corner / 3, k = corner % 3;
        if (!rings.is_face(t)) continue;
        *end++ = rings.group_of_corner[3 * t + (k + 1) % 3];
        *end++ = rings.group_of_corner[3 * t + (k + 2) % 3];
    }
    std::sort(to, end);
    end = std::unique(to, end);
    end = std::remove(to, end, group);
    return std::uint32_t(end - to);
}

}  // namespace

GroupRings group_rings(const Topology& topology, const AttributeInput& input, Context& context) {
    GroupRings rings;
    const std::size_t count = topology.group.size(), step = vertices_per_chunk;
    context.memory().check(count * (sizeof(dvec3) + 8) + input.triangle_count() * (sizeof(dvec3) + 12 * 4ull),
                           "neighbors of vertices");
    rings.face_normals = face_normals(input, context);
    rings.group_of_corner = groups_of_corners(topology, input, context);
    rings.corners = bin_corners(topology, input, {}, context);
    rings.ring_size.assign(count, 0);
    rings.ring_members.reserve(2 * std::size_t(rings.corners.begin.back()));
    rings.places.reserve(count);
    context.parallel_for((count + step - 1) / step, [&](std::size_t c) {
        for_each_group(topology, c * step, std::min(count, (c + 1) * step), [&](std::uint32_t g) {
            rings.ring_size[g] =
                put_ring(rings, g, rings.ring_members.data() + 2 * std::size_t(rings.corners.begin[g]));
            const std::uint32_t v = topology.source_of(input, g), m = input.mesh_of_vertex(v);
            rings.places[g] = input.placements[m].position(input.meshes[m].positions[v - input.vertex_base[m]]);
        });
    });
    return rings;
}

}  // namespace rakelight::geometry
