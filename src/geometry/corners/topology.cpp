// SPDX-License-Identifier: Apache-2.0
#include "geometry/corners/topology.h"

#include <numeric>

#include "geometry/input/face_vote.h"

namespace rakelight::geometry {

Topology copy_of(const Topology& topology, const AttributeInput& input) {
    Topology copy{.places = topology.places, .group = topology.group, .source = topology.source};
    if (topology.corner_vertex.empty()) return copy;
    const std::size_t corners = 3 * std::size_t(input.triangle_count());
    copy.corner_vertex.reserve(corners);
    std::copy_n(topology.corner_vertex.data(), corners, copy.corner_vertex.data());
    return copy;
}

void materialize_corners(Topology& topology, const AttributeInput& input, Context& context) {
    if (!topology.corner_vertex.empty()) return;
    topology.corner_vertex = BlockArray<std::uint32_t>(std::move(topology.spare));
    topology.corner_vertex.reserve(std::size_t(3) * input.triangle_count());
    const std::vector<Chunk> chunks = make_chunks(input.triangle_base, triangles_per_chunk);
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        for_each_range(chunks[c], input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const std::uint32_t base = 3 * input.triangle_base[m];
            for (std::uint32_t i = 3 * first; i != 3 * last; ++i)
                topology.corner_vertex[base + i] = input.vertex_base[m] + input.meshes[m].indices[i];
        });
    });
}

std::vector<std::uint32_t> rank_by_source(const std::vector<std::uint32_t>& sources, std::uint32_t count,
                                          GeneralScratch& scratch) {
    std::vector<std::uint32_t> at = scratch.take_words(), rank;
    at.assign(std::size_t(count) + 1, 0);
    for (const std::uint32_t v : sources) ++at[v + 1];
    std::partial_sum(at.begin(), at.end(), at.begin());
    rank.reserve(sources.size());
    for (const std::uint32_t v : sources) rank.push_back(at[v]++);
    scratch.give(at);
    return rank;
}

void sort_appended(Topology& topology, const AttributeInput& input, Context& context) {
    const std::uint32_t fixed = input.vertex_count();
    GeneralScratch none;
    const std::vector<std::uint32_t> number = rank_by_source(topology.source, fixed, none);
    std::vector<std::uint32_t> source(number.size()), group(topology.group.size());
    for (std::size_t i = 0; i < number.size(); ++i) source[number[i]] = topology.source[i];
    const auto renumbered = [&](std::uint32_t v) { return v < fixed ? v : fixed + number[v - fixed]; };
    const std::size_t vertices = group.size(), corners = 3 * std::size_t(input.triangle_count()),
                      step = 3 * triangles_per_chunk;
    context.parallel_for((vertices + step - 1) / step, [&](std::size_t c) {
        for (std::size_t v = c * step; v < std::min(vertices, (c + 1) * step); ++v)
            group[renumbered(std::uint32_t(v))] = renumbered(topology.group[v]);
    });
    context.parallel_for((corners + step - 1) / step, [&](std::size_t c) {
        for (std::size_t i = c * step; i < std::min(corners, (c + 1) * step); ++i)
            topology.corner_vertex[i] = renumbered(topology.corner_vertex[i]);
    });
    topology.group = std::move(group);
    topology.source = std::move(source);
}

CornerBins bin_corners(const Topology& topology, const AttributeInput& input, std::span<const std::uint8_t> selected,
                       Context& context, CornerBins bins, BlockArray<std::uint16_t>* keys) {
    BlockArray<std::uint16_t> own;
    CornerSort sort(input, std::uint32_t(topology.group.size()), std::move(bins), keys ? *keys : own, context);
    const std::uint32_t* const group = topology.group.data();
    if (selected.empty() && topology.corner_vertex.empty())
        return sort.run([&](std::uint32_t m) {
            return [group = group + input.vertex_base[m], indices = input.meshes[m].indices.data(),
                    base = 3 * input.triangle_base[m]](std::uint32_t corner) { return group[indices[corner - base]]; };
        });
    return sort.run([&](std::uint32_t m) {
        return [&, m](std::uint32_t corner) {
            const std::uint32_t g = group[topology.vertex_of(input, m, corner)];
            return selected.empty() || selected[g] != 0 ? g : CornerSort::no_bin;
        };
    });
}

FaceNormals face_normals(const AttributeInput& input, Context& context, FaceNormals normals) {
    normals.reserve(input.triangle_count());
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
