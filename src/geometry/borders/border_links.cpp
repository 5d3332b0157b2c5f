// SPDX-License-Identifier: Apache-2.0
#include "geometry/borders/border_links.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <tuple>

#include "geometry/groups/authored_normals.h"
#include "geometry/input/union_find.h"

namespace rakelight::geometry {
namespace {

constexpr std::uint32_t nothing = 0xffffffffu;
constexpr std::size_t sides_per_chunk = 1024;

/// A side: a node on the border of one mesh.
struct Side {
    std::uint32_t node, mesh;
    std::uint32_t first_use, last_use;  ///< of edges
};

/// An edge at one of its ends.
struct EdgeEnd {
    std::uint32_t node, mesh, edge;
    bool is_a;
};

/// A side and the nearest point of one other mesh.
struct Match {
    std::uint32_t side, mesh, other;
    BorderHit hit;
};

/// Number of matches of each of the two meshes along one stretch, and the length of edges with two matching ends.
struct Stretch {
    std::uint32_t low_mesh = 0, high_mesh = 0, low = 0, high = 0;
    double low_length = 0, high_length = 0;  ///< [m]
    std::uint32_t of(std::uint32_t mesh) const { return mesh == low_mesh ? low : high; }
};

class Linker {
public:
    Linker(const BorderSearch& search, const AttributeInput& input, const BorderNodes& nodes, double distance,
           Context& context)
        : search_(search),
          edges_(search.edges()),
          input_(input),
          nodes_(nodes),
          index_(nodes),
          distance_(distance),
          context_(context) {}

    BorderLinks run() {
        find_sides();
        find_matches();
        find_stretches();
        choose_links();
        drop_doubles();
        find_depths();
        std::vector<BorderLink>& links = result_.links;
        std::erase_if(links, [](const BorderLink& l) { return l.depth == 0; });
        std::sort(links.begin(), links.end(), [](const BorderLink& a, const BorderLink& b) {
            return std::tie(a.depth, a.node) < std::tie(b.depth, b.node);
        });
        return std::move(result_);
    }

private:
    std::uint32_t member(std::uint32_t vertex) const { return index_.member_of(vertex); }
    std::uint32_t node_of(std::uint32_t vertex) const { return index_.node_of_member(member(vertex)); }

    void find_sides() {
        ends_.reserve(2 * edges_.size());
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            ends_.push_back({node_of(edges_[e].vertex_a), edges_[e].mesh, e, true});
            ends_.push_back({node_of(edges_[e].vertex_b), edges_[e].mesh, e, false});
        }
        std::sort(ends_.begin(), ends_.end(), [](const EdgeEnd& x, const EdgeEnd& y) {
            return std::tie(x.node, x.mesh, x.edge, x.is_a) < std::tie(y.node, y.mesh, y.edge, y.is_a);
        });
        side_at_.resize(2 * edges_.size());
        for (std::uint32_t i = 0; i < ends_.size();) {
            Side side{ends_[i].node, ends_[i].mesh, i, i};
            for (; i < ends_.size() && ends_[i].node == side.node && ends_[i].mesh == side.mesh; ++i)
                side_at_[2 * ends_[i].edge + (ends_[i].is_a ? 0 : 1)] = std::uint32_t(sides_.size());
            side.last_use = i;
            sides_.push_back(side);
        }
    }

    /// For each side the best point of each other mesh, over all edges that end there.
    void find_matches() {
        const std::size_t chunks = (sides_.size() + sides_per_chunk - 1) / sides_per_chunk;
        std::vector<std::vector<Match>> found(chunks);
        std::atomic<std::uint64_t> given_up{0};
        context_.parallel_for(chunks, [&](std::size_t c) {
            const std::size_t last = std::min(sides_.size(), (c + 1) * sides_per_chunk);
            for (std::size_t s = c * sides_per_chunk; s < last; ++s)
                given_up.fetch_add(match_side(std::uint32_t(s), found[c]) ? 1 : 0, std::memory_order_relaxed);
        });
        std::uint64_t count = 0;
        for (const std::vector<Match>& f : found) count += f.size();
        context_.memory().check(count * (2 * sizeof(Match) + sizeof(Stretch) + 12), "matching open borders");
        for (const std::vector<Match>& f : found) matches_.insert(matches_.end(), f.begin(), f.end());
        result_.vertices_not_searched = given_up;
    }

    /// Appends in the order of the other meshes.
    /// @return a search was cut off
    bool match_side(std::uint32_t number, std::vector<Match>& out) const {
        const Side& side = sides_[number];
        const std::size_t first = out.size();
        bool given_up = false;
        BorderHits hits;
        for (std::uint32_t i = side.first_use; i < side.last_use; ++i) {
            const BorderEdge& edge = edges_[ends_[i].edge];
            search_.find(edge, ends_[i].is_a ? edge.a : edge.b, nodes_.normals[side.node], distance_, hits);
            given_up = given_up || hits.gave_up;
            for (const BorderHit& hit : hits.all()) keep_best({number, side.mesh, hit.mesh, hit}, first, out);
        }
        std::sort(out.begin() + std::ptrdiff_t(first), out.end(),
                  [](const Match& a, const Match& b) { return a.other < b.other; });
        return given_up;
    }

    static void keep_best(const Match& match, std::size_t first, std::vector<Match>& out) {
        const auto known = std::find_if(out.begin() + std::ptrdiff_t(first), out.end(),
                                        [&](const Match& m) { return m.other == match.other; });
        if (known == out.end())
            out.push_back(match);
        else if (std::tie(match.hit.rank, match.hit.edge) < std::tie(known->hit.rank, known->hit.edge))
            *known = match;
    }

    std::uint32_t match_of(std::uint32_t side, std::uint32_t other) const {
        const auto at =
            std::lower_bound(matches_.begin(), matches_.end(), std::pair(side, other),
                             [](const Match& m, const auto& key) { return std::pair(m.side, m.other) < key; });
        return at != matches_.end() && at->side == side && at->other == other ? std::uint32_t(at - matches_.begin())
                                                                              : nothing;
    }

    /// Neighboring matches with one mesh form a stretch, as do matches of two sides that face each other.
    void find_stretches() {
        sets_.reset(matches_.size());
        const auto join = [&](std::uint32_t a, std::uint32_t b) {
            if (b != nothing) sets_.join(a, b);
        };
        for (std::uint32_t i = 0; i < matches_.size(); ++i) {
            const Match& m = matches_[i];
            for (std::uint32_t end = 0; end < 2; ++end) join(i, match_of(side_at_[2 * m.hit.edge + end], m.mesh));
            for (std::uint32_t u = sides_[m.side].first_use; u < sides_[m.side].last_use; ++u)
                join(i, match_of(side_at_[2 * ends_[u].edge + (ends_[u].is_a ? 1 : 0)], m.other));
        }
        join_over_hard_edges();
        stretches_.resize(matches_.size());
        for (std::uint32_t i = 0; i < matches_.size(); ++i) {
            const Match& m = matches_[i];
            Stretch& s = stretches_[sets_.root(i)];
            std::tie(s.low_mesh, s.high_mesh) = std::minmax(m.mesh, m.other);
            ++(m.mesh == s.low_mesh ? s.low : s.high);
            (m.mesh == s.low_mesh ? s.low_length : s.high_length) += matched_edges_from(m);
        }
    }

    /// Sides of one mesh at one place with different normals.
    void join_over_hard_edges() {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> last;  // mesh, other mesh -> match
        for (std::uint32_t i = 0; i < matches_.size(); ++i) {
            const auto place = [&](std::uint32_t match) { return nodes_.place[sides_[matches_[match].side].node]; };
            if (i > 0 && place(i) != place(i - 1)) last.clear();
            const auto [known, is_new] = last.try_emplace({matches_[i].mesh, matches_[i].other}, i);
            if (!is_new) sets_.join(i, known->second);
        }
    }

    /// [m] Of edges that begin at the match's side and match the same mesh at their ends.
    double matched_edges_from(const Match& m) const {
        double sum = 0;
        for (std::uint32_t u = sides_[m.side].first_use; u < sides_[m.side].last_use; ++u) {
            const EdgeEnd& end = ends_[u];
            if (end.is_a && match_of(side_at_[2 * end.edge + 1], m.other) != nothing) sum += edges_[end.edge].length;
        }
        return sum;
    }

    /// Tie-breaker for the leading mesh if both have equally many vertices.
    std::pair<std::uint32_t, std::uint32_t> standing(std::uint32_t mesh) const {
        return {input_.meshes[mesh].object, mesh};
    }

    /// Preference among several leading matches: fewest vertices, lower object, lower mesh, nearest.
    auto preference(std::uint32_t i) const {
        const Match& m = matches_[i];
        return std::tuple(stretch_of(i).of(m.other), standing(m.other), m.hit.rank, m.hit.edge);
    }
    const Stretch& stretch_of(std::uint32_t match) const { return stretches_[root_[match]]; }

    bool follows(std::uint32_t i) const {
        const Match& m = matches_[i];
        const Stretch& stretch = stretch_of(i);
        if (std::max(stretch.low_length, stretch.high_length) < min_run * distance_) return false;
        const std::uint32_t own = stretch.of(m.mesh), other = stretch.of(m.other);
        return std::tuple(other, standing(m.other)) < std::tuple(own, standing(m.mesh));
    }

    void choose_links() {
        root_.resize(matches_.size());
        for (std::uint32_t i = 0; i < matches_.size(); ++i) root_[i] = sets_.root(i);
        std::vector<std::uint32_t> best(nodes_.count(), nothing);
        for (std::uint32_t i = 0; i < matches_.size(); ++i) {
            const std::uint32_t node = sides_[matches_[i].side].node;
            if (!follows(i) || link_of(i, node).node == nothing) continue;
            if (best[node] == nothing || preference(i) < preference(best[node])) best[node] = i;
        }
        for (std::uint32_t node = 0; node < best.size(); ++node)
            if (best[node] != nothing) {
                result_.links.push_back(link_of(best[node], node));
                chosen_.push_back(best[node]);
            }
    }

    /// A node at the relevant end of an edge follows nothing: `node` is then `nothing`.
    BorderLink link_of(std::uint32_t match, std::uint32_t node) const {
        const BorderHit& hit = matches_[match].hit;
        const BorderEdge& edge = edges_[hit.edge];
        BorderLink link{node, member(edge.vertex_a), member(edge.vertex_b), 0, 0, hit.t, 1};
        link.node_a = index_.node_of_member(link.member_a), link.node_b = index_.node_of_member(link.member_b);
        if ((link.counts_a() && link.node_a == node) || (link.counts_b() && link.node_b == node)) link.node = nothing;
        return link;
    }

    /// If two nodes of one mesh at one place would follow the same normal, only the nearer one does, so that a hard
    /// edge that ends at the border stays hard.
    void drop_doubles() {
        std::vector<BorderLink>& links = result_.links;
        for (std::size_t i = 0; i < links.size();) {
            std::size_t end = i + 1;
            while (end < links.size() && nodes_.place[links[end].node] == nodes_.place[links[i].node]) ++end;
            for (std::size_t a = i; a < end && end - i > 1; ++a)
                for (std::size_t b = i; b < std::min(end, i + 64); ++b)
                    if (a != b && is_double(a, b)) links[a].depth = 0;
            i = end;
        }
        std::erase_if(links, [](const BorderLink& l) { return l.depth == 0; });
    }

    /// Whether link b is nearer to the common target.
    bool is_double(std::size_t a, std::size_t b) const {
        const Match &x = matches_[chosen_[a]], &y = matches_[chosen_[b]];
        if (x.mesh != y.mesh || x.other != y.other) return false;
        const dvec3 nx = edges_[x.hit.edge].normal(x.hit.t), ny = edges_[y.hit.edge].normal(y.hit.t);
        if (!are_one_normal(nx, ny)) return false;
        return std::pair(x.hit.rank, a) > std::pair(y.hit.rank, b);
    }

    /// Depths along the links, without recursion; links that close a cycle or are too deep are dropped (depth 0).
    void find_depths() {
        std::vector<BorderLink>& links = result_.links;
        std::vector<std::uint32_t> link_at(nodes_.count(), nothing), stack;
        for (std::uint32_t i = 0; i < links.size(); ++i) link_at[links[i].node] = i;
        enum : std::uint8_t { unknown, open, done };
        std::vector<std::uint8_t> state(links.size(), unknown);
        for (std::uint32_t first = 0; first < links.size(); ++first) {
            if (state[first] != unknown) continue;
            stack.assign(1, first);
            while (!stack.empty()) {
                const std::uint32_t i = stack.back();
                state[i] = state[i] == unknown ? std::uint8_t(open) : state[i];
                std::uint32_t depth = 0;
                bool waits = false, circles = false;
                const auto look = [&](bool counts, std::uint32_t node) {
                    const std::uint32_t l = counts ? link_at[node] : nothing;
                    if (l == nothing) return;
                    if (state[l] == unknown) stack.push_back(l), waits = true;
                    circles = circles || state[l] == open;
                    depth = std::max(depth, links[l].depth);
                };
                look(links[i].counts_a(), links[i].node_a);
                if (!waits) look(links[i].counts_b(), links[i].node_b);
                if (waits) continue;
                links[i].depth = circles || depth >= max_depth ? 0 : depth + 1;
                state[i] = done;
                stack.pop_back();
            }
        }
    }

    const BorderSearch& search_;
    std::span<const BorderEdge> edges_;
    const AttributeInput& input_;
    const BorderNodes& nodes_;
    const MemberIndex index_;
    const double distance_;
    Context& context_;
    std::vector<EdgeEnd> ends_;           ///< by side
    std::vector<Side> sides_;             ///< by node, then by mesh
    std::vector<std::uint32_t> side_at_;  ///< [2 * edges] of its a, of its b
    std::vector<Match> matches_;          ///< by side, then by other mesh
    UnionFind sets_;                      ///< of matches
    std::vector<std::uint32_t> root_;     ///< [matches]
    std::vector<Stretch> stretches_;      ///< [matches] filled at roots
    std::vector<std::uint32_t> chosen_;   ///< [links before any is dropped] match
    BorderLinks result_;
};

}  // namespace

BorderLinks link_borders(const BorderSearch& search, const AttributeInput& input, const BorderNodes& nodes,
                         double distance, Context& context) {
    return Linker(search, input, nodes, distance, context).run();
}

}  // namespace rakelight::geometry
