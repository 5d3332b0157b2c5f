// SPDX-License-Identifier: Apache-2.0
#include "geometry/fast/fast_stages.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace rakelight::geometry {
namespace {

constexpr std::uint32_t records_per_partition = 1u << 11, partitions_per_task = 8;
constexpr std::uint32_t max_partitions = 1u << 13;
constexpr std::uint32_t rounds_by_hash =
    4;  // afterwards different positions may share a hash, which is then recomputed

// For the identity matrix, the bits of the float position; else of the world position in double.
template <bool identity>
struct PlaceKey;
template <>
struct PlaceKey<true> {
    std::uint32_t x, y, z;
    bool operator==(const PlaceKey&) const = default;
    static PlaceKey of(const Placement&, vec3 p) {  // -0 + 0 is +0
        return {std::bit_cast<std::uint32_t>(p.x + 0.0f), std::bit_cast<std::uint32_t>(p.y + 0.0f),
                std::bit_cast<std::uint32_t>(p.z + 0.0f)};
    }
    bool is_finite() const {
        constexpr std::uint32_t exponent = 0x7f800000u;
        return (x & exponent) != exponent && (y & exponent) != exponent && (z & exponent) != exponent;
    }
};
template <>
struct PlaceKey<false> {
    std::uint64_t x, y, z;
    bool operator==(const PlaceKey&) const = default;
    static PlaceKey of(const Placement& placement, vec3 p) {
        const dvec3 w = placement.position(p) + dvec3{};
        return {std::bit_cast<std::uint64_t>(w.x), std::bit_cast<std::uint64_t>(w.y),
                std::bit_cast<std::uint64_t>(w.z)};
    }
    bool is_finite() const {
        constexpr std::uint64_t exponent = 0x7ff0000000000000ull;
        return (x & exponent) != exponent && (y & exponent) != exponent && (z & exponent) != exponent;
    }
};

template <class Key>
std::uint64_t hash(const Key& key, std::uint64_t seed) {
    std::uint64_t h = seed;
    for (const std::uint64_t bits : {std::uint64_t(key.x), std::uint64_t(key.y), std::uint64_t(key.z)}) {
        h = (h ^ bits ^ (bits >> 32)) * 0x9e3779b97f4a7c15ull;
        h ^= h >> 29;
    }
    return h * 0xbf58476d1ce4e5b9ull;
}

std::uint64_t seed(const FastState& state, std::uint32_t mesh) {
    return state.options.scope == Scope::object ? (state.input.meshes[mesh].object + 1) * 0xd6e8feb86659fd93ull : 0;
}

template <bool identity>
class FastWeld {
public:
    using Key = PlaceKey<identity>;
    explicit FastWeld(FastState& state) : state_(state), input_(state.input), partitions_(1u << state.partition_bits) {}

    void run() {
        place_partitions();
        partition();
        const std::size_t tasks = (partitions_ + partitions_per_task - 1) / partitions_per_task;
        std::vector<std::vector<Duplicate>>& classes = state_.scratch.classes;
        if (state_.looks) classes.resize(tasks);
        for_each_in_lanes(state_, tasks, [&](LaneScratch& lane, std::size_t t) {
            const std::uint32_t first = std::uint32_t(t) * partitions_per_task;
            lane.duplicates.clear();
            for (std::uint32_t p = first; p < std::min(partitions_, first + partitions_per_task); ++p) match(p, lane);
            if (!lane.duplicates.empty()) join_classes(state_, lane.duplicates);
            if (state_.looks) classes[t].assign(lane.duplicates.begin(), lane.duplicates.end());
        });
    }

private:
    // A record is the hash of a position (the partition is its high bits) and a vertex.
    static constexpr std::uint64_t record(std::uint32_t hash, std::uint32_t vertex) {
        return std::uint64_t(hash) << 32 | vertex;
    }
    static constexpr std::uint32_t hash_of(std::uint64_t record) { return std::uint32_t(record >> 32); }

    Key key(std::uint32_t mesh, std::uint32_t vertex) const {
        return Key::of(input_.placements[mesh], input_.meshes[mesh].positions[vertex - input_.vertex_base[mesh]]);
    }

    void fetch_position(std::uint32_t vertex) const {
        const std::uint32_t mesh = input_.mesh_of_vertex(vertex);
        __builtin_prefetch(input_.meshes[mesh].positions.data() + (vertex - input_.vertex_base[mesh]));
    }

    // Prefix sums: from the lanes' counts to their write positions in each partition.
    void place_partitions() {
        begin_.resize(partitions_ + 1);
        std::uint32_t sum = 0;
        for (std::uint32_t p = 0; p < partitions_; ++p) {
            begin_[p] = sum;
            for (LaneScratch& lane : state_.scratch.lanes)
                if (!lane.counts.empty()) sum += std::exchange(lane.counts[p], sum);
        }
        begin_[partitions_] = sum;
        state_.scratch.records.reserve(sum);
    }

    // Each lane writes the vertices that it hashed. The order of records in a partition depends on the threads, the
    // classes do not.
    void partition() {
        std::vector<LaneScratch>& lanes = state_.scratch.lanes;
        state_.context.parallel_for(lanes.size(), [&](std::size_t l) {
            for (const HashedRange& range : lanes[l].hashed) send(range, lanes[l].counts.data());
        });
    }

    void send(const HashedRange& range, std::uint32_t* cursors) const {
        const std::uint32_t* const hashes = state_.hashes(range.mesh);
        const std::uint32_t base = input_.vertex_base[range.mesh], bits = state_.partition_bits;
        std::uint64_t* const records = state_.scratch.records.data();
        for (std::uint32_t v = range.first; v != range.last; ++v)
            records[cursors[std::uint64_t(hashes[v]) << bits >> 32]++] = record(hashes[v], base + v);
    }

    // Every record writes its index to the slot of its hash; the first one stays. A record that finds another index
    // joins its class if the positions are equal. Else the slot belongs to a different position, and all records of its
    // position enter the next round with other slots.
    void match(std::uint32_t p, LaneScratch& lane) {
        const std::uint32_t count = begin_[p + 1] - begin_[p];
        const std::uint64_t* const records = state_.scratch.records.data() + begin_[p];
        const std::uint32_t slot_bits = std::uint32_t(std::bit_width(std::size_t(count) * 4 + 1));
        lane.table.reserve(std::size_t(1) << slot_bits);
        lane.left.reserve(count);
        std::uint32_t* const table = lane.table.data();
        std::uint32_t* const left = lane.left.data();
        const std::uint32_t shift = 64 - slot_bits;
        const auto slot = [records, shift](std::uint32_t r) {
            return std::uint64_t(hash_of(records[r])) * 0x9e3779b97f4a7c15ull >> shift;
        };
        for (std::uint32_t r = count; r-- > 0;) table[slot(r)] = r;
        std::uint32_t losers = 0;
        for (std::uint32_t r = 0; r < count; ++r) {
            __builtin_prefetch(records + count + r);  // of the next partition
            left[losers] = r;
            losers += table[slot(r)] != r ? 1 : 0;
        }
        losers = judge(records, lane, losers, [&](std::uint32_t r) { return table[slot(r)]; });
        for (std::uint32_t round = 1; losers != 0; ++round) losers = next_round(records, lane, losers, shift, round);
    }

    std::uint32_t next_round(const std::uint64_t* records, LaneScratch& lane, std::uint32_t losers, std::uint32_t shift,
                             std::uint32_t round) {
        std::uint32_t* const table = lane.table.data();
        const std::uint64_t factor = 0xa0761d6478bd642full + 2 * round;
        const auto slot = [&, factor](std::uint32_t r) {
            if (round < rounds_by_hash) return hash_of(records[r]) * factor >> shift;
            const std::uint32_t vertex = std::uint32_t(records[r]), mesh = input_.mesh_of_vertex(vertex);
            return hash(key(mesh, vertex), seed(state_, mesh) + factor) >> shift;
        };
        for (std::uint32_t i = losers; i-- > 0;) table[slot(lane.left[i])] = lane.left[i];
        return judge(records, lane, losers, [&](std::uint32_t r) { return table[slot(r)]; });
    }

    // Keeps those of the first `losers` entries of `left` whose slot has a different position. Returns their count.
    template <class Winner>
    std::uint32_t judge(const std::uint64_t* records, LaneScratch& lane, std::uint32_t losers,
                        const Winner& winner) const {
        for (std::uint32_t i = 0; i < losers; ++i) {
            const std::uint32_t r = lane.left[i], w = winner(r);
            if (hash_of(records[w]) != hash_of(records[r])) continue;
            fetch_position(std::uint32_t(records[w]));
            fetch_position(std::uint32_t(records[r]));
        }
        std::uint32_t strangers = 0;
        for (std::uint32_t i = 0; i < losers; ++i) {
            const std::uint32_t r = lane.left[i], w = winner(r);
            if (w == r) continue;
            if (hash_of(records[w]) != hash_of(records[r])) {
                lane.left[strangers++] = r;
                continue;
            }
            const std::uint32_t a = std::uint32_t(records[w]), b = std::uint32_t(records[r]);
            const std::uint32_t m = input_.mesh_of_vertex(a), n = input_.mesh_of_vertex(b);
            const Key place = key(n, b);
            if (!place.is_finite()) continue;
            const bool is_one_scope =
                state_.options.scope == Scope::model || input_.meshes[m].object == input_.meshes[n].object;
            if (is_one_scope && key(m, a) == place)
                lane.duplicates.push_back({a, b});
            else
                lane.left[strangers++] = r;
        }
        return strangers;
    }

    FastState& state_;
    const AttributeInput& input_;
    std::uint32_t partitions_;
    std::vector<std::uint32_t> begin_;
};

}  // namespace

std::uint32_t weld_partition_bits(std::uint32_t vertices) {
    return std::uint32_t(std::bit_width(std::min(std::bit_ceil(vertices / records_per_partition + 1), max_partitions)) -
                         1);
}

void hash_places(const FastState& state, LaneScratch& lane, std::uint32_t mesh, std::uint32_t first,
                 std::uint32_t last) {
    if (first >= last) return;
    const vec3* const positions = state.input.meshes[mesh].positions.data();
    std::uint32_t* const hashes = state.hashes(mesh);
    const std::uint64_t mesh_seed = seed(state, mesh);
    if (state.is_identity) {
        state.weld_kernels.hash(&positions[first].x, last - first, std::uint32_t(mesh_seed >> 32), hashes + first);
    } else {
        const Placement& placement = state.input.placements[mesh];
        for (std::uint32_t v = first; v != last; ++v)
            hashes[v] = std::uint32_t(hash(PlaceKey<false>::of(placement, positions[v]), mesh_seed) >> 32);
    }
    lane.hashed.push_back({mesh, first, last});
    if (lane.counts.empty()) lane.counts.assign(std::size_t(1) << state.partition_bits, 0);
    std::uint32_t* const counts = lane.counts.data();
    for (std::uint32_t v = first; v != last; ++v) ++counts[std::uint64_t(hashes[v]) << state.partition_bits >> 32];
}

void weld_rows(FastState& state) {
    if (state.is_identity)
        FastWeld<true>(state).run();
    else
        FastWeld<false>(state).run();
}

}  // namespace rakelight::geometry
