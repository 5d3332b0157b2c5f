// SPDX-License-Identifier: Apache-2.0
#include "geometry/fits/group_rings.h"

#include <algorithm>
#include <cmath>

#include "geometry/input/face_vote.h"

namespace rakelight::geometry {
namespace {

constexpr double most_slack_rad = 0.01;

GroupFace face_of(const AttributeMesh& mesh, const Placement& placement, const std::uint32_t* index) {
    const FaceCorners face = face_corners(mesh, index);
    const Direction normal = face_normal(placement, face);
    if (!(normal.length > 0)) return {};
    float reach = 0;
    for (int k = 0; k < 3; ++k) {
        const vec3 p = mesh.positions[index[k]];
        reach = std::max({reach, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    }
    const dvec3 third = face.e2 - face.e1, across = cross(face.e1, face.e2);
    const double longest = std::max({dot(face.e1, face.e1), dot(face.e2, face.e2), dot(third, third)});
    const double height = std::sqrt(dot(across, across) / longest);
    return {cast<float>(normal.unit), float(0.5 * normal.length),
            height > 0 ? float(std::min(0x1p-23 * double(reach) / height, most_slack_rad)) : 0, placement.flip < 0};
}

/// Fills faces and group_of_corner.
void read_faces(GroupRings& rings, const Topology& topology, const AttributeInput& input,
                std::span<const std::uint8_t> known, Context& context) {
    const std::vector<Chunk> chunks = make_chunks(input.triangle_base, triangles_per_chunk);
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        for_each_range(chunks[c], input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const AttributeMesh& mesh = input.meshes[m];
            for (std::uint32_t t = first; t != last; ++t) {
                const std::uint32_t at = input.triangle_base[m] + t;
                std::uint32_t group[3];
                bool is_known = known.empty();
                for (std::uint32_t k = 0; k < 3; ++k) {
                    group[k] = topology.group[topology.vertex_of(input, m, 3 * at + k)];
                    is_known = is_known || known[group[k]] != 0;
                }
                if (!is_known) continue;
                std::copy(group, group + 3, rings.group_of_corner.data() + 3 * std::size_t(at));
                rings.faces[at] = face_of(mesh, input.placements[m], mesh.indices.data() + 3 * std::size_t(t));
            }
        });
    });
}

void read_places(GroupRings& rings, const Topology& topology, const AttributeInput& input, Context& context) {
    const std::size_t count = topology.group.size(), step = vertices_per_chunk;
    context.parallel_for((count + step - 1) / step, [&](std::size_t c) {
        std::uint32_t m = 0;
        for_each_group(topology, c * step, std::min(count, (c + 1) * step), [&](std::uint32_t g) {
            const std::uint32_t v = topology.source_of(input, g);
            if (v < input.vertex_base[m] || v >= input.vertex_base[m + 1]) m = input.mesh_of_vertex(v);
            rings.places[g] = input.placements[m].position(input.meshes[m].positions[v - input.vertex_base[m]]);
        });
    });
}

}  // namespace

void GroupRings::release(GeneralScratch& scratch) {
    scratch.give(faces), scratch.give(group_of_corner), scratch.give(corners.corners), scratch.give(places);
    scratch.give(corners.begin), scratch.give(ring_begin), scratch.give(ring_size);
}

GroupRings group_faces(const Topology& topology, const AttributeInput& input, std::span<const std::uint8_t> known,
                       GeneralScratch& scratch, Context& context) {
    GroupRings rings;
    const std::size_t corners = 3 * std::size_t(input.triangle_count());
    const std::size_t count = topology.group.size();
    rings.charge = {context.memory(),
                    count * (sizeof(dvec3) + 13 + 24) + input.triangle_count() * (sizeof(GroupFace) + 12 * 4ull),
                    "neighbors of vertices"};
    rings.faces = scratch.take<GroupFace>(input.triangle_count());
    rings.group_of_corner = scratch.take<std::uint32_t>(corners);
    rings.places = scratch.take<dvec3>(count);
    CornerBins memory;
    memory.corners = scratch.take<std::uint32_t>(corners);
    memory.begin = scratch.take_words();
    BlockArray<std::uint16_t> keys(std::move(scratch.keys));
    read_faces(rings, topology, input, known, context);
    read_places(rings, topology, input, context);
    rings.corners = bin_corners(topology, input, known, context, std::move(memory), &keys);
    scratch.keys = keys.take();
    return rings;
}

}  // namespace rakelight::geometry
