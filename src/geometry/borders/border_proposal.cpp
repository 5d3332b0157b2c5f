// SPDX-License-Identifier: Apache-2.0
#include "geometry/borders/border_proposal.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/borders/border_search.h"
#include "geometry/borders/border_surface.h"
#include "geometry/borders/measure_borders.h"
#include "geometry/groups/authored_normals.h"

namespace rakelight {
namespace geometry {
namespace {

constexpr std::size_t max_asked = 4096, edges_per_chunk = 64;
constexpr int samples_per_edge = 4;
constexpr double widest_gap = 0.5;  // of an edge's length
constexpr double widest_spread =
    0.25;  // of an edge's length: maximum variation of its gaps, an angle of about 18 degrees
constexpr double proposed_share = 0.98;  // of the length
constexpr double min_share = 1e-3;       // of an edge's length, if there is practically no gap

/// The neighboring border along one edge.
struct Neighbor {
    double length = 0;  ///< [m] of the edge
    double gap = 0;     ///< [m] the largest
    double seam_deg = 0;
};

/// The nearest hit by distance.
const BorderHit* nearest_of(const BorderHits& hits) {
    const auto at = std::ranges::min_element(
        hits.all(), [](const BorderHit& a, const BorderHit& b) { return a.distance < b.distance; });
    return at == hits.all().end() ? nullptr : &*at;
}

/// Nothing if the edge does not match one other mesh over its whole length.
std::optional<Neighbor> neighbor_of(const BorderSearch& search, const BorderEdge& edge, double radius,
                                    BorderHits& hits) {
    Neighbor out{.length = edge.length};
    std::uint32_t mesh = 0;
    double least = 0;
    for (int k = 0; k < samples_per_edge; ++k) {
        const double t = (k + 0.5) / samples_per_edge;
        const dvec3 normal = edge.normal(t);
        search.find(edge, edge.point(t), normal, radius, hits);
        const BorderHit* const hit = hits.gave_up ? nullptr : nearest_of(hits);
        if (!hit || (k > 0 && hit->mesh != mesh)) return {};
        mesh = hit->mesh;
        least = k == 0 ? hit->distance : std::fmin(least, hit->distance);
        out.gap = std::fmax(out.gap, hit->distance);
        if (!(out.gap - least <= widest_spread * edge.length)) return {};
        out.seam_deg =
            std::fmax(out.seam_deg, degrees(angle_between(normal, search.edges()[hit->edge].normal(hit->t))));
    }
    return out;
}

/// Every edge, or one at a varying place in each of `max_asked` equal parts of the list: a fixed step could coincide
/// with how a grid is numbered.
std::size_t edge_to_ask(std::size_t k, std::size_t asked, std::size_t edges) {
    if (asked == edges) return k;
    const std::size_t first = k * edges / asked, last = (k + 1) * edges / asked;
    return first + (std::uint64_t(k) * 0x9e3779b97f4a7c15u >> 33) % (last - first);
}

/// Rounds up to two digits.
double rounded_up(double value) {
    if (!(value > 0) || !std::isfinite(value)) return 0;
    double unit = 1;
    while (value >= 100 * unit) unit *= 10;
    while (value < 10 * unit) unit /= 10;
    return std::ceil(value / unit) * unit;
}

using Neighbors = std::vector<std::optional<Neighbor>>;  ///< [asked]

/// @param radius_of (edge) -> search radius [m]
template <class Radius>
Neighbors ask(const BorderSearch& search, std::size_t asked, Context& context, const Radius& radius_of) {
    Neighbors out(asked);
    context.parallel_for((asked + edges_per_chunk - 1) / edges_per_chunk, [&](std::size_t c) {
        BorderHits hits;
        for (std::size_t k = c * edges_per_chunk; k < std::min(asked, (c + 1) * edges_per_chunk); ++k) {
            const BorderEdge& edge = search.edges()[edge_to_ask(k, asked, search.edges().size())];
            out[k] = neighbor_of(search, edge, radius_of(edge), hits);
        }
    });
    return out;
}

double distance_of(const Neighbors& neighbors) {
    std::vector<Weighted> gaps;
    for (const std::optional<Neighbor>& n : neighbors)
        if (n) gaps.push_back({std::fmax(n->gap, min_share * n->length), n->length});
    return rounded_up(1.25 * weighted_quantile(std::move(gaps), proposed_share));
}

/// Nothing if none of the neighbors examined again is that near.
ProposedDistance summarize(double distance, const Neighbors& neighbors) {
    ProposedDistance out;
    for (const std::optional<Neighbor>& n : neighbors)
        if (n) out.distance = distance, out.seam_deg = std::fmax(out.seam_deg, n->seam_deg);
    return out;
}

}  // namespace

ProposedDistance propose_distance(std::span<const AttributeMesh> meshes, const MatchOptions& options,
                                  Context& context) {
    MatchOptions any = options;
    any.distance = 1;
    check_matching(meshes, any);
    const BorderSurface surface(meshes, any, context);
    const std::span<const BorderEdge> edges = surface.edges;
    if (edges.empty() || any.scope == Scope::face) return {};
    const BorderSearch search(edges, surface.placed.input, any, context);
    const std::size_t asked = std::min(edges.size(), max_asked);
    const double distance =
        distance_of(ask(search, asked, context, [](const BorderEdge& edge) { return widest_gap * edge.length; }));
    if (!(distance > 0)) return {};
    // A smaller radius allows less overlap of faces, so some edges do not match any more.
    return summarize(distance, ask(search, asked, context, [&](const BorderEdge&) { return distance; }));
}

}  // namespace geometry

}  // namespace rakelight
