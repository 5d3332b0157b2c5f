// SPDX-License-Identifier: Apache-2.0
#include <rakelight/tools/inspect_check.h>
#include <rakelight_internal/base/text.h>

#include <cstdio>
#include <set>

#include <rakelight/tools/inspect.h>

#include "base/format_text.h"
#include "tools/inspect/largest_seam.h"
#include "tools/inspect/seam_sections.h"
#include "tools/inspect/whole_inspection.h"
#include "tools/object_name.h"

namespace rakelight {
namespace {

using Count = std::uint64_t SurfaceSummary::*;

std::string text_of(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string text_of(dvec3 p) { return text_of(p.x) + " " + text_of(p.y) + " " + text_of(p.z); }

/// "; so have 3 more PAIRS" or nothing.
std::string more(std::uint64_t count, const char* thing) {
    if (count == 0) return {};
    return "; " + counted(count, std::string("more ") + thing);
}

std::string seam_failure(const Inspection& i, double limit_deg) {
    const std::optional<LargestSeam> worst = largest_seam(i, limit_deg);
    if (!worst && i.matched.edges_not_searched > 0 && limit_deg < 180)
        return std::to_string(i.matched.edges_not_searched) +
               " open edges were not searched for borders beside them: too many are too close together";
    if (!worst) return {};
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const BorderSummary& b : i.borders)
        if (b.seam_deg > limit_deg) pairs.insert({b.object_a, b.object_b});
    for (const MatchedPair& p : i.matched.pairs)
        if (p.seam_deg > limit_deg) pairs.insert({p.object_a, p.object_b});
    return "seam of " + text_of(worst->deg) + " degrees " + between_text(i, *worst) + " at " +
           text_of(worst->position) + (worst->is_along_borders ? ", along borders that share no vertex there" : "") +
           ", more than " + text_of(limit_deg) + more(pairs.size() - 1, "pair");
}

/// The object that has most of something, how much, and how many others have any.
std::string count_failure(const Inspection& i, std::initializer_list<Count> counts, const char* thing) {
    std::size_t worst = 0;
    std::uint64_t most = 0, others = 0;
    for (std::size_t o = 0; o < i.surfaces.size(); ++o) {
        std::uint64_t sum = 0;
        for (const Count count : counts) sum += i.surfaces[o].*count;
        others += sum > 0;
        if (sum > most) most = sum, worst = o;
    }
    if (most == 0) return {};
    return format_text("{} in {}{}", counted(most, thing), quoted_name(i, std::uint32_t(worst)),
                       more(others - 1, "object"));
}

/// Normals without a direction, where seams of less than half a turn are asked about.
std::string missing_failure(const Inspection& i, double limit_deg) {
    if (i.seams.missing_normals == 0 || !(limit_deg < 180)) return {};
    using S = SurfaceSummary;
    const std::string where = count_failure(i, {&S::zero_normals, &S::non_finite_normals}, "zero or non-finite normal");
    return where.empty() ? format_text("{} zero or non-finite normals", i.seams.missing_normals) : where;
}

std::string t_junction_failure(const Inspection& i) {
    std::string text = count_failure(i, {&SurfaceSummary::t_junctions}, "T-junction");
    if (!text.empty()) text += ", the first at " + text_of(i.t_junction_places.front().position);
    if (text.empty() && i.edges_not_searched > 0)
        text = std::to_string(i.edges_not_searched) + " open edges were not searched: too many are too close together";
    return text;
}

// An object of degenerate triangles alone has no open edge, and is not closed either.
std::string closed_failure(const Inspection& i) {
    std::string text = count_failure(i, {&SurfaceSummary::open_edges}, "open edge");
    for (std::size_t o = 0; o < i.surfaces.size() && text.empty(); ++o)
        if (i.objects[o].triangles > 0 && !i.surfaces[o].closed)
            text = "only degenerate triangles in " + quoted_name(i, std::uint32_t(o));
    return text;
}

std::string inside_out_failure(const Inspection& i) {
    if (i.inside_out.empty()) return {};
    const std::size_t others = i.inside_out.size() - 1;
    return inside_out_text(i, i.inside_out.front()) +
           (others == 0 ? "" : "; " + counted(others, "more body", "more bodies"));
}

std::string winding_failure(const Inspection& i) {
    std::string text = count_failure(i, {&SurfaceSummary::inconsistent_edges}, "edge of inconsistent winding");
    if (const std::size_t at = text.find("edge of inconsistent windings"); at != text.npos)
        text.replace(at, 29, "edges of inconsistent winding");
    if (i.inconsistent_pairs.empty()) return text;
    const InconsistentPair& worst = i.inconsistent_pairs.front();
    const std::string between =
        format_text("{} between {} and {}{}", worst.edges, quoted_name(i, worst.object_a),
                    quoted_name(i, worst.object_b), more(i.inconsistent_pairs.size() - 1, "pair"));
    return text.empty() ? "edges of inconsistent winding: " + between : text + "; " + between;
}

}  // namespace

std::vector<std::string> names_of(const CheckLimits& limits) {
    const std::pair<const char*, bool> all[] = {{"max-seam", limits.max_seam_deg.has_value()},
                                                {"no-degenerate", limits.no_degenerate},
                                                {"no-t-junctions", limits.no_t_junctions},
                                                {"no-non-manifold", limits.no_non_manifold},
                                                {"consistent-winding", limits.consistent_winding},
                                                {"no-inside-out", limits.no_inside_out},
                                                {"closed", limits.closed},
                                                {"unit-normals", limits.unit_normals}};
    std::vector<std::string> names;
    for (const auto& [name, is_set] : all)
        if (is_set) names.emplace_back(name);
    return names;
}

std::string to_text(const CheckLimits& limits) {
    std::string text;
    for (const std::string& name : names_of(limits)) {
        text += (text.empty() ? "" : ", ") + name;
        if (name == "max-seam") text += " " + text_of(*limits.max_seam_deg);
    }
    return text.empty() ? "no limit" : text;
}

std::vector<CheckFailure> check_limits(const Inspection& i, const CheckLimits& limits) {
    check_whole(i);
    using S = SurfaceSummary;
    std::vector<CheckFailure> failures;
    const auto add = [&](bool wanted, const char* limit, const auto& find) {
        if (!wanted) return;
        if (std::string message = find(); !message.empty()) failures.push_back({limit, std::move(message)});
    };
    add(limits.max_seam_deg.has_value(), "max-seam", [&] {
        const std::string missing = limits.unit_normals ? "" : missing_failure(i, *limits.max_seam_deg);
        const std::string seam = seam_failure(i, *limits.max_seam_deg);
        return missing.empty() || seam.empty() ? missing + seam : missing + "; " + seam;
    });
    add(limits.no_degenerate, "no-degenerate",
        [&] { return count_failure(i, {&S::degenerate_faces}, "degenerate face"); });
    add(limits.no_t_junctions, "no-t-junctions", [&] { return t_junction_failure(i); });
    add(limits.no_non_manifold, "no-non-manifold",
        [&] { return count_failure(i, {&S::non_manifold_edges}, "non-manifold edge"); });
    add(limits.consistent_winding, "consistent-winding", [&] { return winding_failure(i); });
    add(limits.no_inside_out, "no-inside-out", [&] { return inside_out_failure(i); });
    add(limits.closed, "closed", [&] { return closed_failure(i); });
    add(limits.unit_normals, "unit-normals", [&] {
        return count_failure(i, {&S::zero_normals, &S::non_finite_normals, &S::non_unit_normals},
                             "zero, non-finite or non-unit normal");
    });
    return failures;
}

}  // namespace rakelight
