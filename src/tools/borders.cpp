// SPDX-License-Identifier: Apache-2.0
// Place by place, the pairs of objects that meet there; then the angles of each pair together.
#include "tools/borders.h"

#include <algorithm>
#include <tuple>

#include "geometry/face_vote.h"
#include "tools/border_corners.h"
#include "tools/place_angles.h"

namespace rakelight {
namespace {

/// What one pair of objects is at one place.
struct Meeting {
    std::uint32_t a, b, place;
    float before_deg, after_deg;
    bool joined;
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

    std::uint32_t object_of(const BorderCorner& corner) const { return placed_.input.meshes[corner.part].object; }

    /// The normals at a place, object by object; corners whose normal is of no use are left out.
    void gather(std::span<const BorderCorner> corners) {
        normals_here_.clear();
        objects_here_.clear();
        normals_here_.reserve(corners.size());  // spans into it stay good
        for (std::size_t i = 0; i < corners.size();) {
            const std::uint32_t object = object_of(corners[i]);
            std::size_t end = i + 1;
            while (end < corners.size() && object_of(corners[end]) == object) ++end;
            const std::size_t first = normals_here_.size(), count = std::min(end - i, most_normals_of_object);
            for (std::size_t k = 0; k < count; ++k) {  // evenly over all of them
                const BorderCorner& c = corners[i + k * (end - i) / count];
                const CornerNormals n{normal(c.part, normals_.before[c.part], c.before),
                                      normal(c.part, normals_.after[c.part], c.after)};
                if (n.before != dvec3{} && n.after != dvec3{}) normals_here_.push_back(n);
            }
            if (normals_here_.size() > first)
                objects_here_.push_back({object, std::span(normals_here_).subspan(first)});
            i = end;
        }
    }

    void visit_place(std::span<const BorderCorner> corners) {
        ++report_.totals.positions;
        gather(corners);
        const std::uint64_t met = objects_here_.size();
        if (met > most_objects_at_place) {
            objects_here_ = most_different(objects_here_, most_objects_at_place);
            ++report_.totals.crowded_positions;
            report_.totals.pairings_left_out +=
                met * (met - 1) / 2 - most_objects_at_place * (most_objects_at_place - 1) / 2;
        }
        if (met < 2) return;
        double before = 0, after = 0, seam = 0;
        for (std::size_t a = 0; a < objects_here_.size(); ++a)
            for (std::size_t b = a + 1; b < objects_here_.size(); ++b) {
                const PairAngle angle = pair_angle(objects_here_[a], objects_here_[b]);
                meetings_.push_back({objects_here_[a].object, objects_here_[b].object, corners[0].place,
                                     float(angle.before_deg), float(angle.after_deg), angle.joined});
                before = std::max(before, angle.before_deg);
                after = std::max(after, angle.after_deg);
                if (angle.joined) seam = std::max(seam, angle.before_deg);
            }
        worst_before_.push_back(float(before));
        worst_after_.push_back(float(after));
        SeamTotals& totals = report_.totals;
        totals.continuous += before <= continuous_deg;
        totals.joined += after <= continuous_deg;
        totals.seam_deg = std::max(totals.seam_deg, double(float(seam)));
        if (seam > continuous_deg) report_.seams_at.emplace_back(corners[0].place, float(seam));
    }

    BorderSummary summarize_pair(std::span<const Meeting> meetings) {
        BorderSummary border{.object_a = meetings[0].a, .object_b = meetings[0].b, .positions = meetings.size()};
        std::vector<float> before, after;
        std::uint32_t worst = meetings[0].place;
        for (const Meeting& m : meetings) {
            before.push_back(m.before_deg);
            after.push_back(m.after_deg);
            border.continuous += m.before_deg <= continuous_deg;
            border.joined += m.joined;
            if (m.joined && m.before_deg > border.seam_deg) border.seam_deg = m.before_deg, worst = m.place;
        }
        border.seam_position = placed_.position(worst);
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
    std::vector<ObjectAtPlace> objects_here_;
    std::vector<Meeting> meetings_;
    std::vector<float> worst_before_, worst_after_;  ///< at each place, of its pairs
};

}  // namespace

BorderReport find_borders(const geometry::PlacedMeshes& placed, const SeamNormals& normals, Context& context) {
    return BorderFinder(placed, normals).run(context);
}

}  // namespace rakelight
