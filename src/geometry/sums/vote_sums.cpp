// SPDX-License-Identifier: Apache-2.0
#include "geometry/sums/vote_sums.h"

#include "base/atomic_ref.h"
#include "geometry/input/face_vote.h"
#include "geometry/input/vote_kernel_types.h"
#include "geometry/sums/tangent_groups.h"
#include "math/isa.h"

namespace rakelight::geometry {
namespace {

// Votes for vertices that another piece of the mesh owns, in the order of sending. Stored in blocks, so that growing
// moves nothing. Memory is charged as outboxes grow: nothing for most models, all votes for unordered triangles.
template <class Item>
class Outbox {
public:
    void push(const Item& item, MemoryCharge& memory) {
        if (blocks_.empty() || blocks_.back().size() == block) {
            memory.grow(block * sizeof(Item), "smoothing normals of triangles in disorder");
            blocks_.emplace_back().reserve(block);
        }
        blocks_.back().push_back(item);
    }
    template <class Body>
    void for_each(const Body& body) const {
        for (const std::vector<Item>& b : blocks_)
            for (const Item& item : b) body(item);
    }

private:
    static constexpr std::size_t block = 256;
    std::vector<std::vector<Item>> blocks_;
};

struct NormalVote {
    NormalRow row;
    std::uint32_t to;
};
struct TangentVote {
    TangentRow row;
    std::uint32_t to;
};
struct Outboxes {
    Outbox<NormalVote> normals;
    Outbox<TangentVote> tangents;
};

void add(NormalRow& to, dvec3 normal, double weight) {
    to.normal += normal;
    to.weight += weight;
}
void add(TangentRow& to, dvec3 tangent, double hand) {
    to.tangent += tangent;
    to.hand += hand;
}

static_assert(int(VoteWeight::uniform) == int(CornerWeight::uniform) && int(VoteWeight::max) == int(CornerWeight::max));

class Scatter {
public:
    Scatter(VoteSums& sums, const Topology& topology, const AttributeInput& input, const AttributeOptions& options,
            Context& context)
        : sums_(sums),
          topology_(topology),
          input_(input),
          options_(options),
          context_(context),
          appended_base_(appended_base(topology, input)),
          chunks_(make_chunks(input.triangle_base, triangles_per_chunk)),
          memory_(context.memory()),
          outbox_(chunks_.size()) {}

    void run() {
        context_.parallel_for(chunks_.size(), [&](std::size_t c) { scatter(c); });
        context_.parallel_for(chunks_.size(), [&](std::size_t c) { drain(c); });
    }

private:
    // The rows that a chunk owns: a range of the input's vertices and one of the appended ones.
    struct Owned {
        std::uint32_t begin, end, appended_begin, appended_end;
        bool holds(std::uint32_t row) const {
            return (row >= begin && row < end) || (row >= appended_begin && row < appended_end);
        }
    };
    Owned owned_by(const Chunk& chunk, std::uint32_t m) const {
        const auto part = [&](const std::vector<std::uint32_t>& base, std::uint32_t piece) {
            return base[m] + piece_begin(base[m + 1] - base[m], piece, chunk.pieces);
        };
        const std::uint32_t fixed = input_.vertex_count();
        return {part(input_.vertex_base, chunk.piece), part(input_.vertex_base, chunk.piece + 1),
                fixed + part(appended_base_, chunk.piece), fixed + part(appended_base_, chunk.piece + 1)};
    }
    std::uint32_t owner_of(std::uint32_t row, std::uint32_t m, std::uint32_t pieces) const {
        const std::uint32_t fixed = input_.vertex_count();
        const auto& base = row < fixed ? input_.vertex_base : appended_base_;
        return piece_of((row < fixed ? row : row - fixed) - base[m], base[m + 1] - base[m], pieces);
    }

    void scatter(std::size_t c) {
        const Chunk chunk = chunks_[c];
        if (chunk.pieces > 1) outbox_[c].resize(chunk.pieces);
        for_each_range(chunk, input_.triangle_base, [&](std::uint32_t m, std::uint32_t first, std::uint32_t last) {
            const Owned own = owned_by(chunk, m);
            clear(own);
            const bool tangents = sums_.has_tangents() && !input_.meshes[m].texcoords.empty();
            switch (options_.weight) {
                case CornerWeight::uniform:
                    return scatter_as<CornerWeight::uniform>(tangents, c, m, first, last, own);
                case CornerWeight::area:
                    return scatter_as<CornerWeight::area>(tangents, c, m, first, last, own);
                case CornerWeight::angle:
                    return scatter_as<CornerWeight::angle>(tangents, c, m, first, last, own);
                case CornerWeight::angle_area:
                    return scatter_as<CornerWeight::angle_area>(tangents, c, m, first, last, own);
                case CornerWeight::max:
                case CornerWeight::fit:
                case CornerWeight::automatic:
                    return scatter_as<CornerWeight::max>(tangents, c, m, first, last, own);
            }
        });
    }

    void clear(const Owned& own) {
        std::fill(sums_.normals.data() + own.begin, sums_.normals.data() + own.end, NormalRow{});
        std::fill(sums_.normals.data() + own.appended_begin, sums_.normals.data() + own.appended_end, NormalRow{});
        if (!sums_.has_tangents()) return;
        std::fill(sums_.tangents.data() + own.begin, sums_.tangents.data() + own.end, TangentRow{});
        std::fill(sums_.tangents.data() + own.appended_begin, sums_.tangents.data() + own.appended_end, TangentRow{});
    }

    template <CornerWeight weight>
    void scatter_as(bool tangents, std::size_t c, std::uint32_t m, std::uint32_t first, std::uint32_t last,
                    const Owned& own) {
        if (tangents)
            scatter_range<weight, true>(c, m, first, last, own);
        else
            scatter_range<weight, false>(c, m, first, last, own);
    }

    /// Destination of the votes of one chunk's faces of one mesh. Everything that the loop reads is copied to its own
    /// stack frame first: no thread shares a cache line with it.
    struct Receiver {
        Scatter& scatter;
        std::size_t c;
        std::uint32_t m;
        Owned own;
        std::uint32_t pieces;
        bool owns_all;
        NormalRow* normals;
        TangentRow* tangents;

        template <bool has_tangents>
        void add_vote(std::uint32_t row, const NormalRow& normal, const TangentRow& tangent) const {
            if (owns_all || own.holds(row)) {
                add(normals[row], normal.normal, normal.weight);
                if constexpr (has_tangents) add(tangents[row], tangent.tangent, tangent.hand);
                return;
            }
            Outboxes& out = scatter.outbox_[c][scatter.owner_of(row, m, pieces)];
            out.normals.push({normal, row}, scatter.memory_);
            if constexpr (has_tangents) out.tangents.push({tangent, row}, scatter.memory_);
        }
    };

    /// Rows of a face's corners.
    struct Rows {
        const std::uint32_t* split;  ///< of the mesh's first corner, or null
        std::uint32_t vertex_base;
        std::uint32_t of(const std::uint32_t* index, std::uint32_t t, std::uint32_t k) const {
            return split ? split[3 * std::size_t(t) + k] : vertex_base + index[k];
        }
    };

    template <CornerWeight weight, bool tangents>
    void scatter_range(std::size_t c, std::uint32_t m, std::uint32_t first, std::uint32_t last, const Owned& own) {
        const AttributeMesh mesh = input_.meshes[m];
        const Placement placement = input_.placements[m];
        const Receiver to{
            *this, c, m, own, chunks_[c].pieces, chunks_[c].pieces == 1, sums_.normals.data(), sums_.tangents.data()};
        const Rows rows{topology_.corner_vertex.empty()
                            ? nullptr
                            : topology_.corner_vertex.data() + 3 * std::size_t(input_.triangle_base[m]),
                        input_.vertex_base[m]};
        VoteJob job = job_of(mesh, placement, tangents, VoteWeight(weight));
        VoteBlock block;
        std::uint32_t degenerate = 0;
        for (std::uint32_t t0 = first; t0 != last; t0 += job.count) {
            job.count = std::min(vote_block, last - t0);
            job.indices = mesh.indices.data() + 3 * std::size_t(t0);
            kernels_.vote(job, block);
            for (std::uint32_t f = 0; f < job.count; ++f) {
                const std::uint32_t* index = job.indices + 3 * f;
                if (block.is_odd[f] || !options_.normals)
                    degenerate += !vote_alone<weight, tangents>(mesh, placement, index, t0 + f, rows, to);
                else
                    for (std::uint32_t k = 0; k < 3; ++k) {
                        const auto& v = block.votes[k];
                        to.add_vote<tangents>(
                            rows.of(index, t0 + f, k),
                            {{v[VoteBlock::normal_x][f], v[VoteBlock::normal_y][f], v[VoteBlock::normal_z][f]},
                             v[VoteBlock::weight][f]},
                            {{v[VoteBlock::tangent_x][f], v[VoteBlock::tangent_y][f], v[VoteBlock::tangent_z][f]},
                             v[VoteBlock::hand][f]});
                    }
            }
        }
        if (degenerate != 0) atomic_ref(sums_.degenerate_faces[m]).fetch_add(degenerate, std::memory_order_relaxed);
    }

    static VoteJob job_of(const AttributeMesh& mesh, const Placement& placement, bool tangents, VoteWeight weight) {
        VoteJob job;
        job.positions = mesh.positions.empty() ? nullptr : &mesh.positions.data()->x;
        job.texcoords = tangents && !mesh.texcoords.empty() ? &mesh.texcoords.data()->x : nullptr;
        job.weight = weight;
        job.flip = placement.flip;
        for (std::size_t column = 0; column < 3; ++column)
            for (std::size_t row = 0; row < 3; ++row) {
                job.linear[column][row] = placement.linear[column][row];
                job.normal_to_world[column][row] = placement.normal_to_world[column][row];
            }
        return job;
    }

    /// A face outside of the kernel's domain: without area, of extreme size, or with given normals.
    /// @return whether it has a vote
    template <CornerWeight weight, bool tangents>
    bool vote_alone(const AttributeMesh& mesh, const Placement& placement, const std::uint32_t* index, std::uint32_t t,
                    const Rows& rows, const Receiver& to) const {
        const FaceCorners face = face_corners(mesh, index);
        const Direction normal = face_normal(placement, face);
        if (!(normal.length > 0)) return false;
        const dvec3 weights = corner_weights<weight>(placement, face, normal.length);
        FaceTangent tangent;
        if constexpr (tangents) tangent = face_tangent(mesh, index, placement, face);
        for (std::uint32_t k = 0; k < 3; ++k) {
            const double w = weights[k];
            double hand = tangent.hand * w;
            if (tangents && !options_.normals)
                hand = handedness_from(given_normal(placement, mesh.normals[index[k]]), normal, hand);
            to.add_vote<tangents>(rows.of(index, t, k), {normal.unit * w, w}, {tangent.unit * w, hand});
        }
        return true;
    }

    void drain(std::size_t c) {
        const Chunk chunk = chunks_[c];
        const NormalRow* normals = sums_.normals.data();
        for (std::uint32_t p = 0; p < chunk.pieces && chunk.pieces > 1; ++p) {
            const Outboxes& box = outbox_[c - chunk.piece + p][chunk.piece];
            box.normals.for_each([&](const NormalVote& v) { add(sums_.normals[v.to], v.row.normal, v.row.weight); });
            box.tangents.for_each([&](const TangentVote& v) { add(sums_.tangents[v.to], v.row.tangent, v.row.hand); });
        }
        for (std::uint32_t m = chunk.mesh_begin; m != chunk.mesh_end; ++m) {
            const Owned own = owned_by(chunk, m);
            std::uint32_t isolated = 0;
            for (std::uint32_t row = own.begin; row != own.end; ++row) isolated += normals[row].weight > 0 ? 0 : 1;
            if (isolated != 0) atomic_ref(sums_.isolated_vertices[m]).fetch_add(isolated, std::memory_order_relaxed);
        }
    }

    const VoteKernels& kernels_ = *RL_BY_ISA(isa_from_environment(), vote_kernels());
    VoteSums& sums_;
    const Topology& topology_;
    const AttributeInput& input_;
    const AttributeOptions& options_;
    Context& context_;
    std::vector<std::uint32_t> appended_base_;
    std::vector<Chunk> chunks_;
    MemoryCharge memory_;
    std::vector<std::vector<Outboxes>> outbox_;  // [chunks][receiving piece of the same mesh]
};

}  // namespace

std::vector<std::uint32_t> appended_base(const Topology& topology, const AttributeInput& input) {
    std::vector<std::uint32_t> base;
    for (const std::uint32_t first : input.vertex_base)
        base.push_back(std::uint32_t(std::lower_bound(topology.source.begin(), topology.source.end(), first) -
                                     topology.source.begin()));
    return base;
}

VoteSums sum_votes(const Topology& topology, const AttributeInput& input, const AttributeOptions& options,
                   Context& context, BlockArray<NormalRow>&& normals, BlockArray<TangentRow>&& tangents) {
    VoteSums sums;
    sums.normals = std::move(normals);
    sums.normals.reserve(topology.group.size());
    const bool textured = std::any_of(input.meshes.begin(), input.meshes.end(),
                                      [](const AttributeMesh& m) { return !m.texcoords.empty(); });
    sums.tangents = std::move(tangents);
    sums.makes_tangents = options.tangents && textured;
    if (sums.makes_tangents) sums.tangents.reserve(topology.group.size());
    sums.degenerate_faces.assign(input.meshes.size(), 0);
    sums.isolated_vertices.assign(input.meshes.size(), 0);
    Scatter(sums, topology, input, options, context).run();
    return sums;
}

/// The normals of a group's authored members, with the weights of their faces: what the group gets instead of `voted`. As
/// long as the weight of the whole group asks for, or a small share would look cancelled.
/// Equal ones are taken as they are. `voted` where there are none, or where they point to the other side or cancel.
static dvec3 authored_or(const NormalRow& voted, std::span<const std::uint32_t> members, const VoteSums& sums,
                         const Topology& topology, const AttributeInput& input) {
    dvec3 first, sum;
    double weight = 0;
    bool are_equal = true;
    for (const std::uint32_t row : members) {
        const std::uint32_t v = topology.source_of(input, row), m = input.mesh_of_vertex(v);
        if (!is_authored(input.meshes[m], v - input.vertex_base[m])) continue;
        const dvec3 given = given_normal(input.placements[m], input.meshes[m].normals[v - input.vertex_base[m]]);
        if (weight == 0) first = given;
        are_equal = are_equal && given == first;
        sum += given * sums.normals[row].weight;
        weight += sums.normals[row].weight;
    }
    if (!(weight > 0) || has_cancelled({sum, weight}) || !(dot(sum, voted.normal) > 0)) return voted.normal;
    return are_equal ? first * voted.weight : sum * (voted.weight / weight);
}

namespace {

/// Which members of groups vote for its other members.
class Voters {
public:
    Voters(const Topology& topology, const AttributeInput& input, const AttributeOptions& options)
        : topology_(topology),
          input_(input),
          has_locked_(std::any_of(input.meshes.begin(), input.meshes.end(),
                                  [](const AttributeMesh& m) { return !m.locked.empty(); })),
          skips_locked_(has_locked_ && !options.locked_vote) {}
    bool has_locked() const { return has_locked_; }
    bool votes(std::uint32_t vertex) const {
        if (!skips_locked_) return true;
        const std::uint32_t v = topology_.source_of(input_, vertex), m = input_.mesh_of_vertex(v);
        return !is_locked(input_.meshes[m], v - input_.vertex_base[m]);
    }

private:
    const Topology& topology_;
    const AttributeInput& input_;
    bool has_locked_, skips_locked_;
};

constexpr std::size_t groups_per_chunk = 1u << 13;

/// Calls body_of(chunk)(group, members) for every group.
template <class BodyOf>
void for_each_list(const VertexGroups& groups, Context& context, const BodyOf& body_of) {
    constexpr std::size_t step = groups_per_chunk;
    context.parallel_for((groups.size() + step - 1) / step, [&](std::size_t c) {
        auto body = body_of(c);
        for (std::size_t g = c * step; g < std::min(groups.size(), (c + 1) * step); ++g)
            body(g, std::span<const std::uint32_t>{groups.members.data() + groups.begin[g],
                                                   groups.begin[g + 1] - groups.begin[g]});
    });
}

}  // namespace

void sum_groups(VoteSums& sums, const VertexGroups& groups, const Topology& topology, const AttributeInput& input,
                const AttributeOptions& options, Context& context) {
    if (!options.normals) return;
    const Voters voters(topology, input, options);
    std::vector<std::vector<std::uint32_t>> cancelled(groups.size() / groups_per_chunk + 1);
    for_each_list(groups, context, [&](std::size_t c) {
        return [&, c](std::size_t g, std::span<const std::uint32_t> members) {
            NormalRow sum{};
            for (const std::uint32_t v : members)
                if (voters.votes(v)) add(sum, sums.normals[v].normal, sums.normals[v].weight);
            if (!(sum.weight > 0)) return;
            if (has_cancelled(sum)) return cancelled[c].push_back(std::uint32_t(g));
            if (voters.has_locked()) sum.normal = authored_or(sum, members, sums, topology, input);
            for (const std::uint32_t v : members) sums.normals[v] = sum;
        };
    });
    for (const auto& part : cancelled)
        sums.cancelled_groups.insert(sums.cancelled_groups.end(), part.begin(), part.end());
}

void average_tangents(VoteSums& sums, const VertexGroups& groups, const Topology& topology, const AttributeInput& input,
                      const AttributeOptions& options, Context& context) {
    if (!sums.has_tangents()) return;
    const Voters voters(topology, input, options);
    const std::vector<std::uint32_t>& cancelled = sums.cancelled_groups;
    for_each_list(groups, context, [&](std::size_t) {
        return [&, tangents = TangentGroups()](std::size_t g, std::span<const std::uint32_t> members) mutable {
            const bool has_votes = std::any_of(members.begin(), members.end(), [&](std::uint32_t v) {
                return voters.votes(v) && sums.normals[v].weight > 0;
            });
            if (!has_votes || std::binary_search(cancelled.begin(), cancelled.end(), g)) return;
            dvec3 normal = sums.normals[members[0]].normal;
            if (!options.normals) {
                const std::uint32_t v = topology.source_of(input, members[0]), m = input.mesh_of_vertex(v);
                normal = given_normal(input.placements[m], input.meshes[m].normals[v - input.vertex_base[m]]);
            }
            tangents.average(direction_of(normal).unit, members, sums.tangents.data());
        };
    });
}

std::vector<std::uint32_t> cancelled_vertices(const VoteSums& sums, const Topology& topology,
                                              const AttributeInput& input, Context& context) {
    const std::size_t count = topology.group.size(), step = vertices_per_chunk;
    std::vector<std::vector<std::uint32_t>> found((count + step - 1) / step);
    context.parallel_for(found.size(), [&](std::size_t c) {
        for (std::size_t row = c * step; row < std::min(count, (c + 1) * step); ++row) {
            if (!(sums.normals[row].weight > 0) || !has_cancelled(sums.normals[row])) continue;
            const std::uint32_t v = topology.source_of(input, std::uint32_t(row)), m = input.mesh_of_vertex(v);
            if (!is_locked(input.meshes[m], v - input.vertex_base[m])) found[c].push_back(std::uint32_t(row));
        }
    });
    std::vector<std::uint32_t> all;
    for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace rakelight::geometry
