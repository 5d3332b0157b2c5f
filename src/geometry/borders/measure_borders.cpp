// SPDX-License-Identifier: Apache-2.0
// Angles between the normals of adjacent borders.
#include <rakelight/geometry/matching_borders.h>

#include <algorithm>
#include <tuple>

#include "geometry/borders/border_search.h"
#include "geometry/borders/border_surface.h"
#include "geometry/borders/measure_borders.h"
#include "geometry/groups/authored_normals.h"
#include "geometry/input/union_find.h"

namespace rakelight {
namespace {

using geometry::BorderEdge;
using geometry::BorderHit;
using geometry::BorderHits;
using geometry::Weighted;

constexpr int samples_per_edge = 4;
constexpr std::size_t edges_per_chunk = 512;

/// The nearest hit by position and normal.
const BorderHit* best_of(const BorderHits& hits) {
    const std::span<const BorderHit> all = hits.all();
    const auto at = std::min_element(all.begin(), all.end(), [](const BorderHit& a, const BorderHit& b) {
        return a.rank != b.rank ? a.rank < b.rank : a.edge < b.edge;
    });
    return at == all.end() ? nullptr : &*at;
}

/// Result of one chunk of open edges.
struct Found {
    std::vector<BorderSample> samples;
    std::vector<std::uint32_t> edges;  ///< [samples]
    std::uint64_t given_up = 0;
};

/// [degrees] Maximum change of normals along the open edges at each end of an edge.
class Turns {
public:
    explicit Turns(std::span<const BorderEdge> edges) {
        for (const BorderEdge& e : edges) {
            const double deg = degrees(geometry::angle_between(e.normal_a, e.normal_b));
            at_.push_back({e.vertex_a, deg}), at_.push_back({e.vertex_b, deg});
        }
        std::sort(at_.begin(), at_.end(),
                  [](const At& x, const At& y) { return x.vertex != y.vertex ? x.vertex < y.vertex : x.deg > y.deg; });
    }
    double about(const BorderEdge& edge) const { return std::max(of(edge.vertex_a), of(edge.vertex_b)); }

private:
    struct At {
        std::uint32_t vertex;
        double deg;
    };
    double of(std::uint32_t vertex) const {
        return std::lower_bound(at_.begin(), at_.end(), vertex,
                                [](const At& x, std::uint32_t v) { return x.vertex < v; })
            ->deg;
    }
    std::vector<At> at_;  ///< by vertex, the largest first
};

void measure_edge(const geometry::BorderSearch& search, const Turns& turns, std::uint32_t number, double radius,
                  BorderHits& hits, Found& found) {
    const BorderEdge& edge = search.edges()[number];
    bool given_up = false;
    for (int k = 0; k < samples_per_edge; ++k) {
        const double at = (k + 0.5) / samples_per_edge;
        const dvec3 normal = edge.normal(at);
        search.find(edge, edge.point(at), normal, radius, hits);
        given_up = given_up || hits.gave_up;
        const BorderHit* const hit = best_of(hits);
        if (!hit) continue;
        const BorderEdge& other = search.edges()[hit->edge];
        BorderSample sample;
        sample.a = edge.point(double(k) / samples_per_edge), sample.b = edge.point(double(k + 1) / samples_per_edge);
        sample.deg = degrees(geometry::angle_between(normal, other.normal(hit->t)));
        sample.turn_deg = std::max(turns.about(edge), turns.about(other));
        sample.gap = hit->distance, sample.mesh = edge.mesh, sample.other_mesh = hit->mesh;
        found.samples.push_back(sample);
        found.edges.push_back(number);
    }
    found.given_up += given_up ? 1 : 0;
}

/// Samples of neighboring edges that match one mesh are one run; those of short runs are dropped, as match_borders() does.
class Runs {
public:
    /// @param place [vertices] of PlacedMeshes: so that edges are neighbors across hard edges too
    Runs(std::span<const BorderEdge> edges, std::span<const std::uint32_t> place, std::vector<BorderSample>& samples,
         std::span<const std::uint32_t> edge_of)
        : samples_(samples) {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (i == 0 || edge_of[i] != edge_of[i - 1] || samples[i].other_mesh != samples[i - 1].other_mesh) {
                const BorderEdge& edge = edges[edge_of[i]];
                for (const std::uint32_t vertex : {edge.vertex_a, edge.vertex_b})
                    ends_.push_back({place[vertex], edge.mesh, samples[i].other_mesh, pieces_});
                ++pieces_;
            }
            piece_of_.push_back(pieces_ - 1);
        }
        join();
    }

    void drop_shorter_than(double least) {
        std::vector<double> run(pieces_, 0);
        for (std::size_t i = 0; i < samples_.size(); ++i)
            run[sets_.root(piece_of_[i])] += length(samples_[i].b - samples_[i].a);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < samples_.size(); ++i)
            if (run[sets_.root(piece_of_[i])] >= least) samples_[kept++] = samples_[i];
        samples_.resize(kept);
    }

private:
    struct End {
        std::uint32_t place, mesh, other_mesh, piece;
        bool meets(const End& e) const {
            return std::tie(place, mesh, other_mesh) == std::tie(e.place, e.mesh, e.other_mesh);
        }
    };
    void join() {
        sets_.reset(pieces_);
        std::sort(ends_.begin(), ends_.end(), [](const End& x, const End& y) {
            return std::tie(x.place, x.mesh, x.other_mesh, x.piece) < std::tie(y.place, y.mesh, y.other_mesh, y.piece);
        });
        for (std::size_t i = 1; i < ends_.size(); ++i)
            if (ends_[i].meets(ends_[i - 1])) sets_.join(ends_[i].piece, ends_[i - 1].piece);
    }

    std::vector<BorderSample>& samples_;
    std::uint32_t pieces_ = 0;             ///< parts of edges that match one mesh
    std::vector<std::uint32_t> piece_of_;  ///< [samples]
    std::vector<End> ends_;
    geometry::UnionFind sets_;
};

/// Samples every edge.
void find_samples(const geometry::BorderSearch& search, std::span<const std::uint32_t> place, double radius,
                  BorderMeasure& measure, Context& context) {
    const std::span<const BorderEdge> edges = search.edges();
    context.memory().check(samples_per_edge * edges.size() * (2 * sizeof(BorderSample) + 48), "measuring open borders");
    const Turns turns(edges);
    std::vector<Found> found((edges.size() + edges_per_chunk - 1) / edges_per_chunk);
    context.parallel_for(found.size(), [&](std::size_t c) {
        BorderHits hits;
        for (std::size_t e = c * edges_per_chunk; e < std::min(edges.size(), (c + 1) * edges_per_chunk); ++e)
            measure_edge(search, turns, std::uint32_t(e), radius, hits, found[c]);
    });
    std::vector<std::uint32_t> edge_of;
    for (const Found& f : found) {
        measure.samples.insert(measure.samples.end(), f.samples.begin(), f.samples.end());
        edge_of.insert(edge_of.end(), f.edges.begin(), f.edges.end());
        measure.edges_not_searched += f.given_up;
    }
    Runs(edges, place, measure.samples, edge_of).drop_shorter_than(geometry::min_run * radius);
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
    find_samples(search, surface.placed.place, options.distance, measure, context);
    geometry::sum_up(measure);
    return measure;
}

}  // namespace rakelight
