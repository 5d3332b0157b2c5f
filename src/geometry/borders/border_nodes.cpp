// SPDX-License-Identifier: Apache-2.0
#include "geometry/borders/border_nodes.h"

#include <algorithm>
#include <tuple>

#include "base/cancel_check.h"
#include "geometry/corners/corner_bins.h"
#include "geometry/groups/authored_normals.h"
#include "geometry/input/face_vote.h"
#include "geometry/input/union_find.h"

namespace rakelight::geometry {
namespace {

constexpr std::size_t few_normals = 64;  // limit at one place for pairwise comparison

/// The corners of all faces at the ends of open edges, by place.
CornerBins corners_at_borders(const PlacedMeshes& placed, std::span<const std::uint32_t> open_corners,
                              Context& context) {
    const AttributeInput& input = placed.input;
    std::vector<std::uint8_t> is_border(input.vertex_count(), 0);
    for (const std::uint32_t corner : open_corners) {
        const std::uint32_t m = input.mesh_of_triangle(corner / 3), next = corner % 3 == 2 ? corner - 2 : corner + 1;
        for (const std::uint32_t c : {corner, next}) is_border[placed.place[input.corner_vertex(m, c)]] = 1;
    }
    BlockArray<std::uint16_t> scratch;
    return CornerSort(input, input.vertex_count(), {}, scratch, context).run([&](std::uint32_t m) {
        return [&, m](std::uint32_t corner) {
            const std::uint32_t place = placed.place[input.corner_vertex(m, corner)];
            return is_border[place] != 0 ? place : CornerSort::no_bin;
        };
    });
}

class NodeFinder {
public:
    NodeFinder(const PlacedMeshes& placed, Context& context) : placed_(placed), check_(context) {}

    BorderNodes run(const CornerBins& bins) {
        nodes_.member_begin = nodes_.corner_begin = {0};
        for (std::uint32_t place = 0; place < placed_.input.vertex_count(); ++place) {
            check_();
            if (bins.size(place) > 0) visit(place, bins[place]);
        }
        return std::move(nodes_);
    }

private:
    struct Use {
        std::uint32_t vertex, corner;
    };
    struct Vertex {
        std::uint32_t vertex;
        std::size_t first_use, last_use;
        dvec3 normal;
    };

    void visit(std::uint32_t place, std::span<const std::uint32_t> corners) {
        gather(corners);
        join_equal();
        for (std::size_t i = 0; i < order_.size();) {
            const std::uint32_t root = sets_.root(order_[i]);
            nodes_.place.push_back(place);
            nodes_.normals.push_back(vertices_[root].normal);
            for (; i < order_.size() && sets_.root(order_[i]) == root; ++i) add_member(vertices_[order_[i]]);
            nodes_.member_begin.push_back(std::uint32_t(nodes_.members.size()));
        }
    }

    /// The vertices at a place, ascending, each with its corners.
    void gather(std::span<const std::uint32_t> corners) {
        uses_.clear(), vertices_.clear();
        std::uint32_t m = 0;
        for (const std::uint32_t corner : corners) {
            if (uses_.empty() || corner >= 3 * placed_.input.triangle_base[m + 1])
                m = placed_.input.mesh_of_triangle(corner / 3);
            uses_.push_back({placed_.input.corner_vertex(m, corner), corner});
        }
        std::sort(uses_.begin(), uses_.end(), [](const Use& a, const Use& b) {
            return std::tie(a.vertex, a.corner) < std::tie(b.vertex, b.corner);
        });
        for (std::size_t i = 0; i < uses_.size();) {
            std::size_t end = i + 1;
            while (end < uses_.size() && uses_[end].vertex == uses_[i].vertex) ++end;
            const std::uint32_t v = uses_[i].vertex, mesh = placed_.input.mesh_of_vertex(v);
            const dvec3 normal = given_normal(placed_.input.placements[mesh],
                                              placed_.input.meshes[mesh].normals[v - placed_.input.vertex_base[mesh]]);
            if (normal != dvec3{}) vertices_.push_back({v, i, end, normal});
            i = end;
        }
    }

    /// Sorts `order_` by the vertices' sets.
    void join_equal() {
        const std::size_t count = vertices_.size();
        sets_.reset(count);
        order_.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) order_[i] = i;
        const auto key = [&](std::uint32_t i) {
            const dvec3 n = vertices_[i].normal;
            return std::tuple(n.x, n.y, n.z, i);
        };
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
        leads_.clear();
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0 && vertices_[order_[i]].normal == vertices_[order_[i - 1]].normal)
                sets_.join(order_[i], order_[i - 1]);
            else
                leads_.push_back(order_[i]);
        }
        for (std::size_t a = 0; a < leads_.size() && leads_.size() <= few_normals; ++a)
            for (std::size_t b = a + 1; b < leads_.size(); ++b)
                if (are_one_normal(vertices_[leads_[a]].normal, vertices_[leads_[b]].normal))
                    sets_.join(leads_[a], leads_[b]);
        std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(sets_.root(a), a) < std::pair(sets_.root(b), b);
        });
    }

    void add_member(const Vertex& vertex) {
        nodes_.members.push_back(vertex.vertex);
        for (std::size_t i = vertex.first_use; i < vertex.last_use; ++i) nodes_.corners.push_back(uses_[i].corner);
        nodes_.corner_begin.push_back(std::uint32_t(nodes_.corners.size()));
    }

    const PlacedMeshes& placed_;
    CancelCheck check_;
    BorderNodes nodes_;
    std::vector<Use> uses_;
    std::vector<Vertex> vertices_;
    std::vector<std::uint32_t> order_, leads_;  ///< of the vertices at one place
    UnionFind sets_;
};

}  // namespace

BorderNodes find_border_nodes(const PlacedMeshes& placed, std::span<const std::uint32_t> open_corners,
                              Context& context) {
    return NodeFinder(placed, context).run(corners_at_borders(placed, open_corners, context));
}

MemberIndex::MemberIndex(const BorderNodes& nodes) : node_(nodes.members.size()) {
    for (std::uint32_t node = 0; node < nodes.count(); ++node)
        for (std::uint32_t i = nodes.member_begin[node]; i < nodes.member_begin[node + 1]; ++i) {
            entries_.push_back({nodes.members[i], i});
            node_[i] = node;
        }
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) { return a.vertex < b.vertex; });
}

std::uint32_t MemberIndex::member_of(std::uint32_t vertex) const {
    const auto at = std::lower_bound(entries_.begin(), entries_.end(), vertex,
                                     [](const Entry& e, std::uint32_t v) { return e.vertex < v; });
    return at != entries_.end() && at->vertex == vertex ? at->member : BorderNodes::no_node;
}

}  // namespace rakelight::geometry
