// SPDX-License-Identifier: Apache-2.0
#include "geometry/groups/refine_groups.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace rakelight::geometry {
namespace {

constexpr std::uint32_t no_index = 0xffffffffu;

struct BinScratch {
    Fan fan;
    UnionFind sets;
    std::vector<std::uint32_t> vertex, root, order;
    std::uint32_t mesh = 0;  // of the place before
};

// The groups of one chunk that must be split. Most groups are not split and have no entry.
struct Splits {
    std::vector<std::uint32_t> bins;
    std::vector<std::uint32_t> leads;  // [corners of these bins] first corner of its group
    std::vector<std::uint32_t>
        fresh;  // [corners of these bins] appended vertex it goes to, counted in the chunk, or none
    std::vector<std::uint32_t> leader;   // [bins] first voting corner
    std::vector<std::uint32_t> parents;  // [appended] vertices that the appended ones are parted from
    bool may_cancel = false;
};

class Refinement {
public:
    Refinement(Topology& topology, const AttributeInput& input, const JoinRules& rules, const CornerBins& bins,
               Context& context, GeneralScratch& scratch)
        : topology_(topology),
          input_(input),
          rules_(rules),
          bins_(bins),
          context_(context),
          scratch_(scratch),
          old_count_(std::uint32_t(topology.group.size())),
          splits_((old_count_ + vertices_per_chunk - 1) / vertices_per_chunk) {}

    bool run() {
        context_.parallel_for(splits_.size(), [&](std::size_t c) {
            BinScratch scratch;
            Splits splits;
            const std::uint32_t first = std::uint32_t(c) * vertices_per_chunk;
            for (std::uint32_t g = first; g != first + std::min(old_count_ - first, vertices_per_chunk); ++g)
                if (bins_.size(g) > 1 && !rules_.is_calm(bins_[g], scratch.mesh)) group_bin(g, scratch, splits);
            splits_[c] = std::move(splits);
        });
        bool any = false, may_cancel = false;
        for (const Splits& s : splits_) {
            any |= !s.bins.empty();
            may_cancel |= s.may_cancel;
        }
        if (any) apply();
        return may_cancel;
    }

private:
    std::uint32_t vertex_of(std::uint32_t corner) const {
        return topology_.vertex_of(input_, input_.mesh_of_triangle(corner / 3), corner);
    }

    void group_bin(std::uint32_t g, BinScratch& s, Splits& out) const {
        const std::span<const std::uint32_t> corners = bins_[g];
        const std::uint32_t count = std::uint32_t(corners.size());
        rules_.gather(corners, s.fan);
        rules_.join(s.fan, s.sets);
        std::uint32_t first_vote = no_index;
        bool all_vote = true, one_group = true;
        s.root.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            s.root[i] = s.sets.root(i);
            if (!s.fan.votes(i)) {
                all_vote = false;
                continue;
            }
            if (first_vote == no_index) first_vote = i;
            one_group &= s.root[i] == s.root[first_vote];
            out.may_cancel |= dot(s.fan.normal[i], s.fan.normal[s.root[i]]) < looks_away;
        }
        if (one_group) return;
        s.vertex.resize(count);
        for (std::uint32_t i = 0; i < count; ++i) s.vertex[i] = vertex_of(corners[i]);
        s.order.resize(count);
        std::iota(s.order.begin(), s.order.end(), 0u);
        if (!all_vote) follow(s, first_vote);
        out.bins.push_back(g);
        out.leader.push_back(corners[first_vote]);
        out.fresh.resize(out.fresh.size() + count);
        assign_vertices(s, out.fresh.data() + out.fresh.size() - count, out.parents);
        for (std::uint32_t i = 0; i < count; ++i) out.leads.push_back(corners[s.root[i]]);
    }

    // Corners without a vote join the first voting corner of their vertex, else of their mesh, else of the bin.
    void follow(BinScratch& s, std::uint32_t first_vote) const {
        const auto mesh_of = [&](std::uint32_t at) { return input_.mesh_of_triangle(s.fan.corner[at] / 3); };
        std::sort(s.order.begin(), s.order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::tuple(s.vertex[a], !s.fan.votes(a), a) < std::tuple(s.vertex[b], !s.fan.votes(b), b);
        });
        std::vector<std::uint32_t> home_of_mesh(s.order.size(),
                                                first_vote);  // corners ascend, so those of a mesh lie together
        for (std::uint32_t first = 0, last = 0; first < home_of_mesh.size(); first = last) {
            std::uint32_t home = no_index;
            for (; last < home_of_mesh.size() && mesh_of(last) == mesh_of(first); ++last)
                if (home == no_index && s.fan.votes(last)) home = last;
            if (home != no_index) std::fill(home_of_mesh.begin() + first, home_of_mesh.begin() + last, home);
        }
        std::uint32_t home = first_vote;
        for (std::size_t i = 0; i < s.order.size(); ++i) {
            const std::uint32_t at = s.order[i];
            if (i == 0 || s.vertex[at] != s.vertex[s.order[i - 1]]) home = s.fan.votes(at) ? at : home_of_mesh[at];
            if (!s.fan.votes(at)) s.root[at] = s.root[home];
        }
    }

    // Each vertex keeps its index for the group of its first corner; every other group gets an appended vertex.
    static void assign_vertices(BinScratch& s, std::uint32_t* fresh, std::vector<std::uint32_t>& parents) {
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
                if (!kept && (i == first || s.root[at] != s.root[s.order[i - 1]])) parents.push_back(s.vertex[at]);
                fresh[at] = kept ? no_index : std::uint32_t(parents.size()) - 1;
            }
            first = last;
        }
    }

    // Calls body(corner, lead, fresh) for each corner of the chunk's split bins.
    template <class Body>
    void for_each_split(const Splits& splits, const Body& body) const {
        std::size_t at = 0;
        for (const std::uint32_t g : splits.bins)
            for (const std::uint32_t corner : bins_[g]) {
                body(corner, splits.leads[at], splits.fresh[at]);
                ++at;
            }
    }

    void apply() {
        std::vector<std::uint32_t> leader = scratch_.take_words(), first_new{0};
        leader.assign(old_count_, no_index);
        for (const Splits& s : splits_) {
            for (std::size_t i = 0; i < s.bins.size(); ++i) leader[s.bins[i]] = s.leader[i];
            first_new.push_back(first_new.back() + std::uint32_t(s.parents.size()));
        }
        if (first_new.back() != 0) append(first_new);
        // The vertex of a group's first corner represents the group. A vertex without corners joins the bin's leader.
        context_.parallel_for(splits_.size(), [&](std::size_t c) {
            const std::size_t first = c * vertices_per_chunk;
            for (std::size_t v = first; v < std::min<std::size_t>(old_count_, first + vertices_per_chunk); ++v)
                if (const std::uint32_t corner = leader[topology_.group[v]]; corner != no_index)
                    topology_.group[v] = vertex_of(corner);
        });
        context_.parallel_for(splits_.size(), [&](std::size_t c) {
            for_each_split(splits_[c], [&](std::uint32_t corner, std::uint32_t lead, std::uint32_t) {
                topology_.group[vertex_of(corner)] = vertex_of(lead);
            });
        });
        scratch_.give(leader);
        if (needs_sorting_) sort_appended(topology_, input_, context_);
    }

    // Renumbers the new vertices by source together with those of earlier rounds, by sorting again.
    void append(const std::vector<std::uint32_t>& first_new) {
        materialize_corners(topology_, input_, context_);
        const bool is_first = topology_.source.empty();
        std::vector<std::uint32_t> sources, number;
        for (const Splits& s : splits_)
            for (const std::uint32_t parent : s.parents) sources.push_back(topology_.source_of(input_, parent));
        if (is_first) number = rank_by_source(sources, input_.vertex_count(), scratch_);
        const std::size_t before = topology_.source.size();
        topology_.group.resize(old_count_ + sources.size(), no_index);
        topology_.source.resize(before + sources.size());
        for (std::size_t i = 0; i < sources.size(); ++i)
            topology_.source[before + (is_first ? number[i] : i)] = sources[i];
        context_.parallel_for(splits_.size(), [&](std::size_t c) {
            for_each_split(splits_[c], [&](std::uint32_t corner, std::uint32_t, std::uint32_t fresh) {
                if (fresh == no_index) return;
                const std::uint32_t made = first_new[c] + fresh;
                topology_.corner_vertex[corner] = old_count_ + (is_first ? number[made] : made);
            });
        });
        needs_sorting_ = !is_first;
    }

    Topology& topology_;
    const AttributeInput& input_;
    const JoinRules& rules_;
    const CornerBins& bins_;
    Context& context_;
    GeneralScratch& scratch_;
    std::uint32_t old_count_;
    std::vector<Splits> splits_;  // [chunks of groups]
    bool needs_sorting_ = false;
};

}  // namespace

bool refine_groups(Topology& topology, const AttributeInput& input, const JoinRules& rules, const CornerBins& bins,
                   Context& context, GeneralScratch* scratch) {
    GeneralScratch own;
    return Refinement(topology, input, rules, bins, context, scratch ? *scratch : own).run();
}

}  // namespace rakelight::geometry
