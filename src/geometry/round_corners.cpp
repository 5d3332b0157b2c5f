// SPDX-License-Identifier: Apache-2.0
#include "geometry/round_corners.h"

#include <algorithm>
#include <cmath>

namespace rakelight::geometry {
namespace {

constexpr double most_deg = 25;   // less than the usual chamfers
constexpr double as_much = 0.85;  // of the bend
constexpr int most_steps = 64;    // faces of one plane around a place

std::uint32_t next(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
std::uint32_t before(std::uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

/// The border edge of a plane that follows another around one of its ends; no_edge: it is open, or not found.
/// @param corner   of the edge, in a face of the plane
/// @param at_end   around the end of the edge, else around its start
std::uint32_t edge_beside(const BentEdges& bent, std::uint32_t corner, bool at_end) {
    const std::uint32_t plane = bent.plane_of[corner / 3];
    for (int step = 0; step < most_steps; ++step) {
        const std::uint32_t other = at_end ? next(corner) : before(corner), e = bent.edge_of_corner[other];
        if (e == no_edge) return no_edge;
        const BentEdge& edge = bent.edges[e];
        const int beyond = edge.corner[0] == other ? 1 : 0;
        if (bent.plane(edge, beyond) != plane) return e;
        corner = edge.corner[beyond];
    }
    return no_edge;
}

bool is_at_round_corner(const BentEdges& bent, const std::vector<CreaseDecision>& decisions, std::uint32_t e) {
    const BentEdge& edge = bent.edges[e];
    const double least = as_much * std::fabs(double(edge.bend_deg));
    bool is_strip = false;
    for (const int side : {0, 1}) {
        bool is_round = true;
        for (const bool at_end : {false, true}) {
            const std::uint32_t beside = edge_beside(bent, edge.corner[side], at_end);
            if (beside == no_edge || beside == e || decisions[beside].is_hard) return false;
            is_round &= std::fabs(double(bent.edges[beside].bend_deg)) >= least;
        }
        is_strip |= is_round;
    }
    return is_strip;
}

}  // namespace

void soften_round_corners(const BentEdges& bent, std::vector<CreaseDecision>& decisions, Context& context) {
    constexpr std::size_t step = 1u << 15;
    std::vector<std::vector<std::uint32_t>> found((decisions.size() + step - 1) / step);
    context.parallel_for(found.size(), [&](std::size_t c) {
        for (std::size_t e = c * step; e < std::min(decisions.size(), (c + 1) * step); ++e) {
            if (decisions[e].reason != CreaseReason::planes || !decisions[e].is_hard) continue;
            if (std::fabs(double(bent.edges[e].bend_deg)) > most_deg) continue;
            if (is_at_round_corner(bent, decisions, std::uint32_t(e))) found[c].push_back(std::uint32_t(e));
        }
    });
    for (const std::vector<std::uint32_t>& some : found)
        for (const std::uint32_t e : some) decisions[e] = {CreaseReason::tangent, false};
}

}  // namespace rakelight::geometry
