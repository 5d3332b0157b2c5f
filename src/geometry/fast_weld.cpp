// SPDX-License-Identifier: Apache-2.0
#include "geometry/fast_weld.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "geometry/fast_classes.h"

namespace rakelight::geometry {
namespace {

constexpr std::uint32_t records_per_partition = 1u << 14;
constexpr std::uint32_t most_partitions = 1u << 12;
constexpr std::uint32_t empty = 0xffffffffu;

// Where the matrix is the identity, the bits of the float position; else those of the world position in double.
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
    std::uint64_t hash(std::uint64_t seed) const {
        std::uint64_t h = ((std::uint64_t(x) << 32 | y) ^ seed) * 0x9e3779b97f4a7c15ull;
        h = (h ^ (h >> 32) ^ z) * 0xbf58476d1ce4e5b9ull;
        return (h ^ (h >> 29)) * 0x94d049bb133111ebull;
    }
};
template <>
struct PlaceKey<false> {
    std::uint64_t x, y, z;
    bool operator==(const PlaceKey&) const = default;
    static PlaceKey of(const Placement& placement, vec3 p) {
        const dvec3 w = placement.position(p) + dvec3{};
        return {std::bit_cast<std::uint64_t>(w.x), std::bit_cast<std::uint64_t>(w.y), std::bit_cast<std::uint64_t>(w.z)};
    }
    bool is_finite() const {
        constexpr std::uint64_t exponent = 0x7ff0000000000000ull;
        return (x & exponent) != exponent && (y & exponent) != exponent && (z & exponent) != exponent;
    }
    std::uint64_t hash(std::uint64_t seed) const {
        std::uint64_t h = seed;
        for (const std::uint64_t bits : {x, y, z}) {
            h = (h ^ bits ^ (bits >> 32)) * 0x9e3779b97f4a7c15ull;
            h ^= h >> 29;
        }
        return h * 0xbf58476d1ce4e5b9ull;
    }
};

template <bool identity>
class FastWeld {
public:
    using Key = PlaceKey<identity>;
    explicit FastWeld(FastState& state)
        : state_(state), input_(state.input), chunks_(make_chunks(input_.vertex_base, vertices_per_chunk)) {
        const std::uint32_t wanted = std::bit_ceil(input_.vertex_count() / records_per_partition + 1);
        bits_ = std::uint32_t(std::bit_width(std::min(wanted, most_partitions)) - 1);
        partitions_ = 1u << bits_;
    }

    void run() {
        partition();
        for_each_in_lanes(state_, partitions_, [&](LaneScratch& lane, std::size_t p) { match(std::uint32_t(p), lane); });
    }

private:
    // A record is the low half of a hash (the partition is its high bits) and a vertex.
    static constexpr std::uint64_t record(std::uint64_t hash, std::uint32_t vertex) { return hash << 32 | vertex; }

    std::uint64_t seed(std::uint32_t mesh) const {
        return state_.options.scope == Scope::object ? input_.meshes[mesh].object * 0xd6e8feb86659fd93ull : 0;
    }

    // Calls body(vertex, hash).
    template <class Body>
    void for_each_place(std::size_t chunk, const Body& body) const {
        for_each_range(chunks_[chunk], input_.vertex_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const Placement placement = input_.placements[m];
            const vec3* positions = input_.meshes[m].positions.data();
            const std::uint64_t mesh_seed = seed(m);
            const std::uint32_t base = input_.vertex_base[m];
            for (std::uint32_t v = first; v != last; ++v) {
                const Key key = Key::of(placement, positions[v]);
                if (key.is_finite()) body(base + v, key.hash(mesh_seed));
            }
        });
    }

    void partition() {
        std::vector<std::uint32_t>& cursors = state_.scratch.cursors;
        cursors.resize(chunks_.size() * partitions_);
        const std::uint32_t bits = bits_, partitions = partitions_;
        const auto place = [bits](std::uint64_t hash) { return bits == 0 ? 0u : std::uint32_t(hash >> (64 - bits)); };
        for_each_in_lanes(state_, chunks_.size(), [&, place](LaneScratch& lane, std::size_t c) {
            lane.cursor.assign(partitions, 0);
            std::uint32_t* const counts = lane.cursor.data();
            for_each_place(c, [counts, place](std::uint32_t, std::uint64_t hash) { ++counts[place(hash)]; });
            std::memcpy(&cursors[c * partitions], counts, partitions * sizeof(std::uint32_t));
        });
        begin_.resize(partitions_ + 1);
        std::uint32_t sum = 0;
        for (std::uint32_t p = 0; p < partitions_; ++p) {
            begin_[p] = sum;
            for (std::size_t c = 0; c < chunks_.size(); ++c) {
                const std::uint32_t count = cursors[c * partitions_ + p];
                cursors[c * partitions_ + p] = sum;
                sum += count;
            }
        }
        begin_[partitions_] = sum;
        state_.scratch.records.reserve(sum);
        std::uint64_t* const records = state_.scratch.records.data();
        for_each_in_lanes(state_, chunks_.size(), [&, place, records](LaneScratch& lane, std::size_t c) {
            lane.cursor.assign(&cursors[c * partitions], &cursors[c * partitions] + partitions);
            std::uint32_t* const at = lane.cursor.data();
            for_each_place(c, [at, place, records](std::uint32_t vertex, std::uint64_t hash) {
                records[at[place(hash)]++] = record(hash, vertex);
            });
        });
    }

    bool are_one(std::uint32_t a, std::uint32_t b) const {
        const std::uint32_t m = input_.mesh_of_vertex(a), n = input_.mesh_of_vertex(b);
        if (state_.options.scope == Scope::object && input_.meshes[m].object != input_.meshes[n].object) return false;
        return Key::of(input_.placements[m], input_.meshes[m].positions[a - input_.vertex_base[m]]) ==
               Key::of(input_.placements[n], input_.meshes[n].positions[b - input_.vertex_base[n]]);
    }

    void match(std::uint32_t p, LaneScratch& lane) {
        const std::uint32_t count = begin_[p + 1] - begin_[p];
        const std::uint64_t* const records = state_.scratch.records.data() + begin_[p];
        const std::size_t slots = std::bit_ceil(std::size_t(count) * 2 + 1);
        const std::uint32_t mask = std::uint32_t(slots - 1);
        lane.table.reserve(slots);
        std::uint32_t* const table = lane.table.data();
        std::memset(table, 0xff, slots * sizeof(std::uint32_t));
        lane.duplicates.clear();
        for (std::uint32_t r = 0; r < count; ++r) {
            const std::uint64_t own = records[r];
            std::uint32_t slot = std::uint32_t(own >> 32) & mask;
            for (; table[slot] != empty; slot = (slot + 1) & mask) {
                const std::uint64_t other = records[table[slot]];
                if (((other ^ own) >> 32) != 0 || !are_one(std::uint32_t(other), std::uint32_t(own))) continue;
                lane.duplicates.push_back({std::uint32_t(other), std::uint32_t(own)});
                break;
            }
            if (table[slot] == empty) table[slot] = r;
        }
        if (!lane.duplicates.empty()) join_classes(state_, lane.duplicates);
    }

    FastState& state_;
    const AttributeInput& input_;
    std::vector<Chunk> chunks_;
    std::uint32_t bits_ = 0, partitions_ = 1;
    std::vector<std::uint32_t> begin_;
};

}  // namespace

void weld_rows(FastState& state) {
    const bool identity = std::all_of(state.input.meshes.begin(), state.input.meshes.end(),
                                      [](const AttributeMesh& m) { return m.to_world == dmat4{}; });
    if (identity) FastWeld<true>(state).run();
    else FastWeld<false>(state).run();
}

}  // namespace rakelight::geometry
