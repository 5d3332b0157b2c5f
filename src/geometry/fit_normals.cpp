// SPDX-License-Identifier: Apache-2.0
// Each place is decided by itself, from sums over its faces, planes, and height functions over two rings: a blend of up
// to five answers, so that neither small changes nor another order of the input make it jump.
#include "geometry/fit_normals.h"

#include <algorithm>
#include <cmath>

#include "geometry/face_vote.h"
#include "geometry/group_planes.h"
#include "geometry/height_fit.h"

namespace rakelight::geometry {
namespace {

/// 0 below a, 1 above b, smooth between.
double step_between(double x, double a, double b) {
    const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}
dvec3 blend(dvec3 a, dvec3 b, double share) { return normalize_or(a * (1 - share) + b * share, a); }
double angle_rad(dvec3 a, dvec3 b) { return corner_angle(length(cross(a, b)), dot(a, b)); }

/// What the faces of a place say.
struct Place {
    dvec3 by_area, by_angle;  ///< unit
    double edge = 0;          ///< [m] root of the mean square of the edges
    double spread_rad = 0;    ///< of the faces' normals from by_angle
    std::uint32_t faces = 0;
};

/// What a fit says of a place, kept for its neighbors.
struct Quality {
    double residual = 0, bent = 0;  ///< per weight
};
struct Fits {
    HeightFit cubic, quadric;
    std::uint32_t neighbors = 0;
};

/// Cosines of the spread of faces below which nothing is fitted: 1 degree, where the weight of Max errs by 0.3 of the spread
/// in the mean; 0.02 degrees at open borders and creases, outside of which the surface goes on.
constexpr double mild_cosine = 0.99984769515639123, flat_cosine = 0.99999993907;

/// Neighbors of more than this many places are not passed through to the second ring.
constexpr std::uint32_t most_to_widen = 64;
/// Neighbors whose normals turn away by more are of another side of a thin part: cosine of 78 degrees.
constexpr double least_cosine = 0.2;

class NormalFits {
public:
    NormalFits(const VoteSums& sums, const Topology& topology, const AttributeInput& input, bool is_automatic,
               Context& context)
        : sums_(sums),
          topology_(topology),
          is_automatic_(is_automatic),
          context_(context),
          rings_(group_rings(topology, input, context)),
          fitted_(groups_to_fit()),
          number_(topology.group.size(), none),
          planes_(is_automatic && !fitted_.empty() ? face_planes(rings_, topology, input, context) : FacePlanes{}),
          places_(checked(fitted_.size(), context)),
          fits_(fitted_.size()) {
        for (std::size_t i = 0; i < fitted_.size(); ++i) number_[fitted_[i]] = std::uint32_t(i);
    }

    /// @param take  (group, unit normal)
    template <class Take>
    void run(const Take& take) {
        each([&](std::uint32_t g, Memory&) { place(g) = place_of(g); });
        each([&](std::uint32_t g, Memory& memory) { fits(g) = fits_of(g, memory); });
        each([&](std::uint32_t g, Memory& memory) {
            if (place(g).faces > 0) take(g, is_automatic_ ? decided(g, memory) : fitted(g));
        });
    }

private:
    struct Memory {
        std::vector<std::uint32_t> groups;
        std::vector<dvec3> neighbors;
    };

    template <class Body>
    void each(const Body& body) {
        const std::size_t count = fitted_.size(), step = 1u << 12;
        context_.parallel_for((count + step - 1) / step, [&](std::size_t c) {
            Memory memory;
            for (std::size_t i = c * step; i < std::min(count, (c + 1) * step); ++i) body(fitted_[i], memory);
        });
    }

    static constexpr std::uint32_t none = 0xffffffffu;
    Place& place(std::uint32_t g) { return places_[number_[g]]; }
    const Place& place(std::uint32_t g) const { return places_[number_[g]]; }
    Fits& fits(std::uint32_t g) { return fits_[number_[g]]; }
    /// Nothing where nothing is fitted.
    const Fits& fits(std::uint32_t g) const {
        static const Fits nothing;
        return number_[g] == none ? nothing : fits_[number_[g]];
    }
    dvec3 by_max(std::uint32_t g) const { return direction_of(sums_.normals[g].normal).unit; }

    static std::size_t checked(std::size_t count, Context& context) {
        context.memory().check(count * (sizeof(Place) + sizeof(Fits)), "fitting normals");
        return count;
    }

    /// By the weight of Max the normal would be off by more than a little.
    bool needs_fit(std::uint32_t g) const {
        const dvec3 n = by_max(g);
        double least = 1;
        std::uint32_t faces = 0;
        for (const std::uint32_t corner : rings_.corners[g]) {
            if (!rings_.is_face(corner / 3)) continue;
            least = std::min(least, dot(rings_.face_normals[corner / 3], n));
            ++faces;
        }
        const bool is_at_border = rings_.ring_size[g] > faces;
        return faces > 0 && (!is_automatic_ || !(least > (is_at_border ? flat_cosine : mild_cosine)));
    }

    /// Ascending.
    std::vector<std::uint32_t> groups_to_fit() {
        const std::size_t count = topology_.group.size(), step = vertices_per_chunk;
        std::vector<std::vector<std::uint32_t>> parts((count + step - 1) / step);
        context_.parallel_for(parts.size(), [&](std::size_t c) {
            for_each_group(topology_, c * step, std::min(count, (c + 1) * step), [&](std::uint32_t g) {
                if (needs_fit(g)) parts[c].push_back(g);
            });
        });
        std::vector<std::uint32_t> all;
        for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
        return all;
    }

    Place place_of(std::uint32_t g) const {
        Place p;
        double squares = 0;
        for (const std::uint32_t corner : rings_.corners[g]) {
            const std::uint32_t t = corner / 3, k = corner % 3;
            if (!rings_.is_face(t)) continue;
            const dvec3 at = rings_.places[g], a = rings_.places[rings_.group_of_corner[3 * t + (k + 1) % 3]] - at,
                        b = rings_.places[rings_.group_of_corner[3 * t + (k + 2) % 3]] - at;
            const double area2 = length(cross(a, b)), aa = dot(a, a), bb = dot(b, b);
            const dvec3 n = rings_.face_normals[t];
            p.by_area += n * area2;
            p.by_angle += n * corner_angle(area2, dot(a, b));
            squares += aa + bb;
            ++p.faces;
        }
        p.by_angle = normalize_or(p.by_angle, {}), p.by_area = normalize_or(p.by_area, p.by_angle);
        if (p.by_angle == dvec3{}) p.faces = 0;
        if (p.faces == 0) return p;
        p.edge = std::sqrt(squares / (2 * p.faces));
        for (const std::uint32_t corner : rings_.corners[g])
            if (rings_.is_face(corner / 3))
                p.spread_rad = std::max(p.spread_rad, angle_rad(rings_.face_normals[corner / 3], p.by_angle));
        return p;
    }

    bool is_border(std::uint32_t g) const { return rings_.ring_size[g] > place(g).faces; }

    /// The places of two rings, from g, in edges.
    void gather(std::uint32_t g, Memory& memory) const {
        std::vector<std::uint32_t>& all = memory.groups;
        all.assign(rings_.ring(g).begin(), rings_.ring(g).end());
        for (const std::uint32_t u : rings_.ring(g))
            if (rings_.ring_size[u] <= most_to_widen)
                all.insert(all.end(), rings_.ring(u).begin(), rings_.ring(u).end());
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        memory.neighbors.clear();
        const double scale = 1 / place(g).edge;
        const dvec3 n = by_max(g);
        for (const std::uint32_t u : all)
            if (u != g && dot(by_max(u), n) > least_cosine)
                memory.neighbors.push_back((rings_.places[u] - rings_.places[g]) * scale);
    }

    Fits fits_of(std::uint32_t g, Memory& memory) const {
        if (place(g).faces == 0 || !(place(g).edge > 0)) return {};
        gather(g, memory);
        const dvec3 guess = by_max(g);
        return {fit_height(memory.neighbors, guess, HeightForm::cubic),
                fit_height(memory.neighbors, guess, HeightForm::quadric), std::uint32_t(memory.neighbors.size())};
    }

    static Quality quality_of(const HeightFit& fit) {
        if (!(fit.weight > 0)) return {};
        return {std::min(fit.residual / fit.weight, 1e9), std::max(fit.bent, 1e-9 * fit.weight) / fit.weight};
    }

    struct Judged {
        double trust = 0;  ///< 0 to 1
        double noise = 0;  ///< [edges] unexplained height per degree of freedom
    };
    /// @param which    Fits::cubic or quadric
    /// @param allowed  factor on what the fit may leave unexplained
    Judged judge(std::uint32_t g, HeightFit Fits::*which, int terms, double allowed) const {
        const HeightFit& fit = fits(g).*which;
        const std::uint32_t n = fits(g).neighbors;
        if (!(fit.weight > 0)) return {};
        const Quality own = quality_of(fit);
        Quality around;
        for (const std::uint32_t u : rings_.ring(g)) {
            const Quality q = quality_of(fits(u).*which);
            around.residual += q.residual, around.bent += q.bent;
        }
        const double unexplained =
            std::max(own.residual / own.bent, 0.5 * around.residual / std::max(around.bent, 1e-30));
        Judged out;
        out.trust = (1 - step_between(unexplained / allowed, 0.01, 0.05)) * step_between(fit.rank, 1e-5, 1e-4);
        if (n < std::uint32_t(terms) + 2) out.trust = 0;
        out.noise = std::sqrt(own.residual * n / std::max(int(n) - terms, 1));
        return out;
    }
    double noise_around(std::uint32_t g, double own, HeightFit Fits::*which, int terms) const {
        const std::span<const std::uint32_t> ring = rings_.ring(g);
        double sum = 0;
        for (const std::uint32_t u : ring) {
            const Quality q = quality_of(fits(u).*which);
            const int n = int(fits(u).neighbors);
            sum += q.residual * n / std::max(n - terms, 1);
        }
        return std::sqrt((own * own + sum / std::max<double>(double(ring.size()), 1)) / 2);
    }

    /// Without looking at planes and noise.
    dvec3 fitted(std::uint32_t g) const {
        const Fits& f = fits(g);
        const bool is_cubic = !is_border(g) && f.neighbors >= 11 && f.cubic.rank > 1e-5;
        const bool is_quadric = f.neighbors >= 7 && f.quadric.rank > 1e-5;
        return is_cubic ? f.cubic.normal : is_quadric ? f.quadric.normal : by_max(g);
    }

    dvec3 wide_normal(std::uint32_t g, Memory& memory) const {
        const dvec3 own = place(g).by_area;
        dvec3 guess = own;
        for (const std::uint32_t u : rings_.ring(g)) guess += number_[u] == none ? by_max(u) : place(u).by_area;
        gather(g, memory);
        return fit_height(memory.neighbors, normalize_or(guess, own), HeightForm::wide).normal;
    }

    dvec3 decided(std::uint32_t g, Memory& memory) const {
        const Place& p = place(g);
        const PlanesAtPlace planes = planes_at(rings_, planes_, g, memory.groups);
        const double planarity = step_between(planes.planar_share, 0.4, 0.6);
        const bool border = is_border(g);
        const double strict = 1 - 0.9 * planarity;  // where planes rule, the fit must explain more
        const Judged quadric = judge(g, &Fits::quadric, 5, strict);
        double noise = noise_around(g, quadric.noise, &Fits::quadric, 5), shape = 0;
        Judged cubic;
        if (!border) {
            cubic = judge(g, &Fits::cubic, 9, strict);
            const double of_quadric = noise;
            noise = noise_around(g, cubic.noise, &Fits::cubic, 9);
            // What a cubic explains better than a quadric is shape: noise it explains no better.
            shape = (1 - planarity) * (1 - step_between(noise / std::max(of_quadric, 1e-12), 0.5, 0.85));
            if (shape > 0) cubic = judge(g, &Fits::cubic, 9, strict * (1 + 2 * shape));
        }
        dvec3 base = blend(p.by_angle, by_max(g), planarity);
        double wide = step_between(noise, 0.01, 0.03) * (1 - planarity) * (1 - shape);
        if (fits(g).neighbors < 8) wide = 0;
        if (wide > 0) {
            const dvec3 n = wide_normal(g, memory);
            wide *= 1 - step_between(angle_rad(n, p.by_area) / std::max(noise, 1e-8), 4, 8);
            base = blend(base, n, wide);
        }
        dvec3 n = blend(base, fits(g).quadric.normal, quadric.trust);
        n = blend(n, fits(g).cubic.normal, cubic.trust);
        n = bounded(n, p, border);
        if (!planes.rules) return n;
        return blend(n, planes.normal, step_between(planes.share, 0.78, 0.86));
    }

    /// Not farther from the faces' mean than they spread; at an open border the surface goes on outside of them.
    static dvec3 bounded(dvec3 n, const Place& p, bool border) {
        const double off = angle_rad(n, p.by_angle), most = (border ? 3 : 1) * p.spread_rad + radians(1);
        return off > most ? blend(p.by_angle, n, most / off) : n;
    }

    const VoteSums& sums_;
    const Topology& topology_;
    bool is_automatic_;
    Context& context_;
    GroupRings rings_;
    std::vector<std::uint32_t> fitted_;  // groups
    std::vector<std::uint32_t> number_;  // [groups] in fitted_, or none
    FacePlanes planes_;
    std::vector<Place> places_;  // [fitted_]
    std::vector<Fits> fits_;     // [fitted_]
};

/// [groups] whether the normal is that of authored members; empty: none is.
std::vector<std::uint8_t> groups_with_authored(const Topology& topology, const AttributeInput& input) {
    std::vector<std::uint8_t> marks;
    for (std::uint32_t m = 0; m < input.meshes.size(); ++m)
        if (!input.meshes[m].locked.empty()) marks.resize(topology.group.size(), 0);
    if (marks.empty()) return marks;
    for (std::size_t row = 0; row < topology.group.size(); ++row) {
        const std::uint32_t v = topology.source_of(input, std::uint32_t(row)), m = input.mesh_of_vertex(v);
        if (is_authored(input.meshes[m], v - input.vertex_base[m])) marks[topology.group[row]] = 1;
    }
    return marks;
}

}  // namespace

void fit_normals(VoteSums& sums, const Topology& topology, const AttributeInput& input, const AttributeOptions& options,
                 Context& context) {
    std::vector<dvec3> normals(topology.group.size());  // of representatives
    NormalFits(sums, topology, input, options.weight == CornerWeight::automatic, context)
        .run([&](std::uint32_t g, dvec3 n) { normals[g] = n; });
    const std::vector<std::uint8_t> keeps = groups_with_authored(topology, input);
    const std::size_t count = topology.group.size(), step = vertices_per_chunk;
    context.parallel_for((count + step - 1) / step, [&](std::size_t c) {
        for (std::size_t row = c * step; row < std::min(count, (c + 1) * step); ++row) {
            const std::uint32_t g = topology.group[row];
            NormalRow& sum = sums.normals[row];
            const bool takes = (keeps.empty() || keeps[g] == 0) && sum.weight > 0 && !has_cancelled(sum);
            if (takes && normals[g] != dvec3{}) sum.normal = normals[g] * sum.weight;
        }
    });
}

}  // namespace rakelight::geometry
