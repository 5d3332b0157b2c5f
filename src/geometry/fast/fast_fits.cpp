// SPDX-License-Identifier: Apache-2.0
// Fits after the fast sums. Places that are one group keep the numbers of their vertices; others are grouped by the general
// path, and their groups join the same topology, so that each place is fitted among all its neighbors.
#include <functional>

#include "geometry/fast/fast_hard_places.h"
#include "geometry/fast/fast_stages.h"
#include "geometry/fits/fit_normals.h"
#include "geometry/general_attributes.h"
#include "geometry/sums/finish_vertices.h"

namespace rakelight::geometry {
namespace {

class PlaceFits {
public:
    PlaceFits(FastState& state, std::span<const std::uint32_t> hard, std::span<const AttributeBuffers> out)
        : state_(state), input_(state.input), out_(out), hard_(state, hard) {}

    void run(std::vector<SplitAttributes>& splits) {
        const std::size_t count = input_.vertex_count();
        GeneralScratch& scratch = state_.scratch.general;
        charge_ = {state_.context.memory(),
                   (count + hard_.corners()) * (sizeof(std::uint32_t) + 2 * sizeof(vec3) + 1) +
                       (hard_.parts().empty() ? 0 : 12ull * input_.triangle_count()),
                   "fitting normals"};
        topology_.group = scratch.take_words();
        topology_.group.resize(count);
        by_max_ = scratch.take<vec3>(count + hard_.corners());
        spread_ = scratch.take<Spread>(count + hard_.corners());
        for_each_part([&](std::uint32_t m, std::uint32_t first, std::uint32_t last) { read(m, first, last); });
        for (const std::vector<Duplicate>& classes : state_.scratch.classes)
            for_each_class(classes, [&](std::span<const std::uint32_t> members) {
                for (const std::uint32_t v : members) topology_.group[v] = members[0];
            });
        if (hard_.parts().empty()) return fit();
        const GroupedPart part(hard_.meshes(), state_.options, hard_.wanted(), scratch, state_.context);
        add_groups(part);
        fit();
        hard_.take(part.finish([&](VoteSums& sums) { replace(sums); }), out_, splits);
    }
    ~PlaceFits() {
        GeneralScratch& scratch = state_.scratch.general;
        scratch.give(topology_.group), scratch.give(topology_.corner_vertex);
        scratch.give(by_max_), scratch.give(spread_), scratch.give(normals_);
    }
    PlaceFits(const PlaceFits&) = delete;
    PlaceFits& operator=(const PlaceFits&) = delete;

private:
    static constexpr std::uint32_t none = 0xffffffffu;

    const Placement& placement() const { return input_.placements[0]; }  // that of all meshes

    template <class Body>
    void for_each_part(const Body& body) {
        const std::vector<Chunk> chunks = make_chunks(input_.vertex_base, vertices_per_chunk);
        for_each_in_lanes(state_, chunks.size(),
                          [&](LaneScratch&, std::size_t c) { for_each_range(chunks[c], input_.vertex_base, body); });
    }

    void read(std::uint32_t m, std::uint32_t first, std::uint32_t last) {
        const std::uint32_t base = input_.vertex_base[m];
        const LookRow* const looks = state_.looks_at();
        for (std::uint32_t v = base + first; v != base + last; ++v) {
            topology_.group[v] = v;
            const LookRow& look = looks[v];
            const bool goes_around = look.ends[0] == 0 && look.ends[1] == 0;
            const bool has_faces = !goes_around || look.turns > 0 || look.bends > 0;
            spread_[v] = !has_faces || hard_.is_wanted(v) || !goes_around ? Spread::unknown
                         : look.bends == 0                                ? Spread::mild
                                                                          : Spread::wide;
            const vec3 n = out_[m].normals[v - base];
            by_max_[v] = !has_faces ? vec3{} : state_.is_identity ? n : to_world(n);
        }
    }
    vec3 to_world(vec3 n) const { return cast<float>(normalize_or(placement().normal_to_world * cast<double>(n), {})); }

    /// Output vertices and groups of the hard places, instead of what was read there.
    void add_groups(const GroupedPart& part) {
        const Topology& from = part.topology();
        number_outputs(part);
        for (std::size_t row = 0; row < to_global_.size(); ++row)
            if (to_global_[row] != none) topology_.group[to_global_[row]] = to_global_[from.group[row]];
        VoteSums sums = part.sums();
        for (std::size_t row = 0; row < to_global_.size(); ++row)
            if (to_global_[row] != none)
                by_max_[to_global_[row]] = cast<float>(normalize_or(sums.normals[row].normal, {}));
        state_.scratch.general.give(sums.normals);
        if (topology_.source.empty()) return;
        topology_.spare = state_.scratch.general.take<char>(12 * std::size_t(input_.triangle_count())).take();
        materialize_corners(topology_, input_, state_.context);
        for (std::size_t p = 0; p < hard_.parts().size(); ++p) put_corners(part, std::uint32_t(p));
    }

    /// [output vertices of the part] global ones, appended behind the input's; none: not wanted.
    void number_outputs(const GroupedPart& part) {
        const AttributeInput& local = part.input();
        const Topology& from = part.topology();
        to_global_.assign(from.group.size(), none);
        for (std::size_t p = 0; p < hard_.parts().size(); ++p) {
            const PartMesh& mesh = hard_.parts()[p];
            for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
                if (mesh.is_wanted[v] != 0)
                    to_global_[local.vertex_base[p] + v] = input_.vertex_base[mesh.mesh] + mesh.vertices[v];
        }
        for (std::size_t row = local.vertex_count(); row < to_global_.size(); ++row) {
            const std::uint32_t source = to_global_[from.source_of(local, std::uint32_t(row))];
            if (source == none) continue;
            to_global_[row] = std::uint32_t(topology_.group.size());
            topology_.source.push_back(source);
            spread_[to_global_[row]] = Spread::unknown;
            topology_.group.push_back(none);
        }
    }

    void put_corners(const GroupedPart& part, std::uint32_t p) {
        const PartMesh& mesh = hard_.parts()[p];
        const std::uint32_t first = 3 * part.input().triangle_base[p], to = 3 * input_.triangle_base[mesh.mesh];
        for (std::uint32_t i = 0; i < 3 * mesh.faces.size(); ++i) {
            const std::uint32_t row = part.topology().vertex_of(part.input(), p, first + i);
            if (row < part.input().vertex_count() || to_global_[row] == none) continue;
            topology_.corner_vertex[to + 3 * mesh.faces[i / 3] + i % 3] = to_global_[row];
        }
    }

    /// Fits all groups, and replaces the normals of places that are one group.
    void fit() {
        const std::size_t count = topology_.group.size();
        const FitInput from{topology_,
                            input_,
                            {by_max_.data(), count},
                            {spread_.data(), count},
                            state_.options.weight == CornerWeight::automatic};
        normals_ = fit_groups(from, state_.scratch.general, state_.context);
        for_each_part([&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const std::uint32_t base = input_.vertex_base[m];
            for (std::uint32_t v = base + first; v != base + last; ++v) {
                if (spread_[v] == Spread::mild || hard_.is_wanted(v)) continue;
                const vec3 n = normals_[topology_.group[v]];
                if (n == vec3{}) continue;
                out_[m].normals[v - base] =
                    state_.is_identity ? n : cast<float>(to_object(placement(), cast<double>(n)));
            }
        });
        if (state_.tangents) finish_tangents(state_);
    }

    /// Of the hard places.
    void replace(VoteSums& sums) const {
        for (std::size_t row = 0; row < to_global_.size(); ++row) {
            NormalRow& sum = sums.normals[row];
            if (to_global_[row] == none || !(sum.weight > 0) || has_cancelled(sum)) continue;
            const vec3 n = normals_[topology_.group[to_global_[row]]];
            if (n != vec3{}) sum.normal = cast<double>(n) * sum.weight;
        }
    }

    FastState& state_;
    const AttributeInput& input_;
    std::span<const AttributeBuffers> out_;
    HardPlaces hard_;
    Topology topology_;
    BlockArray<vec3> by_max_;               // [output vertices, and room for more] world
    BlockArray<Spread> spread_;             // [output vertices, and room for more]
    std::vector<std::uint32_t> to_global_;  // [output vertices of the hard part]
    BlockArray<vec3> normals_;
    MemoryCharge charge_;
};

}  // namespace

void fit_places(FastState& state, std::span<const std::uint32_t> hard, std::span<const AttributeBuffers> out,
                std::vector<SplitAttributes>& splits) {
    PlaceFits(state, hard, out).run(splits);
}

}  // namespace rakelight::geometry
