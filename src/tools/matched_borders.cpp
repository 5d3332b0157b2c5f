// SPDX-License-Identifier: Apache-2.0
#include "tools/matched_borders.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/border_measure.h"
#include "geometry/border_proposal.h"
#include "tools/borders.h"

namespace rakelight {
namespace {

MatchOptions match_options(const InspectOptions& options, double distance) {
    return {.distance = distance,
            .crease_angle_rad = options.prepare.crease_angle_rad,
            .weld_distance = options.weld_distance,
            .weight = options.prepare.weight};
}

std::vector<std::uint32_t> all_parts(const Surfaces& surfaces) {
    std::vector<std::uint32_t> parts(surfaces.meshes.size());
    std::iota(parts.begin(), parts.end(), 0u);
    return parts;
}

using ObjectPair = std::pair<std::uint32_t, std::uint32_t>;

/// What a border is measured by, and how much of each sample's angle [degrees] counts as a seam.
struct Seams {
    BorderMeasure measure;
    std::vector<double> seam_deg;  ///< [samples]
};

constexpr double least_share_taken = 0.1;

/// @param joined  of the same borders with joined normals: the same places match
Seams seams_of(BorderMeasure measure, const BorderMeasure& joined) {
    Seams out{std::move(measure), {}};
    for (std::size_t i = 0; i < out.measure.samples.size(); ++i) {
        const double before = out.measure.samples[i].deg,
                     after = i < joined.samples.size() ? joined.samples[i].deg : before;
        out.seam_deg.push_back(after < (1 - least_share_taken) * before && before > continuous_deg ? before : 0);
    }
    return out;
}

/// What is measured along the borders of each two objects.
std::map<ObjectPair, BorderMeasure> measures_of_pairs(std::span<const BorderSample> samples, const Surfaces& surfaces) {
    std::map<ObjectPair, BorderMeasure> pairs;
    for (const BorderSample& s : samples)
        pairs[std::minmax(surfaces.meshes[s.mesh].object, surfaces.meshes[s.other_mesh].object)].samples.push_back(s);
    for (auto& [pair, measure] : pairs) geometry::sum_up(measure);
    return pairs;
}

MatchedPair summarize(ObjectPair objects, const BorderMeasure& before) {
    const auto largest = std::ranges::max_element(before.samples, {}, &BorderSample::deg);
    return {.object_a = objects.first,
            .object_b = objects.second,
            .length = before.matched_length,
            .gap_max = before.gap_max,
            .gap_mean = before.gap_mean,
            .before = before.seam,
            .seam_position = (largest->a + largest->b) * 0.5};
}

void add_seams(std::map<ObjectPair, MatchedPair>& pairs, const Seams& seams, const Surfaces& surfaces) {
    for (std::size_t i = 0; i < seams.seam_deg.size(); ++i) {
        const BorderSample& s = seams.measure.samples[i];
        MatchedPair& pair = pairs.at(std::minmax(surfaces.meshes[s.mesh].object, surfaces.meshes[s.other_mesh].object));
        if (!(seams.seam_deg[i] > pair.seam_deg)) continue;
        pair.seam_deg = seams.seam_deg[i];
        pair.seam_position = (s.a + s.b) * 0.5;
    }
}

void list_pairs(MatchedSeams& matched, const Seams& before, const BorderMeasure& after, const Surfaces& surfaces) {
    std::map<ObjectPair, MatchedPair> pairs;
    for (const auto& [objects, measure] : measures_of_pairs(before.measure.samples, surfaces))
        pairs.emplace(objects, summarize(objects, measure));
    for (const auto& [objects, measure] : measures_of_pairs(after.samples, surfaces))
        if (const auto found = pairs.find(objects); found != pairs.end()) found->second.after = measure.seam;
    add_seams(pairs, before, surfaces);
    for (auto& [objects, pair] : pairs) matched.pairs.push_back(pair);
    std::ranges::stable_sort(matched.pairs, std::greater(),
                             [](const MatchedPair& p) { return std::pair(p.seam_deg, p.before.max_deg); });
    matched.seam_deg = matched.pairs.empty() ? 0 : matched.pairs.front().seam_deg;
    if (matched.pairs.size() <= most_borders) return;
    matched.pairs_left_out = matched.pairs.size() - most_borders;
    matched.pairs.resize(most_borders);
}

void add_seam_lines(std::vector<SeamLine>& lines, const Seams& seams, Context& context) {
    context.memory().check(seams.seam_deg.size() * sizeof(SeamLine), "lines along borders that match");
    for (std::size_t i = 0; i < seams.seam_deg.size(); ++i) {
        const BorderSample& s = seams.measure.samples[i];
        if (seams.seam_deg[i] > 0) lines.push_back({s.a, s.b, float(s.deg), float(s.deg)});
    }
}

/// The normals as they are, and joined along the borders that match.
Seams measure_seams(const Surfaces& surfaces, const std::vector<PartNormals>& normals, const MatchOptions& matching,
                    Context& context) {
    const std::vector<std::uint32_t> parts = all_parts(surfaces);
    const MeshesWithNormals meshes = meshes_with_normals(surfaces, normals, parts, context);
    BorderMeasure before = measure_borders(meshes.meshes, matching, context);
    MatchReport report;
    const auto turned =
        join_borders(match_borders(meshes.meshes, matching, context), meshes.meshes, {}, report, context);
    if (report.turned == 0) {
        const BorderMeasure same = before;
        return seams_of(std::move(before), same);
    }
    std::vector<PartNormals> joined = normals;
    apply(turned, parts, joined);
    const MeshesWithNormals joined_meshes = meshes_with_normals(surfaces, joined, parts, context);
    return seams_of(std::move(before), measure_borders(joined_meshes.meshes, matching, context));
}

}  // namespace

bool have_open_borders(const geometry::PlacedMeshes& placed, const geometry::EdgeCensus& census) {
    if (census.open_corners.empty()) return false;
    const std::uint32_t first = placed.input.mesh_of_triangle(census.open_corners.front() / 3);
    return std::ranges::any_of(
        census.open_corners, [&](std::uint32_t corner) { return placed.input.mesh_of_triangle(corner / 3) != first; });
}

void look_at_matched_borders(Inspection& result, const Surfaces& surfaces, SeamNormals& normals,
                             const InspectOptions& options, Context& context) {
    const std::vector<std::uint32_t> parts = all_parts(surfaces);
    const MatchOptions matching = match_options(options, options.border_distance);
    const Seams seams = measure_seams(surfaces, normals.before, matching, context);
    const BorderMeasure& before = seams.measure;
    const MeshesWithNormals smoothed = meshes_with_normals(surfaces, normals.after, parts, context);
    MatchReport report;
    apply(join_borders(match_borders(smoothed.meshes, matching, context), smoothed.meshes, {}, report, context), parts,
          normals.after);  // `smoothed` looks at these
    const BorderMeasure after = measure_borders(smoothed.meshes, matching, context);
    MatchedSeams& matched = result.matched;
    matched.distance = options.border_distance;
    matched.open_length = before.open_length, matched.matched_length = before.matched_length;
    matched.gap_max = before.gap_max, matched.gap_mean = before.gap_mean;
    matched.before = before.seam, matched.after = after.seam;
    matched.edges_not_searched = before.edges_not_searched;
    context.memory().check(2 * (before.samples.size() + after.samples.size()) * sizeof(BorderSample),
                           "seams along borders that match");
    list_pairs(matched, seams, after, surfaces);
    if (options.seam_lines) add_seam_lines(result.seam_lines, seams, context);
}

void propose_border_distance(Inspection& result, const Surfaces& surfaces, const std::vector<PartNormals>& before,
                             const InspectOptions& options, Context& context) {
    const double least_deg = *CheckLimits().max_seam_deg;
    const MeshesWithNormals meshes = meshes_with_normals(surfaces, before, all_parts(surfaces), context);
    const geometry::ProposedDistance p = geometry::propose_distance(meshes.meshes, match_options(options, 0), context);
    if (!(p.distance > 0 && p.seam_deg > least_deg)) return;
    const Seams seams = measure_seams(surfaces, before, match_options(options, p.distance), context);
    const BorderMeasure& m = seams.measure;
    const double seam_deg = seams.seam_deg.empty() ? 0 : std::ranges::max(seams.seam_deg);
    if (seam_deg > least_deg) result.proposal = {p.distance, m.open_length, m.matched_length, m.gap_max, seam_deg};
}

double MatchedSeams::unmatched_length() const {
    const double rest = open_length - matched_length;
    return rest > 1e-9 * open_length ? rest : 0;
}

}  // namespace rakelight
