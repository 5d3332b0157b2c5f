// SPDX-License-Identifier: Apache-2.0
#include "geometry/borders/open_edges.h"

#include <algorithm>
#include <atomic>
#include <tuple>

#include "base/atomic_ref.h"
#include "base/hash_key.h"

namespace rakelight::geometry {
namespace {

/// An edge's use by a face.
struct Use {
    std::uint32_t low, high, corner;
};

/// Each face has directed edges between its places. Around an interior place every neighbor has one incoming and one
/// outgoing edge, so the signed sum of the neighbors' hashes is zero. At the end of an open edge one neighbor remains
/// (a sum is zero by chance with probability 2^-64).
class OpenEdges {
public:
    OpenEdges(const PlacedMeshes& placed, Context& context)
        : placed_(placed), context_(context), left_over_(placed.input.vertex_count(), 0) {}

    std::vector<std::uint32_t> find() {
        const std::vector<Chunk> chunks = make_chunks(placed_.input.triangle_base, triangles_per_chunk);
        context_.parallel_for(chunks.size(), [&](std::size_t c) { for_each_face(chunks[c], Summing{*this}); });
        std::vector<std::vector<Use>> found(chunks.size());
        context_.parallel_for(chunks.size(), [&](std::size_t c) {
            for_each_face(chunks[c], Listing{*this, found[c]});
        });
        std::uint64_t count = 0;
        for (const std::vector<Use>& f : found) count += f.size();
        context_.memory().check(2 * count * sizeof(Use), "finding open edges");
        std::vector<Use> uses;
        for (std::vector<Use>& f : found) {
            uses.insert(uses.end(), f.begin(), f.end());
            f = {};
        }
        return of_one_face(uses);
    }

private:
    std::uint64_t hash(std::uint32_t place) const { return folded_product(place + key_.a, key_.b | 1); }

    struct Summing {
        OpenEdges& edges;
        void operator()(std::uint32_t, const FacePlaces& face, double flip) const {
            const std::uint64_t h[] = {edges.hash(face.corner[0]), edges.hash(face.corner[1]),
                                       edges.hash(face.corner[2])};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint64_t next = h[(k + 1) % 3], previous = h[(k + 2) % 3];
                atomic_ref(edges.left_over_[face.corner[k]])
                    .fetch_add(flip < 0 ? previous - next : next - previous, std::memory_order_relaxed);
            }
        }
    };
    struct Listing {
        const OpenEdges& edges;
        std::vector<Use>& uses;
        void operator()(std::uint32_t triangle, const FacePlaces& face, double) const {
            for (std::uint32_t k = 0; k < 3; ++k) {
                const auto [low, high] = std::minmax(face.corner[k], face.corner[(k + 1) % 3]);
                if (edges.left_over_[low] != 0 && edges.left_over_[high] != 0)
                    uses.push_back({low, high, 3 * triangle + k});
            }
        }
    };

    template <class Body>
    void for_each_face(const Chunk& chunk, const Body& body) const {
        const AttributeInput& input = placed_.input;
        for_each_range(chunk, input.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            FacePlaces face;
            for (std::uint32_t t = input.triangle_base[m] + first; t != input.triangle_base[m] + last; ++t)
                if (face_places(placed_, m, t, face)) body(t, face, input.placements[m].flip);
        });
    }

    static std::vector<std::uint32_t> of_one_face(std::vector<Use>& uses) {
        std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
            return std::tie(a.low, a.high, a.corner) < std::tie(b.low, b.high, b.corner);
        });
        std::vector<std::uint32_t> corners;
        for (std::size_t i = 0; i < uses.size();) {
            std::size_t end = i + 1;
            while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
            if (end == i + 1) corners.push_back(uses[i].corner);
            i = end;
        }
        std::sort(corners.begin(), corners.end());
        return corners;
    }

    const PlacedMeshes& placed_;
    Context& context_;
    const HashKey key_ = hash_key_of_this_run();
    std::vector<std::uint64_t> left_over_;  ///< [places]
};

}  // namespace

std::vector<std::uint32_t> find_open_edges(const PlacedMeshes& placed, Context& context) {
    return OpenEdges(placed, context).find();
}

}  // namespace rakelight::geometry
