// SPDX-License-Identifier: Apache-2.0
#include "geometry/creases/round_corners.h"

#include <algorithm>
#include <cmath>

#include <rakelight/geometry/creases.h>

namespace rakelight::geometry {
namespace {

constexpr double most_deg = 25;         // less than the usual chamfers
constexpr double as_much = 0.85;        // of the bend
constexpr double bends_on_least = 0.3;  // of the bend, at the next edges of a curve
constexpr double begins_least = 1.5;    // the same, where a curve begins
constexpr double similar_strips = 2.5;
constexpr int most_steps = 64;   // faces of one plane around a place
constexpr int most_rounds = 32;  // how far an edge that stays hard reaches others

/// The border edge of a plane that follows another around one of its ends; no_edge: it is open, or not found.
/// @param corner   of the edge, in a face of the plane
/// @param at_end   around the end of the edge, else around its start
std::uint32_t edge_beside(const BentEdges& bent, std::uint32_t corner, bool at_end) {
    const std::uint32_t plane = bent.plane_of[corner / 3];
    for (int step = 0; step < most_steps; ++step) {
        const std::uint32_t other = at_end ? corner_after(corner) : corner_before(corner),
                            e = bent.edge_of_corner[other];
        if (e == no_edge) return no_edge;
        const BentEdge& edge = bent.edges[e];
        const int beyond = edge.corner[0] == other ? 1 : 0;
        if (bent.plane(edge, beyond) != plane) return e;
        corner = edge.corner[beyond];
        at_end ^= bent.is_turned(edge);
    }
    return no_edge;
}

class SecondLook {
public:
    SecondLook(const BentEdges& bent, const std::vector<PlaneSide>& widths, std::vector<CreaseDecision>& decisions)
        : bent_(bent), widths_(widths), decisions_(decisions), may_soften_(decisions.size(), 0) {
        for (std::uint32_t e = 0; e < decisions.size(); ++e) {
            if (!decisions[e].is_hard || !is_of_planes(decisions[e].reason) || size(e) > round_most_deg) continue;
            may_soften_[e] = 1, left_.push_back(e);
        }
    }

    /// All that may soften support each other, until no more of them drop out.
    void soften(Context& context) {
        std::vector<std::uint8_t> holds;
        for (int round = 0; round < most_rounds; ++round) {
            constexpr std::size_t step = 1u << 14;
            holds.assign(left_.size(), 0);
            context.parallel_for((left_.size() + step - 1) / step, [&](std::size_t c) {
                for (std::size_t i = c * step; i < std::min(left_.size(), (c + 1) * step); ++i)
                    holds[i] = is_round(left_[i]);
            });
            std::size_t kept = 0;
            for (std::size_t i = 0; i < left_.size(); ++i) {
                may_soften_[left_[i]] = holds[i];
                if (holds[i] != 0) left_[kept++] = left_[i];
            }
            if (kept == left_.size()) break;
            left_.resize(kept);
        }
        for (const std::uint32_t e : left_) decisions_[e] = {CreaseReason::tangent, false};
    }

private:
    static bool is_of_planes(CreaseReason reason) {
        return reason == CreaseReason::planes || reason == CreaseReason::loose || reason == CreaseReason::chamfer;
    }
    double size(std::uint32_t e) const { return std::fabs(double(bent_.edges[e].bend_deg)); }
    bool is_soft(std::uint32_t e) const { return !decisions_[e].is_hard || may_soften_[e] != 0; }

    bool is_round(std::uint32_t e) const {
        bool is_strip = false, is_crossed = true;
        for (const int side : {0, 1}) {
            bool bends = true;
            for (const bool at_end : {false, true}) {
                const std::uint32_t beside = edge_beside(bent_, bent_.edges[e].corner[side], at_end);
                if (beside == no_edge || beside == e || !is_soft(beside)) return false;
                is_crossed &= !decisions_[beside].is_hard;
                bends &= !decisions_[beside].is_hard && size(beside) >= as_much * size(e);
            }
            is_strip |= bends;
        }
        if (is_strip && size(e) <= most_deg && decisions_[e].reason == CreaseReason::planes) return true;
        return is_crossed && is_in_curve(e);
    }

    /// A ring of a turned shape: alone among soft ones if it bends little, or the curve bends on beyond both strips, or
    /// beyond one by much more, and back at the other side.
    bool is_in_curve(std::uint32_t e) const {
        int known = 0, soft = 0, bends_on = 0, begins = 0, turns_back = 0;
        for (const int side : {0, 1}) {
            const std::uint32_t far = widths_[2 * std::size_t(e) + std::size_t(side)].far;
            if (far == no_edge) continue;
            const double ratio = double(bent_.edges[far].bend_deg) / double(bent_.edges[e].bend_deg);
            ++known, turns_back += ratio < 0;
            if (!is_soft(far)) continue;
            ++soft, bends_on += ratio >= bends_on_least, begins += ratio >= begins_least;
        }
        const double a = double(widths_[2 * std::size_t(e)].width), b = double(widths_[2 * std::size_t(e) + 1].width);
        const bool is_similar = std::max(a, b) <= similar_strips * std::min(a, b), is_small = size(e) <= most_deg;
        const bool is_alone = soft == known && soft > 0;
        return (is_small && is_alone) ||
               (is_similar && (bends_on == 2 || (is_small && begins == 1 && turns_back == 1)));
    }

    const BentEdges& bent_;
    const std::vector<PlaneSide>& widths_;
    std::vector<CreaseDecision>& decisions_;
    std::vector<std::uint8_t> may_soften_;  // [edges]
    std::vector<std::uint32_t> left_;       // edges that may soften, ascending
};

}  // namespace

void soften_round_corners(const BentEdges& bent, const std::vector<PlaneSide>& widths,
                          std::vector<CreaseDecision>& decisions, Context& context) {
    SecondLook(bent, widths, decisions).soften(context);
}

}  // namespace rakelight::geometry
