// SPDX-License-Identifier: Apache-2.0
#include "geometry/creases/plane_widths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "geometry/input/face_vote.h"
#include "math/functions.h"

namespace rakelight::geometry {
namespace {

constexpr double far_share = 0.3;        // of the width: an edge nearer than this is at the same side
constexpr double same_distance = 1e-3;   // of the width: edges at one distance from the first
constexpr std::size_t most_pairs = 128;  // edges of a plane that are compared with all others

/// An edge at the border of a plane.
struct Border {
    std::uint32_t edge;  // no_edge: an open edge
    std::uint32_t side;
    dvec3 from, middle, along;
    double bend_deg;  // of the edge
};

double distance_from_line(dvec3 q, dvec3 along) { return length(q - along * dot(q, along)); }

/// The farthest candidate. Of several at one distance one that bends as the edge itself, for the side of a strip may
/// end at other faces here and there; then the one straight across.
struct Farthest {
    double width = 0, distance = 0, shift = 0;
    std::uint32_t edge = no_edge;
    bool is_equal = false;

    void see(const Border& from, const Border& b) {
        if (b.edge == no_edge || b.edge == from.edge || std::fabs(dot(b.along, from.along)) < parallel_edges) return;
        const dvec3 q = b.middle - from.middle;
        const double d = distance_from_line(q, from.along), s = std::fabs(dot(q, from.along));
        if (d < far_share * width) return;
        const double slack = same_distance * width;
        const bool bends_equally = std::fabs(b.bend_deg - from.bend_deg) < equal_bends * std::fabs(from.bend_deg);
        const bool is_better = bends_equally != is_equal ? bends_equally : s < shift;
        if (edge != no_edge && (d < distance - slack || (d <= distance + slack && !is_better))) return;
        distance = std::max(d, distance), shift = s, edge = b.edge, is_equal = bends_equally;
    }
    PlaneSide side() const { return {float(width), edge}; }
};

void compare_all(std::span<const Border> borders, std::vector<PlaneSide>& out) {
    for (const Border& b : borders) {
        if (b.edge == no_edge) continue;
        Farthest far;
        for (const Border& o : borders) far.width = std::max(far.width, distance_from_line(o.from - b.from, b.along));
        for (const Border& o : borders) far.see(b, o);
        out[2 * std::size_t(b.edge) + b.side] = far.side();
    }
}

/// The extremes of a plane of many edges in a number of directions, over all corners and over the edges of each
/// direction. Distances are exact to a thousandth of the plane's size.
class Extremes {
public:
    explicit Extremes(std::span<const Border> borders) : borders_(borders), edges_(sectors * looks, none) {
        make_frame();
        for (std::uint32_t i = 0; i < looks; ++i) {
            const double a = 2 * pi * i / looks;
            look_[i] = x_ * math::cos(a) + y_ * math::sin(a);
        }
        corners_.fill(0);
        for (std::uint32_t b = 0; b < borders.size(); ++b) see(b);
    }

    PlaneSide across(const Border& b) const {
        Farthest far;
        const std::uint32_t across = look_of(cross(normal_, b.along)), other = (across + looks / 2) % looks;
        for (const std::uint32_t i : {across, other})
            far.width = std::max(far.width, distance_from_line(borders_[corners_[i]].from - b.from, b.along));
        for (std::uint32_t s = 0; s < sectors; ++s)
            for (const std::uint32_t i : {across, other})
                if (edges_[s * looks + i] != none) far.see(b, borders_[edges_[s * looks + i]]);
        return far.side();
    }

private:
    static constexpr std::uint32_t sectors = 36, looks = 72, none = 0xffffffffu;

    void make_frame() {
        std::size_t longest = 0;
        double most = -1;
        for (std::size_t i = 0; i < borders_.size(); ++i)
            if (const double d = length(borders_[i].middle - borders_[i].from); d > most) most = d, longest = i;
        x_ = borders_[longest].along;
        dvec3 sum;
        for (const Border& b : borders_) {  // the plane that holds most directions
            const dvec3 n = cross(x_, b.along);
            sum += dot(n, sum) < 0 ? -n : n;
        }
        normal_ = normalize_or(sum, any_across(x_));
        y_ = cross(normal_, x_);
    }
    static dvec3 any_across(dvec3 x) {
        return normalize_or(cross(x, std::fabs(x.x) < 0.5 ? dvec3{1, 0, 0} : dvec3{0, 1, 0}), dvec3{0, 0, 1});
    }

    std::uint32_t turn_of(dvec3 d, std::uint32_t count, double circle) const {
        double a = math::atan2(dot(d, y_), dot(d, x_) + 0.0);  // 0 for no direction: no zero is negative then
        while (a < 0) a += circle;
        return std::uint32_t(a / circle * count + 0.5) % count;
    }
    std::uint32_t look_of(dvec3 d) const { return turn_of(d, looks, 2 * pi); }

    void see(std::uint32_t at) {
        const Border& b = borders_[at];
        const std::uint32_t sector = b.edge == no_edge ? none : turn_of(b.along, sectors, pi);
        for (std::uint32_t i = 0; i < looks; ++i) {
            if (dot(b.from, look_[i]) > dot(borders_[corners_[i]].from, look_[i])) corners_[i] = at;
            if (sector == none) continue;
            std::uint32_t& best = edges_[sector * looks + i];
            if (best == none || dot(b.middle, look_[i]) > dot(borders_[best].middle, look_[i])) best = at;
        }
    }

    std::span<const Border> borders_;
    dvec3 x_, y_, normal_;
    std::array<dvec3, looks> look_;
    std::array<std::uint32_t, looks> corners_;
    std::vector<std::uint32_t> edges_;  // [sectors][looks]
};

/// The faces of each plane, planes in the order of their smallest face.
struct PlaneFaces {
    std::vector<std::uint32_t> begin, faces;
};
PlaneFaces faces_of_planes(const std::vector<std::uint32_t>& plane_of) {
    PlaneFaces out;
    std::vector<std::uint32_t> number(plane_of.size());
    out.begin.assign(2, 0);
    std::uint32_t planes = 0;
    for (std::uint32_t t = 0; t < plane_of.size(); ++t)
        if (plane_of[t] == t) number[t] = planes++;
    out.begin.assign(std::size_t(planes) + 2, 0);
    for (const std::uint32_t p : plane_of) ++out.begin[number[p] + 2];
    std::partial_sum(out.begin.begin(), out.begin.end(), out.begin.begin());
    out.faces.resize(plane_of.size());
    for (std::uint32_t t = 0; t < plane_of.size(); ++t) out.faces[out.begin[number[plane_of[t]] + 1]++] = t;
    out.begin.pop_back();
    return out;
}

void gather_borders(const BentEdges& bent, const AttributeInput& input, std::span<const std::uint32_t> faces,
                    std::vector<Border>& out) {
    out.clear();
    for (const std::uint32_t t : faces) {
        if (!bent.is_face[t]) continue;
        const FacePoints f = face_points(input, t);
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t e = bent.edge_of_corner[3 * t + k];
            if (e != no_edge && bent.plane(bent.edges[e], 0) == bent.plane(bent.edges[e], 1)) continue;
            const dvec3 a = f.p[k], b = f.p[(k + 1) % 3];
            out.push_back({e, e != no_edge && bent.edges[e].corner[0] != 3 * t + k, a, (a + b) * 0.5,
                           direction_of(b - a).unit, e == no_edge ? 0 : double(bent.edges[e].bend_deg)});
        }
    }
}

}  // namespace

std::vector<PlaneSide> plane_widths(const BentEdges& bent, const AttributeInput& input, Context& context) {
    std::vector<PlaneSide> out(2 * bent.edges.size());
    const PlaneFaces planes = faces_of_planes(bent.plane_of);
    constexpr std::size_t step = 1024;
    const std::size_t count = planes.begin.size() - 1;
    context.parallel_for((count + step - 1) / step, [&](std::size_t c) {
        std::vector<Border> borders;
        for (std::size_t p = c * step; p < std::min(count, (c + 1) * step); ++p) {
            const std::size_t first = planes.begin[p];
            gather_borders(bent, input, std::span(planes.faces).subspan(first, planes.begin[p + 1] - first), borders);
            if (borders.size() <= most_pairs) {
                compare_all(borders, out);
                continue;
            }
            const Extremes extremes(borders);
            for (const Border& b : borders)
                if (b.edge != no_edge) out[2 * std::size_t(b.edge) + b.side] = extremes.across(b);
        }
    });
    return out;
}

}  // namespace rakelight::geometry
