// SPDX-License-Identifier: Apache-2.0
#include "geometry/borders/border_fits.h"

#include <algorithm>
#include <array>

#include "geometry/fits/fit_trust.h"

namespace rakelight::geometry {
namespace {

constexpr std::size_t rings_per_chunk = 64;
constexpr std::uint32_t none = 0xffffffffu;

/// [edges] From where to where a gap takes the trust from a fit.
constexpr double no_gap = 0.04, full_gap = 0.12;

/// Factor on what CornerWeight::automatic lets a fit leave unexplained: what else is known, the votes of sides that end
/// here, is worse here than inside of a surface.
constexpr double most_unexplained = 2;

/// What is known at a node with a ring.
struct Fitted {
    HeightFit cubic, quadric, wide;
    FitQuality around_cubic, around_quadric;  ///< sums over leaders of the same edges
    std::size_t neighbors = 0;
    dvec3 faces;                          ///< sum of the normals of faces of both sides, then their unit mean
    std::array<dvec3, 2> side;            ///< the same of its own side, of the other
    double spread_rad = 0, side_rad = 0;  ///< of faces from the mean of all, from that of their side
    double nearest = 0;                   ///< distance of a neighbor, in the unit of the fit
    double followers = 0;                 ///< per leader
    double gap = 0;                       ///< [edges] sum over followers
};

class BorderFits {
public:
    BorderFits(const AttributeInput& input, const BorderNodes& nodes, std::span<const BorderLink> links,
               const BorderRings& rings, const BorderVotes& votes)
        : input_(input),
          nodes_(nodes),
          links_(links),
          rings_(rings),
          votes_(votes),
          all_(rings.node.size()),
          ring_of_(nodes.count(), none) {
        for (std::uint32_t r = 0; r < rings.node.size(); ++r) ring_of_[rings.node[r]] = r;
    }

    void run(Context& context) {
        const std::size_t count = all_.size(), chunks = (count + rings_per_chunk - 1) / rings_per_chunk;
        context.parallel_for(chunks, [&](std::size_t c) {
            std::vector<dvec3> neighbors;
            for (std::size_t r = c * rings_per_chunk; r < std::min(count, (c + 1) * rings_per_chunk); ++r)
                fit(r, neighbors);
        });
        look_around();
        look_at_faces();
        each_leader([&](const BorderLink& link, std::uint32_t r, double share) {
            all_[r].followers += share, all_[r].gap += share * gap_of(link);
        });
        for (std::size_t r = 0; r < count; ++r)
            if (const std::uint32_t node = rings_.node[r]; votes_.changes[node] != 0)
                votes_.normals[node] = decided(all_[r], votes_.normals[node], votes_.by_angle[node]);
    }

private:
    dvec3 position_of_vertex(std::uint32_t v) const {
        const std::uint32_t m = input_.mesh_of_vertex(v);
        return input_.placements[m].position(input_.meshes[m].positions[v - input_.vertex_base[m]]);
    }
    dvec3 position(std::uint32_t member) const { return position_of_vertex(nodes_.members[member]); }

    /// body(link, ring of a leader, its share)
    template <class Body>
    void each_leader(const Body& body) const {
        for (const BorderLink& link : links_) {
            if (link.counts_a() && ring_of_[link.node_a] != none) body(link, ring_of_[link.node_a], 1 - link.t);
            if (link.counts_b() && ring_of_[link.node_b] != none) body(link, ring_of_[link.node_b], link.t);
        }
    }

    void fit(std::size_t r, std::vector<dvec3>& neighbors) {
        const std::uint32_t node = rings_.node[r];
        const dvec3 at = position(nodes_.member_begin[node]);
        neighbors.clear();
        double squares = 0;
        for (const std::uint32_t v : rings_[r]) {
            neighbors.push_back(position_of_vertex(v) - at);
            squares += dot(neighbors.back(), neighbors.back());
        }
        if (!(squares > 1e-280 && squares < 1e280)) return;
        const double scale = 1 / std::sqrt(squares / double(neighbors.size()));
        for (dvec3& d : neighbors) d = d * scale;
        all_[r].neighbors = neighbors.size(), all_[r].nearest = length(neighbors.front());
        HeightBatch batch;
        batch.add(neighbors, 1, votes_.normals[node]);
        batch.fit();
        all_[r].cubic = batch.cubic(0), all_[r].quadric = batch.quadric(0);
        batch.fit_wide();
        all_[r].wide = batch.wide(0);
    }

    void look_around() {
        const auto look = [&](std::uint32_t at, std::uint32_t other) {
            if (at == none || other == none) return;
            all_[at].around_cubic += FitQuality::of(all_[other].cubic, all_[other].neighbors, HeightForm::cubic);
            all_[at].around_quadric += FitQuality::of(all_[other].quadric, all_[other].neighbors, HeightForm::quadric);
        };
        for (const BorderLink& link : links_)
            look(ring_of_[link.node_a], ring_of_[link.node_b]), look(ring_of_[link.node_b], ring_of_[link.node_a]);
    }

    /// body(unit normal)
    template <class Body>
    void each_face(std::uint32_t node, const Body& body) const {
        for (std::uint32_t i = nodes_.member_begin[node]; i < nodes_.member_begin[node + 1]; ++i) {
            const std::uint32_t m = input_.mesh_of_vertex(nodes_.members[i]);
            for (const std::uint32_t corner : nodes_.corners_of(i)) {
                const std::uint32_t* const index =
                    input_.meshes[m].indices.data() + (corner - corner % 3 - 3 * input_.triangle_base[m]);
                const Direction normal = face_normal(input_.placements[m], face_corners(input_.meshes[m], index));
                if (normal.unit != dvec3{}) body(normal.unit);
            }
        }
    }
    /// body(node with a ring, side, unit normal)
    template <class Body>
    void each_face_of_both(const Body& body) {
        for (std::uint32_t r = 0; r < all_.size(); ++r)
            each_face(rings_.node[r], [&](dvec3 n) { body(all_[r], 0, n); });
        each_leader([&](const BorderLink& link, std::uint32_t r, double) {
            each_face(link.node, [&](dvec3 n) { body(all_[r], 1, n); });
        });
    }
    void look_at_faces() {
        each_face_of_both([](Fitted& f, std::size_t side, dvec3 n) { f.faces += n, f.side[side] += n; });
        for (Fitted& f : all_) {
            f.faces = normalize_or(f.faces, {});
            for (dvec3& side : f.side) side = normalize_or(side, f.faces);
        }
        each_face_of_both([](Fitted& f, std::size_t side, dvec3 n) {
            f.spread_rad = std::max(f.spread_rad, angle_rad(n, f.faces));
            f.side_rad = std::max(f.side_rad, angle_rad(n, f.side[side]));
        });
    }

    /// [edges] How far a follower is off the leading edge and the arc over it that the normals at its ends span.
    double gap_of(const BorderLink& link) const {
        const dvec3 a = position(link.member_a), along = position(link.member_b) - a, na = votes_.normals[link.node_a],
                    nb = votes_.normals[link.node_b], n = normalize_or(na * (1 - link.t) + nb * link.t, na);
        const double rise = 0.5 * link.t * (1 - link.t) * dot(nb - na, along), edge = dot(along, along);
        const dvec3 off = position(nodes_.member_begin[link.node]) - (a + along * link.t + n * rise);
        const double share = dot(off, off) / edge;
        return share < 1 ? std::sqrt(share) : 1;  // 1 too where a position is not finite
    }

    /// The rules of CornerWeight::automatic. @param by_max  unit
    static dvec3 decided(const Fitted& f, dvec3 by_max, dvec3 by_angle) {
        if (f.faces == dvec3{}) return by_max;
        const double planarity = 1 - step_between(f.side_rad, 0.05 * f.spread_rad, 0.3 * f.spread_rad + 1e-9);
        const double strict = most_unexplained * strictness(planarity);
        const double noise = noise_of(f.cubic, f.neighbors, HeightForm::cubic),
                     of_quadric = noise_of(f.quadric, f.neighbors, HeightForm::quadric);
        const double shape = share_of_shape(planarity, noise, of_quadric);
        const double wide = (1 - planarity) * trust_in_wide(f),
                     quadric = steadiness(f, of_quadric / (1 + 2 * shape)) *
                               trust_in(f.quadric, f.neighbors, HeightForm::quadric, f.around_quadric, strict),
                     cubic =
                         steadiness(f, noise / (1 + 2 * shape)) *
                         trust_in(f.cubic, f.neighbors, HeightForm::cubic, f.around_cubic, strict * (1 + 2 * shape));
        const double near = 1 - step_between(f.gap / std::max(f.followers, 1e-9), no_gap, full_gap);
        dvec3 n = blend(normalize_or(by_angle, by_max), by_max, std::max(quadric, cubic));
        n = blend(n, f.wide.normal, wide * near);
        n = blend(blend(n, f.quadric.normal, quadric * near), f.cubic.normal, cubic * near);
        return bounded(n, f.faces, f.spread_rad + radians(1));
    }

    /// [unit of the fit] unexplained height per degree of freedom
    static double noise_of(const HeightFit& fit, std::size_t neighbors, HeightForm form) {
        return std::sqrt(double(FitQuality::of(fit, neighbors, form).noise));
    }

    /// 0 to 1: whether the slope that noise makes toward the nearest neighbor is small beside the spread of the faces.
    static double steadiness(const Fitted& f, double noise) {
        return 1 - step_between(noise, 0.1 * f.nearest * f.spread_rad, 0.3 * f.nearest * f.spread_rad + 1e-12);
    }

    /// 0 to 1: where faces spread little and neither side is much finer, a smooth surface with noise is likely.
    static double trust_in_wide(const Fitted& f) {
        if (f.neighbors < least_around) return 0;
        return (1 - step_between(f.spread_rad, radians(6), radians(10))) * (1 - step_between(f.followers, 2, 4)) *
               trust_of_certainty(f.wide.certainty);
    }

    const AttributeInput& input_;
    const BorderNodes& nodes_;
    std::span<const BorderLink> links_;
    const BorderRings& rings_;
    const BorderVotes& votes_;
    std::vector<Fitted> all_;             ///< [rings]
    std::vector<std::uint32_t> ring_of_;  ///< [nodes]
};

}  // namespace

void fit_borders(const AttributeInput& input, const BorderNodes& nodes, std::span<const BorderLink> links,
                 const BorderRings& rings, const BorderVotes& votes, Context& context) {
    context.memory().check(rings.node.size() * sizeof(Fitted) + nodes.count() * 4ull, "fitting borders");
    BorderFits(input, nodes, links, rings, votes).run(context);
}

}  // namespace rakelight::geometry
