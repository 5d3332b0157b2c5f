// SPDX-License-Identifier: Apache-2.0
#include "geometry/refine_groups.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace rakelight::geometry {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

struct BinScratch {
    Fan fan;
    UnionFind sets;
    std::vector<std::uint32_t> vertex, root, order;
};

class Refinement {
public:
    Refinement(Topology& topology, const AttributeInput& input, const JoinRules& rules, const CornerBins& bins, Context& context)
        : topology_(topology), input_(input), rules_(rules), bins_(bins), context_(context), groups_(topology.group.size()),
          chunks_((groups_ + vertices_per_chunk - 1) / vertices_per_chunk), lead_(bins.corners.size()),
          fresh_(bins.corners.size()), leader_(groups_, none), appended_(chunks_ + 1, 0) {}

    void run() {
        context_.parallel_for(chunks_, [&](std::size_t c) {
            BinScratch scratch;
            std::uint32_t appended = 0;
            for_each_bin(c, [&](std::uint32_t g) { group_bin(g, scratch, appended); });
            appended_[c + 1] = appended;
        });
        std::partial_sum(appended_.begin(), appended_.end(), appended_.begin());
        const std::uint32_t old_count = std::uint32_t(groups_), added = appended_.back();
        if (added != 0) {
            materialize_corners(topology_, input_, context_);
            topology_.source.resize(topology_.source.size() + added);
        }
        old_group_ = std::move(topology_.group);
        topology_.group.assign(std::size_t(old_count) + added, none);
        if (added != 0) append(old_count);
        regroup();
    }

private:
    template <class Body>
    void for_each_bin(std::size_t chunk, const Body& body) const {
        const std::size_t last = std::min(groups_, (chunk + 1) * std::size_t(vertices_per_chunk));
        for (std::size_t g = chunk * vertices_per_chunk; g < last; ++g)
            if (bins_.begin[g] != bins_.begin[g + 1]) body(std::uint32_t(g));
    }
    bool stays_whole(std::uint32_t g) const { return lead_[bins_.begin[g]] == none; }
    std::uint32_t vertex_of(std::uint32_t corner) const {
        return topology_.vertex_of(input_, input_.mesh_of_triangle(corner / 3), corner);
    }

    void group_bin(std::uint32_t g, BinScratch& s, std::uint32_t& appended) {
        const std::uint32_t begin = bins_.begin[g], count = bins_.begin[g + 1] - begin;
        const std::span<const std::uint32_t> corners(bins_.corners.data() + begin, count);
        rules_.gather(corners, s.fan);
        rules_.join(s.fan, s.sets);
        std::uint32_t first_vote = none;
        bool all_vote = true, one_group = true;
        s.root.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            s.root[i] = s.sets.root(i);
            if (!s.fan.votes(i)) all_vote = false;
            else if (first_vote == none) first_vote = i;
            else one_group &= s.root[i] == s.root[first_vote];
        }
        if (first_vote == none) first_vote = 0;
        leader_[g] = corners[first_vote];
        if (one_group) {
            lead_[begin] = none;  // the bin stays whole: its leader says all
            return;
        }
        s.vertex.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) s.vertex[i] = vertex_of(corners[i]);
        s.order.resize(count);
        std::iota(s.order.begin(), s.order.end(), 0u);
        if (!all_vote) follow(s, first_vote);
        assign_vertices(s, begin, appended);
        for (std::uint32_t i = 0; i < count; ++i) lead_[begin + i] = corners[s.root[i]];
    }

    // Corners without a vote go with the first voting corner of their vertex, else of their mesh, else of the bin.
    void follow(BinScratch& s, std::uint32_t first_vote) const {
        const auto mesh_of = [&](std::uint32_t at) { return input_.mesh_of_triangle(s.fan.corner[at] / 3); };
        std::sort(s.order.begin(), s.order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::tuple(s.vertex[a], !s.fan.votes(a), a) < std::tuple(s.vertex[b], !s.fan.votes(b), b);
        });
        std::vector<std::uint32_t> home_of_mesh(s.order.size(), first_vote);  // corners ascend, so those of a mesh lie together
        for (std::uint32_t first = 0, last = 0; first < home_of_mesh.size(); first = last) {
            std::uint32_t home = none;
            for (; last < home_of_mesh.size() && mesh_of(last) == mesh_of(first); ++last)
                if (home == none && s.fan.votes(last)) home = last;
            if (home != none) std::fill(home_of_mesh.begin() + first, home_of_mesh.begin() + last, home);
        }
        std::uint32_t home = first_vote;
        for (std::size_t i = 0; i < s.order.size(); ++i) {
            const std::uint32_t at = s.order[i];
            if (i == 0 || s.vertex[at] != s.vertex[s.order[i - 1]]) home = s.fan.votes(at) ? at : home_of_mesh[at];
            if (!s.fan.votes(at)) s.root[at] = s.root[home];
        }
    }

    // Each vertex keeps its number for the group of its first corner; every other group of it gets an appended vertex.
    void assign_vertices(BinScratch& s, std::uint32_t begin, std::uint32_t& appended) {
        std::sort(s.order.begin(), s.order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::tuple(s.vertex[a], s.root[a], a) < std::tuple(s.vertex[b], s.root[b], b);
        });
        for (std::size_t first = 0; first < s.order.size();) {
            std::size_t last = first;
            std::uint32_t keeper = s.order[first];
            for (; last < s.order.size() && s.vertex[s.order[last]] == s.vertex[s.order[first]]; ++last)
                keeper = std::min(keeper, s.order[last]);
            for (std::size_t i = first; i < last; ++i) {
                const std::uint32_t at = s.order[i];
                const bool kept = s.root[at] == s.root[keeper];
                if (!kept && (i == first || s.root[at] != s.root[s.order[i - 1]])) ++appended;
                fresh_[begin + at] = kept ? none : appended - 1;
            }
            first = last;
        }
    }

    void append(std::uint32_t old_count) {
        const std::uint32_t fixed = input_.vertex_count();
        context_.parallel_for(chunks_, [&](std::size_t c) {
            for_each_bin(c, [&](std::uint32_t g) {
                for (std::uint32_t i = bins_.begin[g]; i != bins_.begin[g + 1] && !stays_whole(g); ++i) {
                    if (fresh_[i] == none) continue;
                    std::uint32_t& vertex = topology_.corner_vertex[bins_.corners[i]];
                    // Corners of one appended vertex come from one vertex, and are met one after the other by this thread.
                    const std::uint32_t made = old_count + appended_[c] + fresh_[i];
                    topology_.source[made - fixed] = topology_.source_of(input_, vertex);
                    vertex = made;
                }
            });
        });
    }

    // The vertex of a group's first corner stands for the group. A vertex without corners in a bin keeps to its old group's
    // leader.
    void regroup() {
        context_.parallel_for(chunks_, [&](std::size_t c) {
            const std::size_t last = std::min(groups_, (c + 1) * std::size_t(vertices_per_chunk));
            for (std::size_t v = c * vertices_per_chunk; v < last; ++v) {
                const std::uint32_t old = old_group_[v], leader = leader_[old];
                topology_.group[v] = leader == none ? old : vertex_of(leader);
            }
        });
        context_.parallel_for(chunks_, [&](std::size_t c) {
            for_each_bin(c, [&](std::uint32_t g) {
                for (std::uint32_t i = bins_.begin[g]; i != bins_.begin[g + 1] && !stays_whole(g); ++i)
                    topology_.group[vertex_of(bins_.corners[i])] = vertex_of(lead_[i]);
            });
        });
    }

    Topology& topology_;
    const AttributeInput& input_;
    const JoinRules& rules_;
    const CornerBins& bins_;
    Context& context_;
    std::size_t groups_, chunks_;
    std::vector<std::uint32_t> lead_;          // [binned corners] first corner of its group
    std::vector<std::uint32_t> fresh_;         // [binned corners] appended vertex it goes to, counted in the chunk, or none
    std::vector<std::uint32_t> leader_;        // [groups] first voting corner
    std::vector<std::uint32_t> appended_;      // [chunks + 1]
    std::vector<std::uint32_t> old_group_;
};

}  // namespace

void refine_groups(Topology& topology, const AttributeInput& input, const AttributeOptions& options, JoinRule rule,
                   const std::vector<dvec3>& normals, const std::vector<std::uint8_t>& selected, Context& context) {
    const CornerBins bins = bin_corners(topology, input, selected, context);
    const JoinRules rules(input, topology, options, rule, normals);
    Refinement(topology, input, rules, bins, context).run();
    if (!topology.source.empty()) sort_appended(topology, input, context);
}

}  // namespace rakelight::geometry
