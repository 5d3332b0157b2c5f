// SPDX-License-Identifier: Apache-2.0
#include "geometry/fast/fast_stages.h"

#include "base/atomic_ref.h"

namespace rakelight::geometry {
namespace {

void finish_range(FastState& state, const AttributeBuffers& out, std::uint32_t m, std::uint32_t first,
                  std::uint32_t last, bool keeps_normals, LaneScratch& lane, std::vector<std::uint32_t>& odd) {
    if (first == last) return;
    lane.odd.resize(odd_capacity);
    const std::uint32_t base = state.input.vertex_base[m];
    FinishJob job;
    job.rows = state.row(base);
    job.begin = first;
    job.end = last;
    job.normals = &out.normals[0].x;
    job.tangents = state.is_textured(m) ? &out.tangents[0].x : nullptr;
    job.keeps_normals = keeps_normals;
    job.weak_tangent = keeps_normals ? weak_tangent_after_fit : state.weak_tangent();
    job.odd = lane.odd.data();
    while (job.begin != job.end) {
        job.odd_count = 0;
        (state.tangents ? state.kernels.finish_tangents : state.kernels.finish_normals)(&job);
        for (std::uint32_t i = 0; i < job.odd_count; ++i) odd.push_back(base + job.odd[i]);
    }
    if (job.isolated != 0 && !keeps_normals)
        atomic_ref(state.isolated[m]).fetch_add(job.isolated, std::memory_order_relaxed);
}

std::vector<std::uint32_t> finish(FastState& state, bool keeps_normals) {
    const std::vector<Chunk> chunks = make_chunks(state.input.vertex_base, vertices_per_chunk);
    std::vector<std::vector<std::uint32_t>> odd(chunks.size());
    for_each_in_lanes(state, chunks.size(), [&](LaneScratch& lane, std::size_t c) {
        for_each_range(chunks[c], state.input.vertex_base,
                       [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
                           finish_range(state, state.out[m], m, first, last, keeps_normals, lane, odd[c]);
                       });
    });
    std::vector<std::uint32_t> all;
    for (const auto& part : odd) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace

std::vector<std::uint32_t> finish_rows(FastState& state) { return finish(state, false); }

// Where the sum of tangents is weak across the new normal, the tangent is some vector across it. The places left to the
// general path are replaced later.
void finish_tangents(FastState& state) { finish(state, true); }

}  // namespace rakelight::geometry
