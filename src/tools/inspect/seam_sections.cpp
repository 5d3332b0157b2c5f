// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect/seam_sections.h"

#include <algorithm>
#include <numeric>

#include "base/format_text.h"
#include "tools/inspect/largest_seam.h"
#include "tools/object_name.h"

namespace rakelight {
namespace {

std::string degrees_text(double deg) { return number(deg, "%.2f"); }
std::string count_or_dash(std::uint64_t count) { return count ? std::to_string(count) : "-"; }

std::uint64_t bad_normals(const SurfaceSummary& s) {
    return s.zero_normals + s.non_finite_normals + s.non_unit_normals;
}

/// Faults that are never intended; open edges and mirrored charts often are.
std::uint64_t fault_count(const SurfaceSummary& s) {
    return s.degenerate_faces + bad_normals(s) + s.inconsistent_edges + s.non_manifold_edges + s.t_junctions;
}

/// "2 prisms of 6 sides as flat, 1 column of 8 sides as round", or nothing.
std::string conventions_text(const CreaseReport& creases) {
    std::string text;
    const auto add = [&](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
    for (std::size_t n = 0; n < creases.rings.size(); ++n)
        if (creases.rings[n] > 0)
            add(counted(creases.rings[n], n <= flat_most_sides ? "prism" : "column") +
                format_text(" of {} sides as ", n) + (n <= flat_most_sides ? "flat" : "round"));
    if (creases.smooth_surfaces > 0)
        add(counted(creases.smooth_surfaces, "surface") + " of single triangles as smooth");
    return text;
}

/// "60 degrees", "60 to 90 degrees", or how creases are found.
std::string crease_text(const Inspection& i) {
    const SeamTotals& s = i.seams;
    if (s.creases_are_automatic) return "with automatic creases";
    return "at " + number(s.crease_angle_deg) +
           (s.crease_angle_max_deg > s.crease_angle_deg ? " to " + number(s.crease_angle_max_deg) : "") + " degrees";
}

std::string angles_text(const CurveAngles& a) {
    return "max " + degrees_text(a.max_deg) + ", mean " + degrees_text(a.mean_deg) + ", 95% " + degrees_text(a.p95_deg);
}

}  // namespace

std::vector<std::string> crease_lines(const Inspection& i) {
    if (!i.creases) return {};
    const CreaseReport& c = *i.creases;
    const auto rounded = [](double deg) { return number(deg, deg < 1 ? "%.1f" : "%.0f"); };
    std::string line = "hard edges: ";
    if (c.hard == 0)
        line += "none";
    else if (rounded(c.hard_least_deg) == rounded(c.hard_most_deg))
        line += rounded(c.hard_least_deg) + " degrees";
    else
        line += rounded(c.hard_least_deg) + " to " + rounded(c.hard_most_deg) + " degrees";
    line += c.soft == 0 ? "; soft: none" : "; soft: up to " + rounded(c.soft_most_deg) + " degrees";
    const std::string conventions = conventions_text(c);
    return {line + (conventions.empty() ? "" : "; by convention: " + conventions)};
}

std::vector<std::string> choice_lines(const Inspection& i) {
    if (!i.choices) return {};
    const NormalChoices& c = *i.choices;
    const std::uint64_t all = c.smooth + c.plane + c.fit + c.edge_fit + c.noise + c.planar + c.angle;
    std::string line;
    const auto add = [&](std::uint64_t count, const char* what) {
        if (count == 0) return;
        const double percent = 100 * double(count) / double(all);
        line += (line.empty() ? "normals: " : ", ") + number(percent, percent < 1 ? "%.1f" : "%.0f") + "% " + what;
    };
    add(c.fit, "fitted"), add(c.edge_fit, "fitted at borders and creases"), add(c.plane, "of a plane");
    add(c.smooth, "nearly flat"), add(c.planar, "between planes"), add(c.noise, "averaged over noise");
    add(c.angle, "by angle");
    return line.empty() ? std::vector<std::string>{} : std::vector{line};
}

std::vector<std::string> seams_lines(const Inspection& i) {
    const SeamTotals& s = i.seams;
    std::vector<std::string> lines = {counted(i.shared_positions, "position") + " shared by meshes"};
    if (s.missing_normals > 0)
        lines.push_back(counted(s.missing_normals, "normal") +
                        " missing in the file (zero or not finite), computed for these angles");
    if (i.shared_positions == 0) return lines;
    lines[0] += format_text(", {} continuous (normals: {}), {} once {} {}", s.continuous, s.normals_before, s.joined,
                            s.normals_after, crease_text(i));
    lines.push_back("largest seam " + degrees_text(s.seam_deg) + " degrees; angles at shared positions max " +
                    degrees_text(s.before.max_deg) + ", mean " + degrees_text(s.before.mean_deg) + ", 95% " +
                    degrees_text(s.before.p95_deg) + "; smoothed max " + degrees_text(s.after.max_deg) + ", mean " +
                    degrees_text(s.after.mean_deg) + ", 95% " + degrees_text(s.after.p95_deg));
    if (s.crowded_positions > 0)
        lines.push_back(counted(s.crowded_positions, "position") +
                        " of more than 8 meshes: " + counted(s.pairings_left_out, "pairing") + " there not inspected");
    if (s.inconsistent_edges > 0)
        lines.push_back(format_text("{} between objects of which one is inside out, most ({}) between {} and {}",
                                    counted(s.inconsistent_edges, "edge"), i.inconsistent_pairs[0].edges,
                                    quoted_name(i, i.inconsistent_pairs[0].object_a),
                                    quoted_name(i, i.inconsistent_pairs[0].object_b)));
    return lines;
}

std::string inside_out_text(const Inspection& i, const InsideOutBody& body) {
    const std::size_t others = body.objects.size() - 1;
    return "closed body of " + counted(body.triangles, "triangle") + ": " + quoted_name(i, body.objects.front()) +
           (others == 0 ? "" : " and " + counted(others, "more object"));
}

Section t_junctions_section(const Inspection& i) {
    constexpr std::size_t most = 10;
    const std::size_t shown = std::min(most, i.t_junction_places.size());
    Section out = section(
        "T-junctions", {"at", "vertex of", "edge of"}, std::span(i.t_junction_places).first(shown),
        [&](const TJunctionPlace& t, std::size_t) {
            return std::vector<std::string>{position_text(t.position), name_or_number(i, t.object),
                                            name_or_number(i, t.edge_object)};
        },
        shown > 0 ? std::size_t(i.t_junctions) - shown : 0);
    if (i.edges_not_searched > 0)
        out.note += (out.note.empty() ? "" : "; ") + counted(i.edges_not_searched, "open edge") +
                    " not searched for T-junctions: too many are too close together";
    return out;
}

Section inside_out_section(const Inspection& i) {
    return section("inside out", {"what"}, i.inside_out, [&](const InsideOutBody& body, std::size_t) {
        return std::vector<std::string>{inside_out_text(i, body)};
    });
}

Section surfaces_section(const Inspection& i) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t n = 0; n < i.surfaces.size(); ++n)
        if (i.objects[n].triangles > 0) order.push_back(n);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return fault_count(i.surfaces[a]) > fault_count(i.surfaces[b]);
    });
    return section("surfaces",
                   {">#", "object", "closed", ">open edges", ">winding", ">non-manifold", ">T-junctions", ">degenerate",
                    ">bad normals", ">mirrored"},
                   order, [&](std::uint32_t n, std::size_t) {
                       const SurfaceSummary& s = i.surfaces[n];
                       return std::vector<std::string>{std::to_string(n),
                                                       name_or_number(i, n),
                                                       s.closed ? "yes" : "no",
                                                       count_or_dash(s.open_edges),
                                                       count_or_dash(s.inconsistent_edges),
                                                       count_or_dash(s.non_manifold_edges),
                                                       count_or_dash(s.t_junctions),
                                                       count_or_dash(s.degenerate_faces),
                                                       count_or_dash(bad_normals(s)),
                                                       count_or_dash(s.mirrored_positions)};
                   });
}

Section borders_section(const Inspection& i) {
    return section(
        "borders (degrees)",
        {"object", "object", ">shared", ">continuous", ">smoothed", ">seam", ">max", ">mean", ">95%", ">smoothed max",
         ">mean", ">95%", ">winding"},
        i.borders,
        [&](const BorderSummary& b, std::size_t) {
            return std::vector<std::string>{
                name_or_number(i, b.object_a),      name_or_number(i, b.object_b),   std::to_string(b.positions),
                std::to_string(b.continuous),       std::to_string(b.joined),        degrees_text(b.seam_deg),
                degrees_text(b.before.max_deg),     degrees_text(b.before.mean_deg), degrees_text(b.before.p95_deg),
                degrees_text(b.after.max_deg),      degrees_text(b.after.mean_deg),  degrees_text(b.after.p95_deg),
                count_or_dash(b.inconsistent_edges)};
        },
        i.borders_left_out);
}

std::string proposal_text(const Inspection& i) {
    const BorderProposal& p = i.proposal;
    if (!(p.distance > 0)) return {};
    return "open borders of different meshes run along each other (" + number(p.matched_length, "%.3g") + " of " +
           number(p.open_length, "%.3g") + " " + i.unit + ", gaps up to " + number(p.gap_max, "%.3g") + ", seams to " +
           degrees_text(p.seam_deg) + " degrees): 'border-distance' " + number(p.distance) + " measures and joins them";
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
