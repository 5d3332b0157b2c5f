// SPDX-License-Identifier: Apache-2.0
// Borders that run along each other, for people.
#include "tools/inspect/inspect_sections.h"
#include "tools/inspect/largest_seam.h"
#include "tools/object_name.h"

namespace rakelight {
namespace {

std::string degrees_text(double deg) { return number(deg, "%.2f"); }

std::string angles_text(const CurveAngles& a) {
    return "max " + degrees_text(a.max_deg) + ", mean " + degrees_text(a.mean_deg) + ", 95% " + degrees_text(a.p95_deg);
}

}  // namespace

std::string proposal_text(const Inspection& i) {
    const BorderProposal& p = i.proposal;
    if (!(p.distance > 0)) return {};
    return "open borders of different meshes run along each other (" + number(p.matched_length, "%.3g") + " of " +
           number(p.open_length, "%.3g") + " " + i.unit + ", gaps up to " + number(p.gap_max, "%.3g") + ", seams to " +
           degrees_text(p.seam_deg) + " degrees): 'border-distance' " + number(p.distance) + " measures and joins them";
}

std::optional<LargestSeam> largest_seam(const Inspection& i, double than_deg) {
    std::optional<LargestSeam> largest;
    if (!i.borders.empty() && i.seams.seam_deg > than_deg) {
        const BorderSummary& b = i.borders.front();
        largest = {i.seams.seam_deg, b.object_a, b.object_b, b.seam_position, false, b.material_a, b.material_b};
    }
    if (i.matched.pairs.empty() || !(i.matched.seam_deg > than_deg)) return largest;
    if (largest && largest->deg >= i.matched.seam_deg) return largest;
    const MatchedPair& p = i.matched.pairs.front();
    return LargestSeam{.deg = i.matched.seam_deg,
                       .object_a = p.object_a,
                       .object_b = p.object_b,
                       .position = p.seam_position,
                       .is_along_borders = true};
}

std::string between_text(const Inspection& i, std::uint32_t object_a, std::uint32_t object_b) {
    return object_a == object_b ? "between two meshes of " + quoted_name(i, object_a)
                                : "between " + quoted_name(i, object_a) + " and " + quoted_name(i, object_b);
}

std::string between_text(const Inspection& i, const LargestSeam& seam) {
    const std::uint32_t a = seam.material_a, b = seam.material_b;
    if (seam.object_a != seam.object_b || a == b || a == no_index || b == no_index)
        return between_text(i, seam.object_a, seam.object_b);
    const auto name = [&](std::uint32_t material) {
        const std::string& text = i.scene.materials[material].name;
        return text.empty() ? "material " + std::to_string(material) : "'" + one_line(text, max_name) + "'";
    };
    return "between " + name(a) + " and " + name(b) + " of " + quoted_name(i, seam.object_a);
}

std::vector<std::string> matched_lines(const Inspection& i) {
    const MatchedSeams& m = i.matched;
    if (const std::string text = proposal_text(i); !text.empty()) return {text};
    if (!(m.distance > 0)) return {};
    std::vector<std::string> lines = {"open borders " + number(m.open_length, "%.4g") + " " + i.unit + ": " +
                                      number(m.matched_length, "%.4g") + " run along another within " +
                                      number(m.distance) + ", " + number(m.unmatched_length(), "%.4g") + " do not"};
    if (!m.pairs.empty()) {
        const MatchedPair& worst = m.pairs.front();
        lines[0] += "; gap max " + number(m.gap_max, "%.3g") + ", mean " + number(m.gap_mean, "%.3g");
        lines.push_back("seam along them " + angles_text(m.before) + " degrees; smoothed and joined " +
                        angles_text(m.after) + "; largest " + between_text(i, worst.object_a, worst.object_b) + " at " +
                        position_text(worst.seam_position));
        if (!(m.seam_deg > continuous_deg) && m.before.max_deg > continuous_deg)
            lines.push_back(
                "no seam: the angles are less than a quarter of the angle between normals along the edges there");
    }
    if (m.edges_not_searched > 0)
        lines.push_back(counted(m.edges_not_searched, "open edge") +
                        " not fully searched: too many borders are too close together");
    return lines;
}

Section matched_section(const Inspection& i) {
    return section(
        matched_title,
        {"object", "object", ">length", ">gap max", ">mean", ">seam max", ">mean", ">95%", ">joined max", ">mean",
         ">95%", "largest at"},
        i.matched.pairs,
        [&](const MatchedPair& p, std::size_t) {
            return std::vector<std::string>{
                name_or_number(i, p.object_a),   name_or_number(i, p.object_b),  number(p.length, "%.4g"),
                number(p.gap_max, "%.3g"),       number(p.gap_mean, "%.3g"),     degrees_text(p.before.max_deg),
                degrees_text(p.before.mean_deg), degrees_text(p.before.p95_deg), degrees_text(p.after.max_deg),
                degrees_text(p.after.mean_deg),  degrees_text(p.after.p95_deg),  position_text(p.seam_position)};
        },
        i.matched.pairs_left_out);
}

}  // namespace rakelight
