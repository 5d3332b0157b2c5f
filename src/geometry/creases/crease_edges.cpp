// SPDX-License-Identifier: Apache-2.0
// Stages: edges with their bends and planes -> widths of planes -> the rule -> bits of faces and the report.
#include "geometry/creases/crease_edges.h"

#include <algorithm>
#include <cmath>

#include "geometry/creases/across_faces.h"
#include "geometry/creases/crease_rule.h"
#include "geometry/creases/round_corners.h"

namespace rakelight::geometry {
namespace {

constexpr double facets_deg = 30;  // a smooth surface of single triangles that bends more may be meant hard
constexpr std::uint32_t least_ring = 5, most_ring = 12;
constexpr double cosine_of_soft = 0.9902680687415704;
static_assert(soft_below_deg == 8 && soft_below_deg - thresholds_move_deg == 6);

void check_memory(const AttributeInput& input, Context& context) {
    const std::uint64_t vertices = input.vertex_count(), triangles = input.triangle_count();
    context.memory().check(vertices * 12 + triangles * (24 + 100 + 3 * (sizeof(BentEdge) + 2 * sizeof(PlaneSide)) / 2),
                           "finding creases");
}

/// Counts closed rings of planes with equal bends.
class Rings {
public:
    Rings(const BentEdges& bent, const AttributeInput& input, const std::vector<CreaseDecision>& decisions)
        : bent_(bent), input_(input), decisions_(decisions), seen_(bent.edges.size(), 0) {}

    void count(CreaseReport& report) {
        for (std::uint32_t e = 0; e < bent_.edges.size(); ++e)
            if (decisions_[e].reason == CreaseReason::chain && !seen_[e])
                if (const std::uint32_t n = ring_from(e); n != 0) ++report.rings[n];
    }

private:
    /// The number of sides of the ring at an edge, or 0. The edges of a ring are marked.
    std::uint32_t ring_from(std::uint32_t first) {
        std::uint32_t ring[most_ring], n = 0, e = first;
        int side = 1;
        do {
            if (n == most_ring || decisions_[e].reason != CreaseReason::chain || seen_[e]) return 0;
            ring[n++] = e;
            const Across way = across_plane(bent_, input_, e, side);
            e = way.edge, side = way.beyond;
            if (e == no_edge) return 0;
        } while (e != first);
        for (std::uint32_t i = 0; i < n; ++i) seen_[ring[i]] = 1;
        return n >= least_ring ? n : 0;
    }

    const BentEdges& bent_;
    const AttributeInput& input_;
    const std::vector<CreaseDecision>& decisions_;
    std::vector<std::uint8_t> seen_;
};

std::uint64_t count_smooth_surfaces(const BentEdges& bent, const std::vector<CreaseDecision>& decisions) {
    std::vector<std::uint8_t> marks(bent.surface_of.size(), 0);  // 1: may be meant with facets; 2: has other edges
    for (std::size_t i = 0; i < bent.edges.size(); ++i) {
        const BentEdge& e = bent.edges[i];
        const bool is_single =
            decisions[i].reason == CreaseReason::triangles || decisions[i].reason == CreaseReason::fan;
        std::uint8_t& mark = marks[bent.surface_of[e.face(0)]];
        if (is_single && !decisions[i].is_hard && std::fabs(double(e.bend_deg)) > facets_deg) mark |= 1;
        if (decisions[i].is_hard) mark |= 2;
    }
    return std::uint64_t(std::count(marks.begin(), marks.end(), 1));
}

CreaseReport report_of(const BentEdges& bent, const AttributeInput& input,
                       const std::vector<CreaseDecision>& decisions) {
    CreaseReport report;
    for (std::size_t i = 0; i < decisions.size(); ++i) {
        const double bend = std::fabs(double(bent.edges[i].bend_deg));
        if (bend <= double(bent.edges[i].slack_deg)) continue;
        if (!decisions[i].is_hard) {
            ++report.soft;
            report.soft_most_deg = std::max(report.soft_most_deg, bend);
            continue;
        }
        report.hard_least_deg = report.hard == 0 ? bend : std::min(report.hard_least_deg, bend);
        report.hard_most_deg = std::max(report.hard_most_deg, bend);
        ++report.hard;
    }
    Rings(bent, input, decisions).count(report);
    report.smooth_surfaces = count_smooth_surfaces(bent, decisions);
    return report;
}

void set_bits(const BentEdges& bent, const std::vector<CreaseDecision>& decisions, CreaseEdges& out) {
    out.bits.resize(bent.is_face.size());
    for (std::size_t t = 0; t < out.bits.size(); ++t)
        out.bits[t] = bent.is_face[t] ? std::uint8_t(bent.crowded[t] << 3) : std::uint8_t(7 << 3);
    for (std::size_t i = 0; i < decisions.size(); ++i) {
        const BentEdge& e = bent.edges[i];
        for (const int side : {0, 1}) {
            const std::uint32_t corner = e.corner[side];
            if (decisions[i].is_hard) out.bits[corner / 3] |= std::uint8_t(1u << corner % 3);
            if (e.is_crowded && !decisions[i].is_hard) out.partners.emplace_back(corner, e.corner[1 - side]);
        }
    }
    std::sort(out.partners.begin(), out.partners.end());
    // Unpaired faces at crowded edges.
    for (std::uint32_t t = 0; t < bent.is_face.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k)
            if ((bent.crowded[t] >> k & 1) != 0 && bent.edge_of_corner[3 * t + k] == no_edge)
                out.bits[t] |= std::uint8_t(1u << k);
}

}  // namespace

bool CreaseEdges::are_partners(std::uint32_t corner, std::uint32_t other) const {
    return std::binary_search(partners.begin(), partners.end(), std::pair(corner, other));
}

bool CreaseEdges::are_soft(std::uint32_t corner, std::uint32_t other, double cosine) const {
    if (!is_crowded(corner) && !is_crowded(other)) return !is_hard(corner) && !is_hard(other);
    return are_partners(corner, other) || cosine >= cosine_of_soft;
}

CreaseEdges decide_creases(const AttributeInput& input, const std::vector<std::uint32_t>& places,
                           const FaceNormals& normals, Context& context) {
    check_memory(input, context);
    const PlacedMeshes placed{input, places};
    const BentEdges bent = find_bent_edges(placed, normals, context);
    context.throw_if_cancelled();
    const std::vector<PlaneSide> widths = plane_widths(bent, input, context);
    std::vector<CreaseDecision> decisions = apply_crease_rule(bent, input, widths, context);
    soften_round_corners(bent, widths, decisions, context);
    CreaseEdges out;
    set_bits(bent, decisions, out);
    out.report = report_of(bent, input, decisions);
    return out;
}

}  // namespace rakelight::geometry
