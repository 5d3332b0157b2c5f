// SPDX-License-Identifier: Apache-2.0
// One radix partition by hash, then a hash table per partition that stays in the cache. Records are stable, so the
// first vertex of a place is the smallest. Positions are recomputed and compared only if hashes agree.
#include "geometry/weld/position_weld.h"

#include <atomic>
#include <bit>
#include <cmath>
#include <numeric>

#include "geometry/input/face_vote.h"
#include "geometry/input/position_hash.h"

namespace rakelight::geometry {
namespace {

struct Record {
    std::uint32_t hash, vertex;
};

struct Place {
    dvec3 position;
    vec3 normal;
    std::uint32_t object = 0;
    bool operator==(const Place&) const = default;
};

constexpr std::uint32_t records_per_partition = 1u << 14;
constexpr std::uint32_t max_partitions = 1u << 12;
constexpr std::uint32_t empty = 0xffffffffu;

// Canonical zero: -0 + 0 is +0.
Place place_of(const AttributeInput& input, WeldKey key, std::uint32_t mesh, std::uint32_t vertex) {
    const AttributeMesh& m = input.meshes[mesh];
    Place place;
    place.position = input.placements[mesh].position(m.positions[vertex]) + dvec3{};
    if (key.object) place.object = m.object;
    if (key.normal && !m.normals.empty())
        place.normal = cast<float>(given_normal(input.placements[mesh], m.normals[vertex])) + vec3{};
    return place;
}

// Both the high bits (partition) and the low ones (table) depend on every coordinate.
std::uint32_t hash_of(const Place& place, HashKey key) {
    std::uint64_t h =
        hash_of_bits({std::bit_cast<std::uint64_t>(place.position.x), std::bit_cast<std::uint64_t>(place.position.y),
                      std::bit_cast<std::uint64_t>(place.position.z)},
                     place.object, key);
    if (place.normal != vec3{})
        h = hash_of_bits({std::bit_cast<std::uint32_t>(place.normal.x), std::bit_cast<std::uint32_t>(place.normal.y),
                          std::bit_cast<std::uint32_t>(place.normal.z)},
                         h, key);
    return std::uint32_t(h ^ (h >> 32));
}

class Weld {
public:
    Weld(const AttributeInput& input, WeldKey key, GeneralScratch& scratch, Context& context)
        : input_(input),
          key_(key),
          context_(context),
          scratch_(scratch),
          chunks_(make_chunks(input.vertex_base, vertices_per_chunk)) {
        const std::uint32_t wanted = input.vertex_count() / records_per_partition + 1;
        shift_ = 32 - std::uint32_t(std::bit_width(std::min(std::bit_ceil(wanted), max_partitions)) - 1);
        partitions_ = 1u << (32 - shift_);
    }

    std::vector<std::uint32_t> run(std::uint64_t* met) {
        partition();
        std::vector<std::uint32_t> representative = scratch_.take_words();
        representative.resize(input_.vertex_count());
        context_.parallel_for(chunks_.size(), [&](std::size_t c) {
            for_each_range(chunks_[c], input_.vertex_base,
                           [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
                               const auto begin = representative.begin() + input_.vertex_base[m];
                               std::iota(begin + first, begin + last, input_.vertex_base[m] + first);
                           });
        });
        std::atomic<std::uint64_t> all_met{0};
        context_.parallel_for(partitions_, [&](std::size_t p) { all_met += match(std::uint32_t(p), representative); });
        if (met) *met = all_met;
        scratch_.give(records_);
        return representative;
    }

private:
    std::uint32_t partition_of(std::uint32_t hash) const { return partitions_ == 1 ? 0 : hash >> shift_; }

    // Calls body(vertex) for each vertex of a chunk.
    template <class Body>
    void for_each_vertex(std::size_t chunk, const Body& body) const {
        for_each_range(chunks_[chunk], input_.vertex_base,
                       [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
                           for (std::uint32_t v = first; v != last; ++v) body(m, input_.vertex_base[m] + v);
                       });
    }
    // 0: not a place; partition and slot are taken from different ends of the rest.
    std::uint32_t hash_at(std::uint32_t m, std::uint32_t vertex) const {
        const Place place = place_of(input_, key_, m, vertex - input_.vertex_base[m]);
        return is_finite(place.position) ? std::max(1u, hash_of(place, hash_key_)) : 0;
    }

    void partition() {
        std::vector<std::uint32_t> cursor(chunks_.size() * partitions_, 0);
        BlockArray<std::uint32_t> hashes = scratch_.take<std::uint32_t>(input_.vertex_count());
        context_.parallel_for(chunks_.size(), [&](std::size_t c) {
            std::vector<std::uint32_t> counts(partitions_, 0);
            std::uint32_t* const hash = hashes.data();
            for_each_vertex(c, [&](std::uint32_t m, std::uint32_t v) {
                hash[v] = hash_at(m, v);
                if (hash[v] != 0) ++counts[partition_of(hash[v])];
            });
            std::copy(counts.begin(), counts.end(), cursor.begin() + std::ptrdiff_t(c * partitions_));
        });
        begin_.resize(partitions_ + 1);
        std::uint32_t sum = 0;
        for (std::uint32_t p = 0; p < partitions_; ++p) {
            begin_[p] = sum;
            for (std::size_t c = 0; c < chunks_.size(); ++c) {
                const std::uint32_t count = cursor[c * partitions_ + p];
                cursor[c * partitions_ + p] = sum;
                sum += count;
            }
        }
        begin_[partitions_] = sum;
        records_ = scratch_.take<Record>(sum);
        context_.parallel_for(chunks_.size(), [&](std::size_t c) {
            std::vector<std::uint32_t> at(cursor.begin() + std::ptrdiff_t(c * partitions_),
                                          cursor.begin() + std::ptrdiff_t((c + 1) * partitions_));
            Record* records = records_.data();
            const std::uint32_t* const hash = hashes.data();
            for_each_vertex(c, [&](std::uint32_t, std::uint32_t v) {
                if (hash[v] != 0) records[at[partition_of(hash[v])]++] = {hash[v], v};
            });
        });
        scratch_.give(hashes);
    }

    Place place_again(std::uint32_t vertex) const {
        const std::uint32_t m = input_.mesh_of_vertex(vertex);
        return place_of(input_, key_, m, vertex - input_.vertex_base[m]);
    }

    // @return number of visited full slots
    std::uint64_t match(std::uint32_t p, std::vector<std::uint32_t>& representative) const {
        std::uint64_t met = 0;
        const std::uint32_t begin = begin_[p], end = begin_[p + 1];
        const std::uint32_t mask = std::uint32_t(std::bit_ceil(std::uint64_t(end - begin) * 2 + 1) - 1);
        std::vector<std::uint32_t> table(std::size_t(mask) + 1, empty);
        for (std::uint32_t r = begin; r != end; ++r) {
            const Record record = records_[r];
            std::uint32_t slot = record.hash & mask;
            for (; table[slot] != empty; slot = (slot + 1) & mask) {
                ++met;
                const Record other = records_[table[slot]];
                if (other.hash != record.hash || !(place_again(other.vertex) == place_again(record.vertex))) continue;
                representative[record.vertex] = other.vertex;
                break;
            }
            if (table[slot] == empty) table[slot] = r;
        }
        return met;
    }

    const AttributeInput& input_;
    WeldKey key_;
    HashKey hash_key_ = hash_key_of_this_run();
    Context& context_;
    GeneralScratch& scratch_;
    std::vector<Chunk> chunks_;
    std::uint32_t shift_ = 32, partitions_ = 1;
    std::vector<std::uint32_t> begin_;
    BlockArray<Record> records_;
};

}  // namespace

std::vector<std::uint32_t> weld_positions(const AttributeInput& input, WeldKey key, Context& context,
                                          std::uint64_t* met, GeneralScratch* scratch) {
    GeneralScratch own;
    return Weld(input, key, scratch ? *scratch : own, context).run(met);
}

}  // namespace rakelight::geometry
