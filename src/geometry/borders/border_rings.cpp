// SPDX-License-Identifier: Apache-2.0
#include "geometry/borders/border_rings.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/corners/corner_bins.h"
#include "geometry/fits/fit_trust.h"
#include "geometry/fits/two_rings.h"
#include "geometry/groups/authored_normals.h"
#include "geometry/input/face_vote.h"

namespace rakelight::geometry {
namespace {

constexpr std::size_t nodes_per_chunk = 64;
constexpr std::uint32_t none = 0xffffffffu;

// In rings. These four were chosen by the errors of tests/unit/geometry/borders/border_fits_test.cpp.
constexpr double reach = 2.6, link_cost = 0.5;
constexpr double least_distance = 0.1;  // nearer neighbors say more of rounding than of the surface
constexpr double spacing = 0.3;         // of two neighbors, as a share of their distance from the node
constexpr std::size_t most_visited = 2048;

/// The surface around a node as its coarsest mesh has it.
struct Scale {
    double area = 0;                ///< [m2] mean of twice the area of a face; 0: nothing is known
    dvec3 at, t, b, n;              ///< position and axes
    double tt = 0, tb = 0, bb = 0;  ///< inverse of the covariance of the edges: where they are long, rings are wide
    /// [rings^2]
    double square(dvec3 d) const {
        const double x = dot(d, t), y = dot(d, b);
        return tt * x * x + 2 * tb * x * y + bb * y * y;
    }
};

/// Sums over the faces of one mesh at a node.
struct EdgeSums {
    double area = 0, xx = 0, xy = 0, yy = 0;
    int faces = 0;

    void replace_if_coarser(Scale& scale) const {
        const double mean = 1 / std::max(2.0 * faces, 1.0), a = xx * mean, b = xy * mean, c = yy * mean,
                     det = a * c - b * b;
        if (!(area * 2 * mean > scale.area) || !(det > 1e-12 * (a + c) * (a + c))) return;
        scale.area = area * 2 * mean;
        scale.tt = c / det, scale.tb = -b / det, scale.bb = a / det;
    }
};

class RingFinder {
public:
    RingFinder(const PlacedMeshes& placed, const BorderNodes& nodes, std::span<const BorderLink> links,
               Context& context)
        : placed_(placed), nodes_(nodes), context_(context), index_(nodes), corners_(corners_by_place()) {
        for (const BorderLink& link : links)
            for (const std::uint32_t end : {link.counts_a() ? link.node_a : none, link.counts_b() ? link.node_b : none})
                if (end != none) linked_.push_back({link.node, end}), linked_.push_back({end, link.node});
        std::sort(linked_.begin(), linked_.end());
    }

    BorderRings run(std::vector<std::uint32_t> wanted) const {
        const std::size_t chunks = (wanted.size() + nodes_per_chunk - 1) / nodes_per_chunk;
        std::vector<std::vector<std::uint32_t>> found(chunks);
        BorderRings out{.node = std::move(wanted), .begin = {}, .neighbors = {}};
        std::vector<std::uint64_t> ends(out.node.size() + 1, 0);
        context_.parallel_for(chunks, [&](std::size_t c) {
            Walk walk;
            const std::size_t last = std::min(out.node.size(), (c + 1) * nodes_per_chunk);
            for (std::size_t i = c * nodes_per_chunk; i < last; ++i) {
                const std::size_t before = found[c].size();
                surround(out.node[i], walk, found[c]);
                ends[i + 1] = found[c].size() - before;
            }
        });
        for (std::size_t i = 0; i < out.node.size(); ++i) ends[i + 1] += ends[i];
        context_.memory().check(4 * (ends.back() + ends.size()), "neighbors of borders");
        if (ends.back() > 0xffffffffu) return {};  // nothing is fitted
        out.begin.assign(ends.begin(), ends.end());
        out.neighbors.reserve(ends.back());
        for (const std::vector<std::uint32_t>& f : found) out.neighbors.insert(out.neighbors.end(), f.begin(), f.end());
        return out;
    }

private:
    using Linked = std::pair<std::uint32_t, std::uint32_t>;
    struct Step {
        double cost;  ///< [rings] from the node
        std::uint32_t vertex;
        bool operator<(const Step& other) const {  // the cheapest is on top of the heap
            return std::tie(cost, vertex) > std::tie(other.cost, other.vertex);
        }
    };
    struct Near {
        double distance;  ///< [rings]
        dvec3 position;
        std::uint32_t vertex;
        auto key() const { return std::tie(distance, position.x, position.y, position.z, vertex); }
    };
    /// Memory of one thread.
    struct Walk {
        std::vector<Step> heap;
        std::vector<std::uint32_t> visited;  ///< vertices, ascending
        std::vector<Near> found;
        std::vector<dvec3> kept;
    };

    CornerBins corners_by_place() const {
        const AttributeInput& input = placed_.input;
        context_.memory().check(4ull * input.vertex_count() + 18ull * input.triangle_count(), "neighbors of borders");
        BlockArray<std::uint16_t> scratch;
        return CornerSort(input, input.vertex_count(), {}, scratch, context_).run([&](std::uint32_t m) {
            return [&, m](std::uint32_t corner) {
                FacePlaces face;
                const bool is_face = face_places(placed_, m, corner / 3, face);
                return is_face ? face.corner[corner % 3] : CornerSort::no_bin;
            };
        });
    }

    dvec3 normal_of(std::uint32_t vertex) const {
        const std::uint32_t m = placed_.input.mesh_of_vertex(vertex);
        return given_normal(placed_.input.placements[m],
                            placed_.input.meshes[m].normals[vertex - placed_.input.vertex_base[m]]);
    }
    /// Of a corner's face, `steps` corners on.
    std::uint32_t vertex_at(std::uint32_t m, std::uint32_t corner, std::uint32_t steps) const {
        return placed_.input.corner_vertex(m, corner - corner % 3 + (corner + steps) % 3);
    }
    /// From a corner to the next two of its face.
    std::pair<dvec3, dvec3> edges_at(std::uint32_t m, std::uint32_t corner) const {
        const dvec3 at = placed_.position(vertex_at(m, corner, 0));
        return {placed_.position(vertex_at(m, corner, 1)) - at, placed_.position(vertex_at(m, corner, 2)) - at};
    }

    Scale scale_of(std::uint32_t node) const {
        Scale out;
        out.n = nodes_.normals[node];
        out.t = normalize_or(cross(out.n, std::fabs(out.n.x) < 0.8 ? dvec3{1, 0, 0} : dvec3{0, 1, 0}), {0, 0, 1});
        out.b = cross(out.n, out.t);
        out.at = placed_.position(nodes_.members[nodes_.member_begin[node]]);
        EdgeSums sums;
        std::uint32_t mesh = none;
        for (std::uint32_t i = nodes_.member_begin[node]; i < nodes_.member_begin[node + 1]; ++i) {
            const std::uint32_t m = placed_.input.mesh_of_vertex(nodes_.members[i]);
            if (m != mesh) sums.replace_if_coarser(out), sums = {}, mesh = m;
            for (const std::uint32_t corner : nodes_.corners_of(i)) {
                const auto [e1, e2] = edges_at(m, corner);
                sums.area += length(cross(e1, e2)), ++sums.faces;
                for (const dvec3 e : {e1, e2}) {
                    const double x = dot(e, out.t), y = dot(e, out.b);
                    sums.xx += x * x, sums.xy += x * y, sums.yy += y * y;
                }
            }
        }
        sums.replace_if_coarser(out);
        return out;
    }

    void surround(std::uint32_t node, Walk& walk, std::vector<std::uint32_t>& out) const {
        walk.heap.clear(), walk.visited.clear(), walk.found.clear(), walk.kept.clear();
        const Scale scale = scale_of(node);
        if (!(scale.area > 0)) return;
        reach_node(node, 0, walk);
        while (!walk.heap.empty() && walk.visited.size() < most_visited) {
            std::pop_heap(walk.heap.begin(), walk.heap.end());
            const Step step = walk.heap.back();
            walk.heap.pop_back();
            const auto to = std::lower_bound(walk.visited.begin(), walk.visited.end(), step.vertex);
            if (to != walk.visited.end() && *to == step.vertex) continue;
            walk.visited.insert(to, step.vertex);
            step_from(step, scale, walk);
        }
        std::sort(walk.found.begin(), walk.found.end(), [](const Near& a, const Near& b) { return a.key() < b.key(); });
        thin_out(scale, walk, out);
    }

    void reach_node(std::uint32_t node, double cost, Walk& walk) const {
        for (const std::uint32_t v : nodes_.members_of(node)) reach_vertex(v, cost, walk);
    }
    static void reach_vertex(std::uint32_t vertex, double cost, Walk& walk) {
        if (!(cost <= reach)) return;
        walk.heap.push_back({cost, vertex});
        std::push_heap(walk.heap.begin(), walk.heap.end());
    }

    /// Over the faces at a vertex and at those that share its place and normal, and over links.
    void step_from(const Step& step, const Scale& scale, Walk& walk) const {
        const dvec3 position = placed_.position(step.vertex), normal = normal_of(step.vertex);
        const double square = scale.square(position - scale.at);
        if (!(square < 1e100) || !(dot(normal, scale.n) > least_cosine_around)) return;
        walk.found.push_back({std::sqrt(std::max(square, 0.0)), position, step.vertex});
        const std::span<const std::uint32_t> corners = corners_[placed_.place[step.vertex]];
        const bool is_widened = step.cost == 0 || corners.size() <= most_to_widen;
        for (const std::uint32_t corner : is_widened ? corners : std::span<const std::uint32_t>{}) {
            const std::uint32_t m = placed_.input.mesh_of_triangle(corner / 3), own = vertex_at(m, corner, 0);
            if (own != step.vertex && !are_one_normal(normal_of(own), normal)) continue;
            const auto [e1, e2] = edges_at(m, corner);
            const double size = std::sqrt(std::sqrt(length(cross(e1, e2)) / scale.area));
            for (const std::uint32_t steps : {1u, 2u})
                reach_vertex(vertex_at(m, corner, steps), step.cost + std::min(1.0, size), walk);
        }
        const std::uint32_t member = index_.member_of(step.vertex);
        if (member == BorderNodes::no_node) return;
        const std::uint32_t node = index_.node_of_member(member);
        for (auto l = std::lower_bound(linked_.begin(), linked_.end(), Linked{node, 0});
             l != linked_.end() && l->first == node; ++l)
            reach_node(l->second, step.cost + link_cost, walk);
    }

    static void thin_out(const Scale& scale, Walk& walk, std::vector<std::uint32_t>& out) {
        for (const Near& near : walk.found) {
            if (near.distance < least_distance) continue;
            const double apart = spacing * near.distance;
            const bool is_free = std::none_of(walk.kept.begin(), walk.kept.end(), [&](dvec3 other) {
                return scale.square(near.position - other) < apart * apart;
            });
            if (!is_free) continue;
            walk.kept.push_back(near.position);
            out.push_back(near.vertex);
        }
    }

    const PlacedMeshes& placed_;
    const BorderNodes& nodes_;
    Context& context_;
    const MemberIndex index_;
    const CornerBins corners_;    ///< [places]
    std::vector<Linked> linked_;  ///< nodes, both ways, ascending
};

}  // namespace

BorderRings border_rings(const PlacedMeshes& placed, const BorderNodes& nodes, std::span<const BorderLink> links,
                         Context& context) {
    std::vector<std::uint8_t> is_wanted(nodes.count(), 0);
    for (const BorderLink& link : links) {
        if (link.counts_a()) is_wanted[link.node_a] = 1;
        if (link.counts_b()) is_wanted[link.node_b] = 1;
    }
    for (const BorderLink& link : links) is_wanted[link.node] = 0;
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t node = 0; node < nodes.count(); ++node)
        if (is_wanted[node] != 0) wanted.push_back(node);
    if (wanted.empty()) return {};
    return RingFinder(placed, nodes, links, context).run(std::move(wanted));
}

}  // namespace rakelight::geometry
