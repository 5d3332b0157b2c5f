// SPDX-License-Identifier: Apache-2.0
#include "geometry/groups/mirror_split.h"

#include <algorithm>
#include <atomic>

#include "base/atomic_ref.h"
#include "geometry/input/face_vote.h"

namespace rakelight::geometry {
namespace {

enum : std::uint8_t { right = 1, left = 2, both = 3 };

// Calls body(mesh, corner, hand) for each corner whose face has an area, in space and in the texture.
template <class Body>
void for_each_hand(const AttributeInput& input, bool keep_normals, const std::vector<Chunk>& chunks, Context& context,
                   const Body& body) {
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        for_each_range(chunks[c], input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const AttributeMesh& mesh = input.meshes[m];
            const Placement& placement = input.placements[m];
            if (mesh.texcoords.empty()) return;
            for (std::uint32_t t = first; t != last; ++t) {
                const std::uint32_t* index = &mesh.indices[3 * std::size_t(t)];
                const double hand = -texture_edges(mesh, index).sign * placement.flip;  // as in face_tangent()
                const FaceCorners face = face_corners(mesh, index);
                if (hand == 0 || cross(face.e1, face.e2) == dvec3{}) continue;
                const Direction normal = keep_normals ? face_normal(placement, face) : Direction{};
                for (std::uint32_t k = 0; k < 3; ++k) {
                    const double seen =
                        keep_normals ? handedness_from(given_normal(placement, mesh.normals[index[k]]), normal, hand)
                                     : hand;
                    body(m, 3 * (input.triangle_base[m] + t) + k, seen);
                }
            }
        });
    });
}

}  // namespace

void split_mirrored(Topology& topology, const AttributeInput& input, bool keep_normals, Context& context) {
    std::vector<std::uint8_t> hands(topology.group.size(), 0);
    const std::vector<Chunk> chunks = make_chunks(input.triangle_base, triangles_per_chunk);
    for_each_hand(input, keep_normals, chunks, context, [&](std::uint32_t m, std::uint32_t corner, double hand) {
        const atomic_ref<std::uint8_t> seen(hands[topology.vertex_of(input, m, corner)]);
        const std::uint8_t bit = hand > 0 ? right : left;
        if ((seen.load(std::memory_order_relaxed) & bit) == 0) seen.fetch_or(bit, std::memory_order_relaxed);
    });
    std::vector<std::uint32_t> mixed;
    for (std::uint32_t v = 0; v < hands.size(); ++v)
        if (hands[v] == both) mixed.push_back(v);
    if (mixed.empty()) return;

    materialize_corners(topology, input, context);
    const std::uint32_t first_new = std::uint32_t(topology.group.size());
    const bool is_sorted = topology.source.empty();  // then the new ones' sources ascend
    for (const std::uint32_t v : mixed) {
        topology.source.push_back(topology.source_of(input, v));
        topology.group.push_back(topology.group[v]);
    }
    for_each_hand(input, keep_normals, chunks, context, [&](std::uint32_t, std::uint32_t corner, double hand) {
        std::uint32_t& vertex = topology.corner_vertex[corner];
        if (hand > 0 || hands[vertex] != both) return;
        vertex = first_new + std::uint32_t(std::lower_bound(mixed.begin(), mixed.end(), vertex) - mixed.begin());
    });
    if (!is_sorted) sort_appended(topology, input, context);
}

}  // namespace rakelight::geometry
