// SPDX-License-Identifier: Apache-2.0
// Place by place, the pairs of parts that meet there; then the angles of each pair of objects together.
#include "tools/inspect/borders.h"

#include <algorithm>
#include <tuple>

#include "geometry/input/face_vote.h"
#include "tools/inspect/border_corners.h"
#include "tools/inspect/place_angles.h"

namespace rakelight {
namespace {

/// What one pair of objects is at one place; of two meshes of one object if a == b.
struct Meeting {
    std::uint32_t a, b, place;
    std::uint32_t part_a, part_b;  ///< whose angle `before_deg` is
    float before_deg, after_deg;
    bool joined;
    auto pair() const { return std::pair(a, b); }
};

double mean_of(const std::vector<float>& values) {
    double sum = 0;
    for (const float v : values) sum += v;
    return values.empty() ? 0 : sum / double(values.size());
}

/// The value that `rank` others are not above.
double ranked(std::vector<float>& values, std::size_t rank) {
    const auto at = values.begin() + std::ptrdiff_t(rank);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

AngleSummary summarize(std::vector<float>& values) {
    if (values.empty()) return {};
    return {*std::max_element(values.begin(), values.end()), mean_of(values),
            ranked(values, (95 * values.size() + 99) / 100 - 1)};
}

class BorderFinder {
public:
    BorderFinder(const geometry::PlacedMeshes& placed, const SeamNormals& normals)
        : placed_(placed), normals_(normals) {}

    BorderReport run(Context& context) {
        const std::vector<BorderCorner> corners = find_border_corners(placed_, normals_, context);
        constexpr std::uint64_t bytes_per_corner =
            4 * sizeof(Meeting);  // 28 meetings of 8 corners at most, and a few numbers
        context.memory().check(corners.size() * bytes_per_corner, "the borders of all objects");
        for (std::size_t i = 0; i < corners.size();) {
            std::size_t end = i + 1;
            while (end < corners.size() && corners[end].place == corners[i].place) ++end;
            visit_place({corners.data() + i, end - i});
            i = end;
        }
        report_.totals.before = summarize(worst_before_);
        report_.totals.after = summarize(worst_after_);
        summarize_pairs();
        return std::move(report_);
    }

private:
    dvec3 normal(std::uint32_t part, const PartNormals& normals, std::uint32_t vertex) const {
        return geometry::given_normal(placed_.input.placements[part], normals.normal(vertex));
    }

    std::uint32_t object_of(std::uint32_t part) const { return placed_.input.meshes[part].object; }

    /// The normals at a place, part by part; corners whose normal is of no use are left out.
    void gather(std::span<const BorderCorner> corners) {
        normals_here_.clear();
        parts_here_.clear();
        normals_here_.reserve(corners.size());  // spans into it stay good
        for (std::size_t i = 0; i < corners.size();) {
            const std::uint32_t part = corners[i].part;
            std::size_t end = i + 1;
            while (end < corners.size() && corners[end].part == part) ++end;
            const std::size_t first = normals_here_.size(), count = std::min(end - i, most_normals_of_part);
            for (std::size_t k = 0; k < count; ++k) {  // evenly over all of them
                const BorderCorner& c = corners[i + k * (end - i) / count];
                const CornerNormals n{normal(part, normals_.before[part], c.before),
                                      normal(part, normals_.after[part], c.after)};
                if (n.before != dvec3{} && n.after != dvec3{}) normals_here_.push_back(n);
            }
            if (normals_here_.size() > first) parts_here_.push_back({part, std::span(normals_here_).subspan(first)});
            i = end;
        }
    }

    /// Into the meeting of their objects: the largest angle of meshes that are joined, else the smallest of all.
    void add_meeting(const PartAtPlace& a, const PartAtPlace& b, std::uint32_t place, std::size_t first_meeting) {
        const PairAngle angle = pair_angle(a, b);
        const Meeting m{object_of(a.part),       object_of(b.part),      place,       a.part, b.part,
                        float(angle.before_deg), float(angle.after_deg), angle.joined};
        const auto known = std::find_if(meetings_.begin() + std::ptrdiff_t(first_meeting), meetings_.end(),
                                        [&](const Meeting& other) { return other.pair() == m.pair(); });
        if (known == meetings_.end()) return meetings_.push_back(m);
        const float after_deg = std::min(known->after_deg, m.after_deg);
        const bool is_worse = m.joined ? m.before_deg > known->before_deg : m.before_deg < known->before_deg;
        if (m.joined == known->joined ? is_worse : m.joined) *known = m;
        known->after_deg = after_deg;
    }

    void visit_place(std::span<const BorderCorner> corners) {
        ++report_.totals.positions;
        gather(corners);
        const std::uint64_t met = parts_here_.size();
        if (met > most_parts_at_place) {
            parts_here_ = most_different(parts_here_, most_parts_at_place);
            ++report_.totals.crowded_positions;
            report_.totals.pairings_left_out +=
                met * (met - 1) / 2 - most_parts_at_place * (most_parts_at_place - 1) / 2;
        }
        if (met < 2) return;
        const std::uint32_t place = corners[0].place;
        const std::size_t first = meetings_.size();
        for (std::size_t a = 0; a < parts_here_.size(); ++a)
            for (std::size_t b = a + 1; b < parts_here_.size(); ++b)
                add_meeting(parts_here_[a], parts_here_[b], place, first);
        sum_up_place(place, std::span(meetings_).subspan(first));
    }

    void sum_up_place(std::uint32_t place, std::span<const Meeting> meetings) {
        float before = 0, after = 0, seam = 0;
        for (const Meeting& m : meetings) {
            before = std::max(before, m.before_deg);
            after = std::max(after, m.after_deg);
            if (m.joined) seam = std::max(seam, m.before_deg);
        }
        worst_before_.push_back(before);
        worst_after_.push_back(after);
        SeamTotals& totals = report_.totals;
        totals.continuous += double(before) <= continuous_deg;
        totals.joined += double(after) <= continuous_deg;
        totals.seam_deg = std::max(totals.seam_deg, double(seam));
        if (double(seam) > continuous_deg) report_.seams_at.emplace_back(place, seam);
    }

    BorderSummary summarize_pair(std::span<const Meeting> meetings) {
        BorderSummary border{.object_a = meetings[0].a, .object_b = meetings[0].b, .positions = meetings.size()};
        std::vector<float> before, after;
        const Meeting* worst = &meetings[0];
        for (const Meeting& m : meetings) {
            before.push_back(m.before_deg);
            after.push_back(m.after_deg);
            border.continuous += m.before_deg <= continuous_deg;
            border.joined += m.joined;
            if (m.joined && m.before_deg > border.seam_deg) border.seam_deg = m.before_deg, worst = &m;
        }
        border.seam_position = placed_.position(worst->place);
        border.mesh_a = worst->part_a, border.mesh_b = worst->part_b;
        border.before = summarize(before);
        border.after = summarize(after);
        border.median_deg = ranked(before, before.size() / 2);
        border.largest_deg = border.before.max_deg;
        return border;
    }

    void summarize_pairs() {
        std::sort(meetings_.begin(), meetings_.end(), [](const Meeting& x, const Meeting& y) {
            return std::tie(x.a, x.b, x.place) < std::tie(y.a, y.b, y.place);
        });
        for (std::size_t i = 0; i < meetings_.size();) {
            std::size_t end = i + 1;
            while (end < meetings_.size() && meetings_[end].a == meetings_[i].a && meetings_[end].b == meetings_[i].b)
                ++end;
            report_.borders.push_back(summarize_pair(std::span(meetings_).subspan(i, end - i)));
            i = end;
        }
        std::vector<BorderSummary>& borders = report_.borders;
        std::stable_sort(borders.begin(), borders.end(), [](const BorderSummary& x, const BorderSummary& y) {
            return x.seam_deg != y.seam_deg ? x.seam_deg > y.seam_deg : x.largest_deg > y.largest_deg;
        });
        report_.totals.pairs = borders.size();
        if (borders.size() <= most_borders) return;
        report_.borders_left_out = borders.size() - most_borders;
        borders.resize(most_borders);
    }

    const geometry::PlacedMeshes& placed_;
    const SeamNormals& normals_;
    BorderReport report_;
    std::vector<CornerNormals> normals_here_;
    std::vector<PartAtPlace> parts_here_;
    std::vector<Meeting> meetings_;
    std::vector<float> worst_before_, worst_after_;  ///< at each place, of its pairs
};

}  // namespace

BorderReport find_borders(const geometry::PlacedMeshes& placed, const SeamNormals& normals, Context& context) {
    return BorderFinder(placed, normals).run(context);
}

}  // namespace rakelight
