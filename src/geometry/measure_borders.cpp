// SPDX-License-Identifier: Apache-2.0
// How far apart normals are along borders that run along each other, and which distance would find these.
#include <rakelight/matching_borders.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "geometry/authored_normals.h"
#include "geometry/border_measure.h"
#include "geometry/border_search.h"
#include "geometry/border_surface.h"

namespace rakelight {
namespace {

using geometry::BorderEdge;
using geometry::BorderHit;
using geometry::BorderHits;

constexpr int samples_per_edge = 4;
constexpr std::size_t edges_per_chunk = 512;
constexpr double widest_gap = 0.5;       // of an edge's length, for a proposal
constexpr double proposed_share = 0.98;  // of the length
constexpr double least_share = 1e-3;     // of an edge, where there is no gap to speak of

double sample_place(int k) { return (k + 0.5) / samples_per_edge; }

/// The nearest one, in place and normal.
const BorderHit* best_of(const BorderHits& hits) {
    const std::span<const BorderHit> all = hits.all();
    const auto at = std::min_element(all.begin(), all.end(), [](const BorderHit& a, const BorderHit& b) {
        return a.rank != b.rank ? a.rank < b.rank : a.edge < b.edge;
    });
    return at == all.end() ? nullptr : &*at;
}

/// What is found from the open edges of one chunk.
template <class Item>
struct Found {
    std::vector<Item> items;
    std::uint64_t given_up = 0;
};

/// Asks at the sample places of every edge. @param visit  (edge, place of the sample 0..1, hit, items)
template <class Item, class Radius, class Visit>
std::vector<Item> for_each_sample(const geometry::BorderSearch& search, Context& context, std::uint64_t& given_up,
                                  const Radius& radius_of, const Visit& visit) {
    const std::span<const BorderEdge> edges = search.edges();
    std::vector<Found<Item>> found((edges.size() + edges_per_chunk - 1) / edges_per_chunk);
    context.parallel_for(found.size(), [&](std::size_t c) {
        BorderHits hits;
        for (std::size_t e = c * edges_per_chunk; e < std::min(edges.size(), (c + 1) * edges_per_chunk); ++e)
            for (int k = 0; k < samples_per_edge; ++k) {
                const BorderEdge& edge = edges[e];
                const dvec3 normal = edge.normal(sample_place(k));
                search.find(edge, edge.point(sample_place(k)), normal, radius_of(edge), hits);
                found[c].given_up += hits.gave_up;
                if (const BorderHit* const hit = best_of(hits)) visit(edge, k, normal, *hit, found[c].items);
            }
    });
    std::vector<Item> all;
    for (const Found<Item>& f : found) {
        all.insert(all.end(), f.items.begin(), f.items.end());
        given_up += f.given_up;
    }
    return all;
}

/// A number that a piece of border of some length has.
struct Weighted {
    double value, length;
};

/// The least value that a share of all length is not above.
double weighted_quantile(std::vector<Weighted> values, double share) {
    std::sort(values.begin(), values.end(), [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
    double whole = 0, sum = 0;
    for (const Weighted& v : values) whole += v.length;
    for (const Weighted& v : values)
        if ((sum += v.length) >= share * whole) return v.value;
    return values.empty() ? 0 : values.back().value;
}

/// Up to two digits.
double rounded_up(double value) {
    if (!(value > 0)) return 0;
    double unit = 1;
    while (value >= 100 * unit) unit *= 10;
    while (value < 10 * unit) unit /= 10;
    return std::ceil(value / unit) * unit;
}

}  // namespace

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
    measure.samples = for_each_sample<BorderSample>(
        search, context, measure.edges_not_searched, [&](const BorderEdge&) { return options.distance; },
        [&](const BorderEdge& edge, int k, dvec3 normal, const BorderHit& hit, std::vector<BorderSample>& out) {
            const double deg = degrees(geometry::angle_between(normal, search.edges()[hit.edge].normal(hit.t)));
            out.push_back({edge.point(double(k) / samples_per_edge), edge.point(double(k + 1) / samples_per_edge), deg,
                           hit.distance, edge.mesh, hit.mesh});
        });
    geometry::sum_up(measure);
    return measure;
}

double proposed_border_distance(std::span<const AttributeMesh> meshes, const MatchOptions& options, Context& context) {
    MatchOptions any = options;
    any.distance = 1;
    geometry::check_matching(meshes, any);
    const geometry::BorderSurface surface(meshes, any, context);
    if (surface.edges.empty() || any.scope == Scope::face) return 0;
    const geometry::BorderSearch search(surface.edges, surface.placed.input, any, context);
    std::uint64_t given_up = 0;
    const std::vector<Weighted> gaps = for_each_sample<Weighted>(
        search, context, given_up, [](const BorderEdge& edge) { return widest_gap * edge.length; },
        [](const BorderEdge& edge, int, dvec3, const BorderHit& hit, std::vector<Weighted>& out) {
            out.push_back({std::fmax(hit.distance, least_share * edge.length), edge.length});
        });
    return rounded_up(1.25 * weighted_quantile(gaps, proposed_share));
}

}  // namespace rakelight
