// SPDX-License-Identifier: Apache-2.0
#include "geometry/topology.h"

#include <atomic>
#include <numeric>

#include "geometry/face_vote.h"

namespace rakelight::geometry {

void materialize_corners(Topology& topology, const AttributeInput& input, Context& context) {
    if (!topology.corner_vertex.empty()) return;
    topology.corner_vertex.resize(std::size_t(3) * input.triangle_count());
    const std::vector<Chunk> chunks = make_chunks(input.triangle_base, triangles_per_chunk);
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        for_each_range(chunks[c], input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const std::uint32_t base = 3 * input.triangle_base[m];
            for (std::uint32_t i = 3 * first; i != 3 * last; ++i)
                topology.corner_vertex[base + i] = input.vertex_base[m] + input.meshes[m].indices[i];
        });
    });
}

void sort_appended(Topology& topology, const AttributeInput& input, Context& context) {
    const std::uint32_t fixed = input.vertex_count();
    const std::size_t count = topology.source.size();
    std::vector<std::uint32_t> order(count), number(count), group = topology.group;
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return topology.source[a] < topology.source[b]; });
    std::vector<std::uint32_t> source(count);
    for (std::size_t i = 0; i < count; ++i) {
        number[order[i]] = std::uint32_t(i);
        source[i] = topology.source[order[i]];
    }
    const auto renumbered = [&](std::uint32_t v) { return v < fixed ? v : fixed + number[v - fixed]; };
    for (std::uint32_t v = 0; v < topology.group.size(); ++v) group[renumbered(v)] = renumbered(topology.group[v]);
    topology.group = std::move(group);
    topology.source = std::move(source);
    const std::size_t corners = topology.corner_vertex.size(), step = 3 * triangles_per_chunk;
    context.parallel_for((corners + step - 1) / step, [&](std::size_t c) {
        for (std::size_t i = c * step; i < std::min(corners, (c + 1) * step); ++i)
            topology.corner_vertex[i] = renumbered(topology.corner_vertex[i]);
    });
}

// Counting sort. Integer counts may be added in any order; the order inside a bin is restored by sorting it.
CornerBins bin_corners(const Topology& topology, const AttributeInput& input, const std::vector<std::uint8_t>& selected,
                       Context& context) {
    CornerBins bins;
    bins.begin.assign(topology.group.size() + 1, 0);
    const std::vector<Chunk> chunks = make_chunks(input.triangle_base, triangles_per_chunk);
    const auto for_each_corner = [&](const auto& body) {
        context.parallel_for(chunks.size(), [&](std::size_t c) {
            for_each_range(chunks[c], input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
                const std::uint32_t base = 3 * input.triangle_base[m];
                for (std::uint32_t corner = base + 3 * first; corner != base + 3 * last; ++corner) {
                    const std::uint32_t g = topology.group[topology.vertex_of(input, m, corner)];
                    if (selected.empty() || selected[g] != 0) body(corner, g);
                }
            });
        });
    };
    for_each_corner([&](std::uint32_t, std::uint32_t g) {
        std::atomic_ref(bins.begin[g + 1]).fetch_add(1, std::memory_order_relaxed);
    });
    std::partial_sum(bins.begin.begin(), bins.begin.end(), bins.begin.begin());
    bins.corners.resize(bins.begin.back());
    std::vector<std::uint32_t> cursor(bins.begin.begin(), bins.begin.end() - 1);
    for_each_corner([&](std::uint32_t corner, std::uint32_t g) {
        bins.corners[std::atomic_ref(cursor[g]).fetch_add(1, std::memory_order_relaxed)] = corner;
    });
    const std::size_t count = topology.group.size(), step = vertices_per_chunk;
    context.parallel_for((count + step - 1) / step, [&](std::size_t c) {
        for (std::size_t g = c * step; g < std::min(count, (c + 1) * step); ++g)
            std::sort(bins.corners.begin() + bins.begin[g], bins.corners.begin() + bins.begin[g + 1]);
    });
    return bins;
}

std::vector<dvec3> face_normals(const AttributeInput& input, Context& context) {
    std::vector<dvec3> normals(input.triangle_count());
    const std::vector<Chunk> chunks = make_chunks(input.triangle_base, triangles_per_chunk);
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        for_each_range(chunks[c], input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const AttributeMesh& mesh = input.meshes[m];
            for (std::uint32_t t = first; t != last; ++t)
                normals[input.triangle_base[m] + t] =
                    face_normal(input.placements[m], face_corners(mesh, &mesh.indices[3 * std::size_t(t)])).unit;
        });
    });
    return normals;
}

}  // namespace rakelight::geometry
