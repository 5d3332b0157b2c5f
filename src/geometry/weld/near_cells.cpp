// SPDX-License-Identifier: Apache-2.0
#include "geometry/weld/near_cells.h"

#include <rakelight/base/error.h>

namespace rakelight::geometry {
namespace {

constexpr double cell_width = 4;           // in distances
constexpr double half = 0.5 * (1 + 1e-6);  // of the distance; more than enough for the rounding of the grid
constexpr std::uint32_t vertices_per_partition = 4096;  // tables of this size stay in the nearest cache
constexpr std::uint32_t max_partitions = 4096;

struct Sent {
    std::uint64_t hash;
    std::uint32_t vertex;
};

class Grid {
public:
    Grid(dvec3 origin, double distance)
        : origin_(origin), margin_(half / cell_width), per_meter_(1 / (distance * cell_width)) {}

    /// Calls body(hash) for the cells that a place enters: 1, 2, 4 or 8.
    template <class Body>
    void for_each_cell(dvec3 p, const Body& body) const {
        std::uint64_t low[3], high[3];
        for (std::size_t a = 0; a < 3; ++a) {
            const double at = (p[a] - origin_[a]) * per_meter_, below = at - margin_;
            low[a] = below > 0 ? std::uint64_t(below) : 0;
            high[a] = std::uint64_t(at + margin_);
        }
        for (std::uint64_t x = low[0]; x <= high[0]; ++x)
            for (std::uint64_t y = low[1]; y <= high[1]; ++y)
                for (std::uint64_t z = low[2]; z <= high[2]; ++z) {
                    std::uint64_t h = (x * 0x9e3779b97f4a7c15ull ^ y) * 0xbf58476d1ce4e5b9ull;
                    h = ((h ^ (h >> 31)) + z) * 0x94d049bb133111ebull;
                    body(h ^ (h >> 29));
                }
    }

private:
    dvec3 origin_;
    double margin_, per_meter_;
};

}  // namespace

NearCells::NearCells(const std::vector<std::uint32_t>& representative, const AttributeInput& input, dvec3 origin,
                     double distance, Context& context) {
    const std::uint32_t wanted = std::bit_ceil(input.vertex_count() / vertices_per_partition + 1);
    partitions_ = std::min(wanted, max_partitions);
    shift_ = 64 - std::uint32_t(std::bit_width(partitions_) - 1);
    const Grid grid(origin, distance);
    const std::vector<Chunk> chunks = make_chunks(input.vertex_base, vertices_per_chunk);
    std::vector<std::vector<Sent>> sent(chunks.size());
    std::vector<std::uint32_t> cursor(chunks.size() * partitions_, 0);
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        std::vector<std::uint32_t> counts(partitions_, 0);
        std::size_t vertices = 0;
        for_each_range(chunks[c], input.vertex_base,
                       [&](std::uint32_t, std::uint32_t first, std::uint32_t last) { vertices += last - first; });
        sent[c].reserve(vertices * 9 / 4);  // once: a chunk may have thousands of small meshes
        for_each_range(chunks[c], input.vertex_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t v = first; v != last; ++v) {
                const std::uint32_t vertex = input.vertex_base[m] + v;
                if (representative[vertex] != vertex) continue;
                const dvec3 p = input.placements[m].position(input.meshes[m].positions[v]);
                if (!is_finite(p)) continue;
                grid.for_each_cell(p, [&](std::uint64_t hash) {
                    sent[c].push_back({hash, vertex});
                    ++counts[partition_of(hash)];
                });
            }
        });
        std::copy(counts.begin(), counts.end(), cursor.begin() + std::ptrdiff_t(c * partitions_));
    });
    begin_.resize(std::size_t(partitions_) + 1);
    std::uint64_t sum = 0;
    for (std::uint32_t p = 0; p < partitions_; ++p) {
        begin_[p] = std::uint32_t(sum);
        for (std::size_t c = 0; c < chunks.size(); ++c) {
            const std::uint32_t count = cursor[c * partitions_ + p];
            cursor[c * partitions_ + p] = std::uint32_t(sum);
            sum += count;
        }
        if (sum >= nobody) throw Error(ErrorCode::bad_file, "too many vertices to be welded within a distance");
    }
    begin_[partitions_] = std::uint32_t(sum);
    entries_.reserve(std::size_t(sum));
    context.parallel_for(chunks.size(), [&](std::size_t c) {
        std::uint32_t* at = cursor.data() + c * partitions_;
        for (const Sent& s : sent[c]) entries_[at[partition_of(s.hash)]++] = {std::uint32_t(s.hash), s.vertex};
    });
}

}  // namespace rakelight::geometry
