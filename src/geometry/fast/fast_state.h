// SPDX-License-Identifier: Apache-2.0
// Shared state of the fast path's stages, and scratch memory reused by later calls.
#pragma once
#include <atomic>
#include <cstdint>
#include <vector>

#include "geometry/fast/fast_kernel_types.h"
#include "geometry/fast/fast_weld_types.h"
#include "geometry/input/attribute_input.h"
#include "geometry/input/block_array.h"
#include "geometry/input/fast_memory.h"

namespace rakelight::geometry {

/// Two vertices at one place. All vertices of a place have the same winner.
struct Duplicate {
    std::uint32_t winner, vertex;
};

/// Vertices first .. last - 1 of a mesh.
struct HashedRange {
    std::uint32_t mesh, first, last;
};

/// Scratch of one worker at a time.
struct LaneScratch {
    std::vector<HashedRange> hashed;        ///< by this lane, for the weld
    std::vector<std::uint32_t> counts;      ///< [partitions] [partitions] counts, or empty; later write positions
    LargeArray<std::uint32_t> table, left;  ///< of one partition of the weld
    std::vector<Duplicate> duplicates;
    std::vector<std::byte> parcels;
    std::vector<std::uint32_t> odd;
};

/// The vertices of some consecutive faces of a mesh are in first..last.
struct VertexRange {
    std::uint32_t first = 0xffffffffu, last = 0;
};
constexpr std::uint32_t faces_per_range = 2048;

struct FastScratch {
    LargeArray<float> rows;                       ///< [vertices][floats]
    LargeArray<LookRow> looks;                    ///< [vertices] where tangents are made after the looks
    LargeArray<std::uint64_t> records;            ///< [vertices] of the weld
    std::vector<std::vector<std::byte>> outbox;   ///< [chunks of a wave][pieces] parcels
    std::vector<std::vector<Duplicate>> classes;  ///< [tasks of the weld] sorted, whole classes; where they are kept
    std::vector<VertexRange> ranges;              ///< [meshes][faces / faces_per_range, rounded up]
    std::vector<std::size_t> range_base;          ///< [meshes + 1]
    std::vector<LaneScratch> lanes;
    GeneralScratch general;  ///< for places that are left to the general path
    std::size_t bytes() const;
};

/// One call. All meshes have one matrix, a similarity, so that everything is summed in object space.
struct FastState {
    const AttributeInput& input;
    const AttributeOptions& options;
    std::span<const AttributeBuffers> out;  ///< until the sums are finished, normals hold the hashes of the weld
    bool is_identity;                       ///< the matrix
    std::uint32_t partition_bits;           ///< of the weld: 2^bits partitions
    FastScratch& scratch;
    const FastKernels& kernels;
    const WeldKernels& weld_kernels;
    const LookKernels& look_kernels;
    Context& context;
    bool tangents;      ///< rows of 8 floats; some mesh has texture coordinates and tangents are asked for
    double crease_rad;  ///< of all meshes
    bool fits;          ///< normals are fitted after they are summed
    bool looks;         ///< whether the faces at a place are joined, and how they bend, is to be looked at
    std::vector<std::uint32_t> degenerate;  ///< [meshes]
    std::vector<std::uint32_t> isolated;    ///< [meshes]

    /// Share of a sum across the normal below which the general path makes the tangent.
    float weak_tangent() const { return fits ? weak_tangent_before_fit : weak_tangent_share; }
    int floats() const { return tangents ? tangent_row_floats : normal_row_floats; }
    bool is_textured(std::uint32_t mesh) const { return tangents && !input.meshes[mesh].texcoords.empty(); }
    std::uint32_t* hashes(std::uint32_t mesh) const {
        return reinterpret_cast<std::uint32_t*>(out[mesh].normals.data());
    }
    /// After scatter_looks().
    LookRow* looks_at() const {
        return fits && tangents ? scratch.looks.data() : reinterpret_cast<LookRow*>(scratch.rows.data());
    }
    float* row(std::uint32_t vertex) const { return scratch.rows.data() + std::size_t(vertex) * std::size_t(floats()); }
};

/// Calls body(lane, i) for i in 0..count-1; a lane is used by one thread at a time and needs no lock.
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
