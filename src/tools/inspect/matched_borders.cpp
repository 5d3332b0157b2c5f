// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect/matched_borders.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "geometry/borders/border_edges.h"
#include "geometry/borders/border_proposal.h"
#include "geometry/borders/measure_borders.h"
#include "tools/inspect/borders.h"

namespace rakelight {
namespace {

/// As smooth and pictures join the same model: flat faces that somebody authored stay apart.
MatchOptions match_options(const Surfaces& surfaces, const InspectOptions& options, double distance) {
    return {.distance = distance,
            .crease_angle_rad = options.prepare.crease_angle_rad,
            .weld_distance = options.weld_distance,
            .weight = options.prepare.weight,
            .keep_flat = keep_some(surfaces)};
}

std::vector<std::uint32_t> all_parts(const Surfaces& surfaces) {
    std::vector<std::uint32_t> parts(surfaces.meshes.size());
    std::iota(parts.begin(), parts.end(), 0u);
    return parts;
}

using ObjectPair = std::pair<std::uint32_t, std::uint32_t>;

/// Linear interpolation along an edge deviates from the other border's normals by up to an eighth of their turn (h^2/8
/// times the second derivative of the normal field). It deviates by twice that if an edge of one side spans a vertex
/// of the other.
constexpr double interpolation_share = 1.0 / 4;

/// [degrees] What of a sample's angle is a seam: all of it, or nothing.
double seam_of(const BorderSample& s) {
    return s.deg > continuous_deg && s.deg > interpolation_share * s.turn_deg ? s.deg : 0;
}

/// Of all open borders; less is a chance meeting of parts that lie in one place.
constexpr double least_share_proposed = 0.1;

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

void add_seams(std::map<ObjectPair, MatchedPair>& pairs, std::span<const BorderSample> samples,
               const Surfaces& surfaces) {
    for (const BorderSample& s : samples) {
        MatchedPair& pair = pairs.at(std::minmax(surfaces.meshes[s.mesh].object, surfaces.meshes[s.other_mesh].object));
        if (!(seam_of(s) > pair.seam_deg)) continue;
        pair.seam_deg = seam_of(s);
        pair.seam_position = (s.a + s.b) * 0.5;
    }
}

void list_pairs(MatchedSeams& matched, const BorderMeasure& before, const BorderMeasure& after,
                const Surfaces& surfaces) {
    std::map<ObjectPair, MatchedPair> pairs;
    for (const auto& [objects, measure] : measures_of_pairs(before.samples, surfaces))
        pairs.emplace(objects, summarize(objects, measure));
    for (const auto& [objects, measure] : measures_of_pairs(after.samples, surfaces))
        if (const auto found = pairs.find(objects); found != pairs.end()) found->second.after = measure.seam;
    add_seams(pairs, before.samples, surfaces);
    for (auto& [objects, pair] : pairs) matched.pairs.push_back(pair);
    std::ranges::stable_sort(matched.pairs, std::greater(),
                             [](const MatchedPair& p) { return std::pair(p.seam_deg, p.before.max_deg); });
    matched.seam_deg = matched.pairs.empty() ? 0 : matched.pairs.front().seam_deg;
    if (matched.pairs.size() <= most_borders) return;
    matched.pairs_left_out = matched.pairs.size() - most_borders;
    matched.pairs.resize(most_borders);
}

void add_seam_lines(std::vector<SeamLine>& lines, std::span<const BorderSample> samples, Context& context) {
    context.memory().check(samples.size() * sizeof(SeamLine), "lines along borders that match");
    for (const BorderSample& s : samples)
        if (seam_of(s) > 0) lines.push_back({s.a, s.b, float(s.deg), float(s.deg)});
}

/// Does the work of the optional proposal.
/// @return false: it needs more memory than there is, which is noted
template <class Work>
bool unless_too_large(const std::string& file, Context& context, const Work& work) {
    const std::uint64_t refusals = context.memory().refusals();
    try {
        work();
        return true;
    } catch (const Error& error) {
        if (context.memory().refusals() == refusals) throw;
        context.report().add(
            Remark::note, file, {},
            "no distance is proposed for open borders: " + error.reason() + "; raise it with 'max-memory'",
            {"max-memory"});
        return false;
    }
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
    const MatchOptions matching = match_options(surfaces, options, options.border_distance);
    const MeshesWithNormals meshes = meshes_with_normals(surfaces, normals.before, parts, context);
    const BorderMeasure before = measure_borders(meshes.meshes, matching, context);
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
    list_pairs(matched, before, after, surfaces);
    if (options.seam_lines) add_seam_lines(result.seam_lines, before.samples, context);
}

bool can_propose_border_distance(const std::string& file, const geometry::EdgeCensus& census, Context& context) {
    return unless_too_large(file, context,
                            [&] { geometry::check_matching_memory(census.open_corners.size(), context); });
}

static void propose(Inspection& result, const Surfaces& surfaces, const std::vector<PartNormals>& before,
                    const InspectOptions& options, Context& context) {
    const double least_deg = *CheckLimits().max_seam_deg;
    const MeshesWithNormals meshes = meshes_with_normals(surfaces, before, all_parts(surfaces), context);
    const geometry::ProposedDistance p =
        geometry::propose_distance(meshes.meshes, match_options(surfaces, options, 0), context);
    if (!(p.distance > 0 && p.seam_deg > least_deg)) return;
    const BorderMeasure m = measure_borders(meshes.meshes, match_options(surfaces, options, p.distance), context);
    if (m.edges_not_searched > 0 || !(m.matched_length >= least_share_proposed * m.open_length)) return;
    double seam_deg = 0;
    for (const BorderSample& s : m.samples) seam_deg = std::max(seam_deg, seam_of(s));
    if (seam_deg > least_deg) result.proposal = {p.distance, m.open_length, m.matched_length, m.gap_max, seam_deg};
}

void propose_border_distance(Inspection& result, const Surfaces& surfaces, const std::vector<PartNormals>& before,
                             const InspectOptions& options, Context& context) {
    unless_too_large(result.file, context, [&] { propose(result, surfaces, before, options, context); });
}

double MatchedSeams::unmatched_length() const {
    const double rest = open_length - matched_length;
    return rest > 1e-9 * open_length ? rest : 0;
}

}  // namespace rakelight
