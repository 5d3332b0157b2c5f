// SPDX-License-Identifier: Apache-2.0
#include "geometry/creases/crease_rule.h"

#include <algorithm>
#include <cmath>

#include <rakelight/geometry/creases.h>

#include "geometry/creases/across_faces.h"
#include "geometry/creases/meant_planes.h"

namespace rakelight::geometry {
namespace {

// Bends in degrees, all others are ratios.
constexpr double chamfer_over_deg = 32;  // two equal bends over this are a chamfer
constexpr double fillet_most_deg = 46;   // a fillet of two strips bends at most so in the middle
constexpr double equal_in_fan = 0.1;
constexpr double loosely_less = 0.45, loosely_more = 2.2;
constexpr double twice_least = 1.5, twice_most = 3;  // half a bend into a fillet
constexpr double onset_deg = 14, onset_most = 4;     // a curved shape may begin with a small bend, between equal strips
constexpr double same_width = 1.3, similar_width = 2.5, uneven_width = 4, strip_width = 1.6;

/// Thresholds in the gaps between the bends of the model.
struct Thresholds {
    double low = soft_below_deg, hard = always_hard_deg, round = round_most_deg, chamfer = chamfer_over_deg,
           fillet = fillet_most_deg, onset = onset_deg;
};

/// The middle of the widest gap of the values near a threshold, or the threshold if it lies in a gap wide enough.
double settled(double threshold, std::vector<float> near) {
    constexpr double clear_deg = 0.5;
    std::sort(near.begin(), near.end());
    std::vector<double> stops{threshold - thresholds_move_deg};
    for (const float x : near) stops.push_back(double(x));
    stops.push_back(threshold + thresholds_move_deg);
    double best = 0, at = threshold;
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const double low = stops[i], high = stops[i + 1];
        if (low + clear_deg <= threshold && threshold + clear_deg <= high) return threshold;
        if (high - low > best + 1e-3) best = high - low, at = 0.5 * (low + high);
    }
    return at;
}

Thresholds settle_thresholds(const BentEdges& bent) {
    Thresholds t;
    for (double* const threshold : {&t.low, &t.hard, &t.round, &t.chamfer, &t.fillet, &t.onset}) {
        std::vector<float> near;
        for (const BentEdge& e : bent.edges)
            if (std::fabs(std::fabs(double(e.bend_deg)) - *threshold) < thresholds_move_deg)
                near.push_back(std::fabs(e.bend_deg));
        *threshold = settled(*threshold, std::move(near));
    }
    return t;
}

class Rule {
public:
    Rule(const BentEdges& bent, const AttributeInput& input, const std::vector<PlaneSide>& widths)
        : bent_(bent),
          input_(input),
          widths_(widths),
          limits_(settle_thresholds(bent)),
          planes_(find_meant_planes(bent, limits_.hard)) {}

    CreaseDecision decide(std::uint32_t e) const {
        const BentEdge& edge = bent_.edges[e];
        const double bend = size(e);
        if (bend < limits_.low || bend <= double(edge.slack_deg)) return {CreaseReason::plane, false};
        if (bend >= limits_.hard) return {CreaseReason::steep, true};
        if (bend <= double(edge.rounding_deg)) return {CreaseReason::plane, false};
        if (bent_.plane(edge, 0) == bent_.plane(edge, 1) && planes_.has_planes[bent_.surface_of[edge.face(0)]] != 0)
            return {CreaseReason::planes, bend > 2 * double(edge.rounding_deg)};  // the end of a crease, or by rounding
        if (!is_flat(edge, 0) && !is_flat(edge, 1)) return decide_triangles(e);
        const CreaseDecision decision = decide_planes(e);
        if (decision.is_hard && bend <= limits_.round && has_three_across(e)) return {CreaseReason::chain, false};
        return decision;
    }

private:
    double size(std::uint32_t e) const { return std::fabs(double(bent_.edges[e].bend_deg)); }

    bool is_flat(const BentEdge& e, int side) const { return planes_.is_meant[bent_.plane(e, side)] != 0; }

    /// Whether edge `other` bends as much as `e` times a factor, within a share and the rounding of both.
    bool bends_as(std::uint32_t other, std::uint32_t e, double share) const {
        const BentEdge &a = bent_.edges[other], &b = bent_.edges[e];
        const double rounding = (double(a.slack_deg) + double(b.slack_deg)) / 3;
        return std::fabs(double(a.bend_deg) - double(b.bend_deg)) < share * size(e) + rounding;
    }

    // Single triangles: in a fan of equal bends (cone, pyramid) they count like a row, all else is organic.
    CreaseDecision decide_triangles(std::uint32_t e) const {
        const BentEdge& edge = bent_.edges[e];
        bool is_fan = true;
        for (const int side : {0, 1}) {
            bool has_equal = false;
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t other = bent_.edge_of_corner[3 * edge.face(side) + k];
                has_equal |= other != no_edge && other != e && bends_as(other, e, equal_in_fan);
            }
            is_fan &= has_equal;
        }
        if (!is_fan) return {CreaseReason::triangles, false};
        return {CreaseReason::fan,
                planes_.faces_of_surface[bent_.surface_of[edge.face(0)]] <= small_surface && size(e) > limits_.round};
    }

    const PlaneSide& side_of(std::uint32_t e, int side) const {
        return widths_[2 * std::size_t(e) + std::size_t(side)];
    }
    static bool are_similar(float a, float b) { return std::max(a, b) <= float(similar_width) * std::min(a, b); }

    /// Over a whole plane: to its far side.
    Across over(std::uint32_t e, int side) const {
        const PlaneSide& whole = side_of(e, side);
        if (whole.far == no_edge) return {whole.width, no_edge, 0};
        const bool is_first = bent_.plane(bent_.edges[whole.far], 0) != bent_.plane(bent_.edges[e], side);
        return {whole.width, whole.far, is_first ? 0 : 1};
    }

    /// Whether a third bend follows: a round shape. Two equal bends are a chamfer, and so are more between planes of
    /// unequal widths.
    /// @param way  (edge, side) -> Across
    template <class Way>
    bool has_three(std::uint32_t e, const Way& way) const {
        const Across sides[2] = {way(e, 0), way(e, 1)};
        const float thin = std::min(sides[0].width, sides[1].width), wide = std::max(sides[0].width, sides[1].width);
        const auto continues = [&](const Across& side) {
            return side.edge != no_edge && bends_as(side.edge, e, equal_bends);
        };
        if (continues(sides[0]) && continues(sides[1])) return wide <= float(same_width) * thin;
        for (const Across& side : sides) {
            if (!continues(side)) continue;
            const Across next = way(side.edge, side.beyond);
            if (are_similar(next.width, side.width) && continues(next)) return true;
        }
        return false;
    }
    bool has_three_over(std::uint32_t e) const {
        return has_three(e, [this](std::uint32_t edge, int side) { return over(edge, side); });
    }
    /// By what lies straight across: a ring of strips of which one is a flat annulus, a tube of which some sides are planes
    /// and others warped squares.
    bool has_three_across(std::uint32_t e) const {
        return are_similar(across(e, 0, e).width, across(e, 1, e).width) &&
               has_three(e, [this, e](std::uint32_t edge, int side) { return across(edge, side, e); });
    }

    /// Whether a plane runs into a strip that bends twice as much at its far side, or up to four times if it begins to
    /// curve with a small bend.
    bool is_tangent(std::uint32_t e, int narrow) const {
        const Across way = over(e, narrow);
        if (way.edge == no_edge) return false;
        if (size(way.edge) > limits_.round) return false;  // no fillet bends so much within itself
        const double ratio = double(bent_.edges[way.edge].bend_deg) / double(bent_.edges[e].bend_deg);
        if (ratio < twice_least || ratio > (size(e) < limits_.onset ? onset_most : twice_most)) return false;
        return side_of(way.edge, way.beyond).width <= strip_width * way.width;
    }

    /// Whether a plane runs into single triangles that are the bent squares of a fillet: the edge across the square bends
    /// on, as in `is_tangent`. The diagonal of the square is one of the two other edges of the triangle, and bends less.
    bool is_tangent_to_squares(std::uint32_t e) const {
        const BentEdge& edge = bent_.edges[e];
        for (const int side : {0, 1}) {
            if (is_flat(edge, side) || !is_flat(edge, 1 - side)) continue;
            for (const bool is_after : {false, true}) {
                const std::uint32_t far = across_square(bent_, e, side, limits_.low, is_after).edge;
                if (far == no_edge || size(far) > limits_.round) continue;
                const BentEdge& f = bent_.edges[far];
                if (is_flat(f, 0) || is_flat(f, 1)) continue;
                const double ratio = double(f.bend_deg) / double(edge.bend_deg);
                if (ratio >= twice_least && ratio <= twice_most) return true;
            }
        }
        return false;
    }

    /// Straight across one side of an edge, over a plane or over a bent square to an edge that bends as edge `like`.
    Across across(std::uint32_t e, int side, std::uint32_t like) const {
        if (is_flat(bent_.edges[e], side)) return across_plane(bent_, input_, e, side);
        for (const bool is_after : {false, true}) {
            Across way = across_square(bent_, e, side, limits_.low, is_after);
            if (way.edge == no_edge || !bends_as(way.edge, like, equal_bends)) continue;
            way.width = side_of(e, side).width;
            return way;
        }
        return {side_of(e, side).width, no_edge, 0};
    }

    CreaseDecision decide_planes(std::uint32_t e) const {
        const PlaneSide sides[2] = {side_of(e, 0), side_of(e, 1)};
        const int narrow = sides[0].width > sides[1].width ? 1 : 0;
        const double thin = double(sides[narrow].width), wide = double(sides[1 - narrow].width), bend = size(e);
        bool is_equal[2], is_half[2];
        int loose = 0, curved = 0;  // far bends of one order, and those of round shapes
        for (const int s : {0, 1}) {
            const std::uint32_t far = sides[s].far;
            const double ratio =
                far == no_edge ? 0 : double(bent_.edges[far].bend_deg) / double(bent_.edges[e].bend_deg);
            is_equal[s] = far != no_edge && bends_as(far, e, equal_bends);
            is_half[s] = std::fabs(ratio - 0.5) < 0.1;
            const bool is_loose = ratio >= loosely_less && ratio <= loosely_more;
            loose += is_loose, curved += is_loose && size(far) <= limits_.round;
        }
        const bool is_similar = wide <= similar_width * thin, is_same = wide <= same_width * thin;
        if (!is_same && is_tangent(e, narrow)) return {CreaseReason::tangent, false};
        if (is_same && bend < limits_.onset && (is_tangent(e, 0) || is_tangent(e, 1)))
            return {CreaseReason::tangent, false};
        if (is_half[0] && is_half[1] && is_same && bend <= limits_.fillet) return {CreaseReason::tangent, false};
        if ((is_equal[0] || is_equal[1]) && is_similar) {
            if (bend > limits_.chamfer && !has_three_over(e)) return {CreaseReason::chamfer, true};
            return {CreaseReason::chain, bend > limits_.round};
        }
        if (loose > 0 && wide <= (loose == 2 ? uneven_width : similar_width) * thin)
            return {CreaseReason::loose, bend > (curved == 2 && is_similar ? limits_.round : limits_.chamfer)};
        if (is_tangent_to_squares(e)) return {CreaseReason::tangent, false};
        return {CreaseReason::planes, true};
    }

    const BentEdges& bent_;
    const AttributeInput& input_;
    const std::vector<PlaneSide>& widths_;
    Thresholds limits_;
    MeantPlanes planes_;
};

}  // namespace

std::vector<CreaseDecision> apply_crease_rule(const BentEdges& bent, const AttributeInput& input,
                                              const std::vector<PlaneSide>& widths, Context& context) {
    constexpr std::size_t step = 1u << 15;
    std::vector<CreaseDecision> out(bent.edges.size());
    const Rule rule(bent, input, widths);
    context.parallel_for((out.size() + step - 1) / step, [&](std::size_t c) {
        for (std::size_t e = c * step; e < std::min(out.size(), (c + 1) * step); ++e)
            out[e] = rule.decide(std::uint32_t(e));
    });
    return out;
}

}  // namespace rakelight::geometry
