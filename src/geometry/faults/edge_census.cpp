// SPDX-License-Identifier: Apache-2.0
#include "geometry/faults/edge_census.h"

#include <algorithm>
#include <span>
#include <tuple>

#include "geometry/faults/edge_uses.h"

namespace rakelight::geometry {
namespace {

/// The uses of one edge inside one object.
struct Count {
    std::uint64_t faces = 0, upwards = 0;  ///< upwards: from the smaller place to the larger
    bool is_inconsistent() const { return faces == 2 && upwards != 1; }
};

class Census {
public:
    Census(const PlacedMeshes& placed, std::uint32_t objects, const Context& context)
        : placed_(placed), edges_(placed, context) {
        result_.objects.resize(objects);
    }

    EdgeCensus run() {
        edges_.for_each_edge([&](std::uint32_t place, std::span<const EdgeUse> uses) { visit_edge(place, uses); });
        count_borders();
        return std::move(result_);
    }

private:
    void visit_edge(std::uint32_t place, std::span<const EdgeUse> uses) {
        if (uses.size() == 1) result_.open_corners.push_back(uses[0].corner);
        by_object_.clear();
        Count whole;
        const std::uint32_t first_mesh = placed_.input.mesh_of_triangle(uses[0].corner / 3);
        bool is_border = false;
        for (const EdgeUse use : uses) {
            const bool up = edges_.goes_up(place, use);
            const std::uint32_t mesh = placed_.input.mesh_of_triangle(use.corner / 3);
            is_border = is_border || mesh != first_mesh;
            by_object_.emplace_back(placed_.input.meshes[mesh].object, up);
            ++whole.faces;
            whole.upwards += up;
        }
        if (is_border) result_.border_edges.push_back({place, uses[0].larger});
        std::sort(by_object_.begin(), by_object_.end());
        if (by_object_.front().first != by_object_.back().first && whole.is_inconsistent())
            result_.inconsistent_borders.push_back({by_object_[0].first, by_object_[1].first, 1});
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

    /// From one entry per edge to one per pair.
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
    EdgeUses edges_;
    EdgeCensus result_;
    std::vector<std::pair<std::uint32_t, bool>> by_object_;
};

}  // namespace

EdgeCensus count_edges(const PlacedMeshes& placed, std::uint32_t objects, const Context& context) {
    return Census(placed, objects, context).run();
}

}  // namespace rakelight::geometry
