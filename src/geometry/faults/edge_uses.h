// SPDX-License-Identifier: Apache-2.0
// Edges between places, each with its faces.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/cancel_check.h"
#include "geometry/faults/place_classes.h"

namespace rakelight::geometry {

/// A use of an edge by a face; the edge starts at `corner`.
struct EdgeUse {
    std::uint32_t larger;  ///< of the edge's two places
    std::uint32_t corner;
};

/// Uses of edges, binned by the smaller place and sorted inside each bin (about six uses). Skips faces without three
/// different places (face_places()). 8 bytes per corner; expected O(n).
class EdgeUses {
public:
    EdgeUses(const PlacedMeshes& placed, const Context& context) : placed_(placed), check_cancel_(context) {
        begin_.assign(std::size_t(placed.input.vertex_count()) + 2, 0);
        for_each_use([&](std::uint32_t low, EdgeUse) { ++begin_[low + 2]; });
        for (std::size_t i = 2; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
        uses_.resize(begin_.back());
        for_each_use([&](std::uint32_t low, EdgeUse use) { uses_[begin_[low + 1]++] = use; });
        begin_.pop_back();
    }

    /// Calls visit(smaller place, uses of one edge) in the order of the smaller place, then of the larger; uses in the
    /// order of their corners. Call it once.
    template <class Visit>
    void for_each_edge(const Visit& visit) {
        for (std::uint32_t place = 0; place + 1 < begin_.size(); ++place) {
            check_cancel_();
            const std::span<EdgeUse> bin(uses_.data() + begin_[place], begin_[place + 1] - begin_[place]);
            std::sort(bin.begin(), bin.end(), [](const EdgeUse& a, const EdgeUse& b) {
                return a.larger != b.larger ? a.larger < b.larger : a.corner < b.corner;
            });
            for (std::size_t i = 0; i < bin.size();) {
                std::size_t end = i + 1;
                while (end < bin.size() && bin[end].larger == bin[i].larger) ++end;
                visit(place, std::span<const EdgeUse>(bin.subspan(i, end - i)));
                i = end;
            }
        }
    }

    /// Whether the face uses the edge from the smaller place to the larger, counter-clockwise seen from outside in
    /// world space, also for mirroring placements.
    bool goes_up(std::uint32_t smaller, EdgeUse use) const {
        const std::uint32_t m = placed_.input.mesh_of_triangle(use.corner / 3);
        const bool is_first = placed_.place[placed_.input.corner_vertex(m, use.corner)] == smaller;
        return is_first != (placed_.input.placements[m].flip < 0);
    }

private:
    template <class Body>
    void for_each_use(const Body& body) {
        const AttributeInput& input = placed_.input;
        FacePlaces face;
        for (std::uint32_t m = 0; m < input.meshes.size(); ++m)
            for (std::uint32_t t = input.triangle_base[m]; t < input.triangle_base[m + 1]; ++t) {
                check_cancel_();
                if (!face_places(placed_, m, t, face)) continue;
                for (std::uint32_t k = 0; k < 3; ++k) {
                    const auto [low, high] = std::minmax(face.corner[k], face.corner[(k + 1) % 3]);
                    body(low, EdgeUse{high, 3 * t + k});
                }
            }
    }

    const PlacedMeshes& placed_;
    CancelCheck check_cancel_;
    std::vector<std::uint32_t> begin_;
    std::vector<EdgeUse> uses_;
};

}  // namespace rakelight::geometry
