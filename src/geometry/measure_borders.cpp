// SPDX-License-Identifier: Apache-2.0
// How far apart normals are along borders that run along each other.
#include <rakelight/matching_borders.h>

#include <algorithm>

#include "geometry/authored_normals.h"
#include "geometry/border_measure.h"
#include "geometry/border_search.h"
#include "geometry/border_surface.h"

namespace rakelight {
namespace {

using geometry::BorderEdge;
using geometry::BorderHit;
using geometry::BorderHits;
using geometry::Weighted;

constexpr int samples_per_edge = 4;
constexpr std::size_t edges_per_chunk = 512;

/// The nearest one, in place and normal.
const BorderHit* best_of(const BorderHits& hits) {
    const std::span<const BorderHit> all = hits.all();
    const auto at = std::min_element(all.begin(), all.end(), [](const BorderHit& a, const BorderHit& b) {
        return a.rank != b.rank ? a.rank < b.rank : a.edge < b.edge;
    });
    return at == all.end() ? nullptr : &*at;
}

/// What is found from the open edges of one chunk.
struct Found {
    std::vector<BorderSample> samples;
    std::uint64_t given_up = 0;
};

void measure_edge(const geometry::BorderSearch& search, const BorderEdge& edge, double radius, BorderHits& hits,
                  Found& found) {
    bool given_up = false;
    for (int k = 0; k < samples_per_edge; ++k) {
        const double at = (k + 0.5) / samples_per_edge;
        const dvec3 normal = edge.normal(at);
        search.find(edge, edge.point(at), normal, radius, hits);
        given_up = given_up || hits.gave_up;
        const BorderHit* const hit = best_of(hits);
        if (!hit) continue;
        const double deg = degrees(geometry::angle_between(normal, search.edges()[hit->edge].normal(hit->t)));
        found.samples.push_back({edge.point(double(k) / samples_per_edge), edge.point(double(k + 1) / samples_per_edge),
                                 deg, hit->distance, edge.mesh, hit->mesh});
    }
    found.given_up += given_up ? 1 : 0;
}

/// At the sample places of every edge.
void find_samples(const geometry::BorderSearch& search, double radius, BorderMeasure& measure, Context& context) {
    const std::span<const BorderEdge> edges = search.edges();
    context.memory().check(2 * samples_per_edge * edges.size() * sizeof(BorderSample), "measuring open borders");
    std::vector<Found> found((edges.size() + edges_per_chunk - 1) / edges_per_chunk);
    context.parallel_for(found.size(), [&](std::size_t c) {
        BorderHits hits;
        for (std::size_t e = c * edges_per_chunk; e < std::min(edges.size(), (c + 1) * edges_per_chunk); ++e)
            measure_edge(search, edges[e], radius, hits, found[c]);
    });
    for (const Found& f : found) {
        measure.samples.insert(measure.samples.end(), f.samples.begin(), f.samples.end());
        measure.edges_not_searched += f.given_up;
    }
}

}  // namespace

double geometry::weighted_quantile(std::vector<Weighted> values, double share) {
    std::sort(values.begin(), values.end(), [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
    double whole = 0, sum = 0;
    for (const Weighted& v : values) whole += v.length;
    for (const Weighted& v : values)
        if ((sum += v.length) >= share * whole) return v.value;
    return values.empty() ? 0 : values.back().value;
}

void geometry::sum_up(BorderMeasure& measure) {
    std::vector<Weighted> angles;
    for (const BorderSample& s : measure.samples) {
        const double piece = length(s.b - s.a);
        measure.matched_length += piece;
        measure.seam.max_deg = std::max(measure.seam.max_deg, s.deg);
        measure.seam.mean_deg += s.deg * piece;
        measure.gap_max = std::max(measure.gap_max, s.gap);
        measure.gap_mean += s.gap * piece;
        angles.push_back({s.deg, piece});
    }
    if (!(measure.matched_length > 0)) return;
    measure.seam.mean_deg /= measure.matched_length;
    measure.gap_mean /= measure.matched_length;
    measure.seam.p95_deg = weighted_quantile(std::move(angles), 0.95);
}

BorderMeasure measure_borders(std::span<const AttributeMesh> meshes, const MatchOptions& options, Context& context) {
    geometry::check_matching(meshes, options);
    BorderMeasure measure;
    const geometry::BorderSurface surface(meshes, options, context);
    for (const BorderEdge& edge : surface.edges) measure.open_length += edge.length;
    if (surface.edges.empty() || options.scope == Scope::face) return measure;
    const geometry::BorderSearch search(surface.edges, surface.placed.input, options, context);
    find_samples(search, options.distance, measure, context);
    geometry::sum_up(measure);
    return measure;
}

}  // namespace rakelight
