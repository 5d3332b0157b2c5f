// SPDX-License-Identifier: Apache-2.0
// Edges are binned by their smaller place and sorted inside a bin, which holds about six.
#include "geometry/edge_census.h"

#include <algorithm>
#include <span>
#include <tuple>

namespace rakelight::geometry {
namespace {

/// A use of an edge by a face: it begins at `corner`; the smaller place is the bin's.
struct Use {
    std::uint32_t larger, corner;
};

/// The uses of one edge inside one object.
struct Count {
    std::uint64_t faces = 0, upwards = 0;  ///< upwards: from the smaller place to the larger
    bool is_inconsistent() const { return faces == 2 && upwards != 1; }
};

class Census {
public:
    Census(const PlacedMeshes& placed, std::uint32_t objects) : placed_(placed) { result_.objects.resize(objects); }

    EdgeCensus run() {
        bin_uses();
        for (std::uint32_t place = 0; place + 1 < begin_.size(); ++place) {
            const std::span<Use> bin(uses_.data() + begin_[place], begin_[place + 1] - begin_[place]);
            std::sort(bin.begin(), bin.end(), [](const Use& a, const Use& b) {
                return a.larger != b.larger ? a.larger < b.larger : a.corner < b.corner;
            });
            for (std::size_t i = 0; i < bin.size();) {
                std::size_t end = i + 1;
                while (end < bin.size() && bin[end].larger == bin[i].larger) ++end;
                visit_edge(place, bin.subspan(i, end - i));
                i = end;
            }
        }
        count_borders();
        return std::move(result_);
    }

private:
    template <class Body>
    void for_each_use(const Body& body) const {
        const AttributeInput& input = placed_.input;
        FacePlaces face;
        for (std::uint32_t m = 0; m < input.meshes.size(); ++m)
            for (std::uint32_t t = input.triangle_base[m]; t < input.triangle_base[m + 1]; ++t) {
                if (!face_places(placed_, m, t, face)) continue;
                for (std::uint32_t k = 0; k < 3; ++k) {
                    const auto [low, high] = std::minmax(face.corner[k], face.corner[(k + 1) % 3]);
                    body(low, Use{high, 3 * t + k});
                }
            }
    }

    void bin_uses() {
        begin_.assign(std::size_t(placed_.input.vertex_count()) + 2, 0);
        for_each_use([&](std::uint32_t low, Use) { ++begin_[low + 2]; });
        for (std::size_t i = 2; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
        uses_.resize(begin_.back());
        for_each_use([&](std::uint32_t low, Use use) { uses_[begin_[low + 1]++] = use; });
        begin_.pop_back();
    }

    /// Seen from outside: where the matrix mirrors, faces are used from their other side, and so run the other way.
    bool goes_up(std::uint32_t place, Use use) const {
        const std::uint32_t m = placed_.input.mesh_of_triangle(use.corner / 3);
        const bool is_mirrored = placed_.input.placements[m].flip < 0;
        return (placed_.place[placed_.input.corner_vertex(m, use.corner)] == place) != is_mirrored;
    }

    void visit_edge(std::uint32_t place, std::span<const Use> uses) {
        if (uses.size() == 1) result_.open_corners.push_back(uses[0].corner);
        by_object_.clear();
        Count whole;
        for (const Use use : uses) {
            const bool up = goes_up(place, use);
            by_object_.emplace_back(placed_.object_of_triangle(use.corner / 3), up);
            ++whole.faces;
            whole.upwards += up;
        }
        std::sort(by_object_.begin(), by_object_.end());
        if (by_object_.front().first != by_object_.back().first) {
            result_.border_edges.push_back({place, uses[0].larger});
            if (whole.is_inconsistent())
                result_.inconsistent_borders.push_back({by_object_[0].first, by_object_[1].first, 1});
        }
        for (std::size_t i = 0; i < by_object_.size();) {
            const std::uint32_t object = by_object_[i].first;
            Count count;
            for (; i < by_object_.size() && by_object_[i].first == object; ++i) {
                ++count.faces;
                count.upwards += by_object_[i].second;
            }
            add(result_.objects[object], count);
        }
    }

    /// One entry an edge -> one a pair.
    void count_borders() {
        std::vector<InconsistentBorder>& borders = result_.inconsistent_borders;
        std::sort(borders.begin(), borders.end(), [](const InconsistentBorder& x, const InconsistentBorder& y) {
            return std::tie(x.object_a, x.object_b) < std::tie(y.object_a, y.object_b);
        });
        std::size_t pairs = 0;
        for (const InconsistentBorder& edge : borders) {
            const bool is_known = pairs > 0 && borders[pairs - 1].object_a == edge.object_a &&
                                  borders[pairs - 1].object_b == edge.object_b;
            if (is_known)
                ++borders[pairs - 1].edges;
            else
                borders[pairs++] = {edge.object_a, edge.object_b, 1};
        }
        borders.resize(pairs);
    }

    static void add(ObjectEdges& edges, const Count& count) {
        ++edges.edges;
        edges.open += count.faces == 1;
        edges.inconsistent += count.is_inconsistent();
        edges.non_manifold += count.faces > 2;
    }

    const PlacedMeshes& placed_;
    EdgeCensus result_;
    std::vector<std::uint32_t> begin_;
    std::vector<Use> uses_;
    std::vector<std::pair<std::uint32_t, bool>> by_object_;
};

}  // namespace

EdgeCensus count_edges(const PlacedMeshes& placed, std::uint32_t objects) { return Census(placed, objects).run(); }

}  // namespace rakelight::geometry
