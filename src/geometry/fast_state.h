// SPDX-License-Identifier: Apache-2.0
// What the stages of the fast path share, and the scratch that they use again from call to call.
#pragma once
#include <atomic>
#include <cstdint>
#include <vector>

#include "geometry/attribute_input.h"
#include "geometry/fast_kernel_types.h"
#include "geometry/fast_memory.h"

namespace rakelight::geometry {

/// Some vertices share a place: `rep` is the smallest of them.
struct Duplicate {
    std::uint32_t rep, vertex;
};

/// Scratch of one worker at a time.
struct LaneScratch {
    LargeArray<std::uint32_t> table;  ///< hash table of one partition
    std::vector<Duplicate> duplicates;
    std::vector<std::uint32_t> cursor;
    std::vector<std::byte> parcels;
    std::vector<std::uint32_t> odd;
};

/// The vertices that some consecutive faces of a mesh use lie in first..last.
struct VertexRange {
    std::uint32_t first = 0xffffffffu, last = 0;
};
constexpr std::uint32_t faces_per_range = 2048;

struct FastScratch {
    LargeArray<float> rows;               ///< [vertices][floats]
    LargeArray<std::uint64_t> records;    ///< [vertices] of the weld
    std::vector<std::uint32_t> cursors;   ///< of the weld, [chunks][partitions]
    std::vector<std::vector<std::byte>> outbox;  ///< [chunks of a wave][pieces] parcels
    std::vector<VertexRange> ranges;      ///< [meshes][faces / faces_per_range, rounded up]
    std::vector<std::size_t> range_base;  ///< [meshes + 1]
    std::vector<LaneScratch> lanes;
    std::size_t bytes() const;
};

/// One call. All meshes have one matrix, a similarity, so that everything is summed in object space.
struct FastState {
    const AttributeInput& input;
    const AttributeOptions& options;
    FastScratch& scratch;
    const FastKernels& kernels;
    Context& context;
    bool tangents;                          ///< rows of 8 floats; some mesh has texture coordinates and tangents are asked for
    std::vector<std::uint32_t> degenerate;  ///< [meshes]
    std::vector<std::uint32_t> isolated;    ///< [meshes]

    int floats() const { return tangents ? tangent_row_floats : normal_row_floats; }
    bool is_textured(std::uint32_t mesh) const { return tangents && !input.meshes[mesh].texcoords.empty(); }
    float* row(std::uint32_t vertex) const { return scratch.rows.data() + std::size_t(vertex) * std::size_t(floats()); }
};

/// Calls body(lane, i) for i in 0..count-1; a lane is used by one thread at a time, so its scratch needs no lock.
template <class Body>
void for_each_in_lanes(FastState& state, std::size_t count, const Body& body) {
    const std::size_t lanes = std::min(count, std::size_t(state.context.threads()));
    if (state.scratch.lanes.size() < lanes) state.scratch.lanes.resize(lanes);
    std::atomic<std::size_t> next{0};
    LaneScratch* const scratch = state.scratch.lanes.data();
    state.context.parallel_for(lanes, [&](std::size_t lane) {
        for (std::size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) body(scratch[lane], i);
    });
}

}  // namespace rakelight::geometry
