// SPDX-License-Identifier: Apache-2.0
// Each place is decided by itself, from sums over its faces, planes, and height functions over two rings: a blend of up
// to five answers, so that neither small changes nor another order of the input make it jump.
#include "geometry/fits/fit_normals.h"

#include <algorithm>
#include <cmath>

#include "geometry/fits/fit_trust.h"
#include "geometry/fits/height_fit.h"
#include "geometry/fits/place_faces.h"
#include "geometry/fits/two_rings.h"

namespace rakelight::geometry {
namespace {

enum class Choice : std::uint8_t { plane, fit, edge_fit, noise, planar, angle };
constexpr std::uint64_t NormalChoices::*count_of[] = {&NormalChoices::plane,    &NormalChoices::fit,
                                                      &NormalChoices::edge_fit, &NormalChoices::noise,
                                                      &NormalChoices::planar,   &NormalChoices::angle};

/// What the fits of a place say, for itself.
struct Fits {
    vec3 cubic, quadric;                       ///< unit normals
    float cubic_trust = 0, quadric_trust = 0;  ///< trust_of_certainty()
    std::uint32_t neighbors = 0;
    Choice choice = Choice::fit;
};
/// And for its neighbors.
struct Qualities {
    FitQuality cubic, quadric;
    float cubic_share = 0, quadric_share = 0;  ///< as far as the fits are determined, and count here
};

class NormalFits {
public:
    NormalFits(const FitInput& from, GeneralScratch& scratch, Context& context)
        : from_(from),
          topology_(from.topology),
          context_(context),
          scratch_(scratch),
          found_(find_fitted_places(from, scratch, context)),
          rings_(found_.rings),
          fitted_(found_.places),
          number_(scratch.take_words()) {
        number_.assign(topology_.group.size(), none);
        charge_ = {context.memory(),
                   fitted_.size() * (sizeof(FittedPlace) + sizeof(Fits) + sizeof(Qualities)) +
                       topology_.group.size() * sizeof(vec3) + std::uint64_t(context.threads()) * bytes_of_largest(),
                   "fitting normals"};
        for (std::size_t i = 0; i < fitted_.size(); ++i) number_[fitted_[i].group] = std::uint32_t(i);
        fits_ = scratch.take<Fits>(fitted_.size()), qualities_ = scratch.take<Qualities>(fitted_.size());
        normals_ = scratch.take<vec3>(topology_.group.size());
    }
    ~NormalFits() {
        found_.release(scratch_);
        scratch_.give(number_);
        scratch_.give(fits_), scratch_.give(qualities_);
    }
    NormalFits(const NormalFits&) = delete;
    NormalFits& operator=(const NormalFits&) = delete;

    void run() {
        const std::size_t count = topology_.group.size(), step = vertices_per_chunk;
        context_.parallel_for((count + step - 1) / step, [&](std::size_t c) {
            std::fill(normals_.data() + c * step, normals_.data() + std::min(count, (c + 1) * step), vec3{});
        });
        each_chunk([&](std::size_t first, std::size_t last) { fit(first, last); });
        each_chunk([&](std::size_t first, std::size_t last) {
            if (from_.is_automatic)
                decide(first, last);
            else
                for (std::size_t i = first; i < last; ++i) normals_[fitted_[i].group] = cast<float>(fitted(i));
        });
    }

    /// After run().
    NormalChoices choices() const {
        NormalChoices sum;
        for (std::uint32_t g = 0; g < topology_.group.size(); ++g)
            if (topology_.group[g] == g && number_[g] == none && from_.by_max[g] != vec3{}) ++sum.smooth;
        for (std::size_t i = 0; i < fitted_.size(); ++i) ++(sum.*count_of[std::size_t(fits_[i].choice)]);
        return sum;
    }

    /// [groups] After run(). Zero: nothing was fitted.
    BlockArray<vec3> take_normals() { return std::move(normals_); }

private:
    static constexpr std::uint32_t none = 0xffffffffu;

    struct Memory {
        GroupSet groups;
        HeightBatch batch;
    };

    /// Of the two rings of the most crowded place, at most: where many faces meet, most of the memory.
    std::uint64_t bytes_of_largest() const {
        std::uint64_t most = 0;
        for (const FittedPlace& place : fitted_) most = std::max<std::uint64_t>(most, rings_.corners.size(place.group));
        const std::uint64_t places = std::min<std::uint64_t>(2 * most * most_to_widen, topology_.group.size());
        return places * (3 * height_lanes * sizeof(double) + sizeof(dvec3) + 4 * sizeof(std::uint32_t));
    }

    template <class Body>
    void each_chunk(const Body& body) {
        const std::size_t count = fitted_.size(), step = 1u << 12;
        context_.parallel_for((count + step - 1) / step,
                              [&](std::size_t c) { body(c * step, std::min(count, (c + 1) * step)); });
    }

    dvec3 by_max(std::uint32_t g) const { return cast<double>(from_.by_max[g]); }

    /// Adds a place with the places of its two rings to the batch.
    void gather(std::uint32_t g, dvec3 guess, Memory& memory) const {
        two_rings(rings_, g, memory.groups);
        const std::span<const std::uint32_t> groups = memory.groups.groups();
        const std::size_t ring = rings_.ring_size[g];
        const dvec3* const places = rings_.places.data();
        const dvec3 at = places[g];
        double squares = 0;
        for (std::size_t i = 1; i <= ring; ++i) {
            const dvec3 d = places[groups[i]] - at;
            squares += dot(d, d);
        }
        const double scale = std::sqrt(double(ring) / squares);  // one over the root of the mean square of the edges
        const vec3* const normals = from_.by_max.data();
        const vec3 n = normals[g];
        memory.batch.add_place(groups.size(), scale, guess, [&](const auto& put) {
            if (!(scale > 0 && std::isfinite(scale))) return;
            for (const std::uint32_t u : groups.subspan(1))
                put(places[u] - at, dot(normals[u], n) > float(least_cosine_around));
        });
    }

    void fit(std::size_t first, std::size_t last) {
        Memory memory;
        for (std::size_t i = first; i < last; ++i) {
            const std::uint32_t g = fitted_[i].group;
            gather(g, by_max(g), memory);
            fits_[i].neighbors = memory.batch.neighbors();
            if (memory.batch.is_full() || i + 1 == last) take_fits(memory.batch, i + 1 - memory.batch.size());
        }
    }
    void take_fits(HeightBatch& batch, std::size_t first) {
        batch.fit();
        for (std::uint32_t place = 0; place < batch.size(); ++place) {
            const HeightFit cubic = batch.cubic(place), quadric = batch.quadric(place);
            const std::uint32_t neighbors = fits_[first + place].neighbors;
            const double cubic_trust = trust_of_certainty(cubic.certainty),
                         quadric_trust = trust_of_certainty(quadric.certainty),
                         share = share_of_fit(fitted_[first + place].faces);
            fits_[first + place] = {cast<float>(cubic.normal), cast<float>(quadric.normal), float(cubic_trust),
                                    float(quadric_trust), neighbors};
            qualities_[first + place] = {FitQuality::of(cubic, neighbors, HeightForm::cubic),
                                         FitQuality::of(quadric, neighbors, HeightForm::quadric),
                                         float(share * cubic_trust), float(share * quadric_trust)};
        }
        batch.clear();
    }

    /// Without looking at planes and noise.
    dvec3 fitted(std::size_t i) const {
        const Fits& f = fits_[i];
        const bool is_cubic = !fitted_[i].is_border && f.neighbors >= 11 && f.cubic_trust > 0;
        const bool is_quadric = f.neighbors >= 7 && f.quadric_trust > 0;
        return is_cubic ? cast<double>(f.cubic) : is_quadric ? cast<double>(f.quadric) : by_max(fitted_[i].group);
    }

    /// How a place is decided, but for what noise asks for.
    struct Decision {
        PlanesAtPlace planes;
        double planarity = 0, cubic = 0, quadric = 0;  ///< 0 to 1: of planes, trust in the fits
        double noise = 0, wide = 0;                    ///< [edges], 0 to 1
        dvec3 wide_normal;
    };

    void decide(std::size_t first, std::size_t last) {
        Memory memory;
        std::vector<Decision> decisions(last - first);
        std::vector<std::size_t> wide;
        const auto fit_wide = [&] {
            memory.batch.fit_wide();
            for (std::uint32_t place = 0; place < memory.batch.size(); ++place) {
                const HeightFit fit = memory.batch.wide(place);
                decisions[wide[place]].wide_normal = fit.normal;
                decisions[wide[place]].wide *= trust_of_certainty(fit.certainty);
            }
            memory.batch.clear(), wide.clear();
        };
        std::vector<std::uint32_t> planes;
        for (std::size_t i = first; i < last; ++i) {
            Decision& d = decisions[i - first];
            d = decision(i, planes);
            if (!(d.wide > 0)) continue;
            gather(fitted_[i].group, wide_guess(fitted_[i].group), memory);
            wide.push_back(i - first);
            if (memory.batch.is_full()) fit_wide();
        }
        if (memory.batch.size() > 0) fit_wide();
        for (std::size_t i = first; i < last; ++i) {
            normals_[fitted_[i].group] = cast<float>(decided(i, decisions[i - first]));
            fits_[i].choice = choice_of(decisions[i - first]);
        }
    }

    Decision decision(std::size_t i, std::vector<std::uint32_t>& memory) const {
        const auto [g, is_border, faces] = fitted_[i];
        Decision d{.planes = planes_at(rings_, found_.planes, g, memory)};
        d.planarity = step_between(d.planes.planar_share, 0.4, 0.6);
        const double strict = strictness(d.planarity);
        FitQuality around_cubic, around_quadric;
        for (const std::uint32_t u : rings_.ring(g)) {
            if (number_[u] == none) continue;
            const Qualities& q = qualities_[number_[u]];
            around_cubic += q.cubic.times(q.cubic_share), around_quadric += q.quadric.times(q.quadric_share);
        }
        const Qualities& own = qualities_[i];
        const Fits& fits = fits_[i];
        const std::size_t ring = rings_.ring_size[g];
        d.quadric = trust(own.quadric.unexplained(around_quadric), strict, double(fits.quadric_trust), fits.neighbors,
                          HeightForm::quadric);
        if (d.planarity > 0 && d.quadric > 0 && is_strip(i)) d.quadric *= 1 - d.planarity;
        d.noise = own.quadric.noise_with(around_quadric, ring);
        double shape = 0;
        if (!is_border) {
            const double of_quadric = d.noise;
            d.noise = own.cubic.noise_with(around_cubic, ring);
            shape = share_of_shape(d.planarity, d.noise, of_quadric);
            d.cubic = trust(own.cubic.unexplained(around_cubic), strict * (1 + 2 * shape), double(fits.cubic_trust),
                            fits.neighbors, HeightForm::cubic);
        }
        if (d.planarity > 0 && !is_border) {
            const double fitted = 1 - d.planarity * agreement(i);
            d.cubic *= fitted, d.quadric *= fitted;
        }
        if (fits.neighbors >= least_around && d.cubic < 1 && d.quadric < 1)
            d.wide = step_between(d.noise, 0.01, 0.03) * (1 - d.planarity) * (1 - shape);
        return d;
    }

    /// Whether the surface around a border is one row of faces: it ends at all neighbors, too. Where both ends of a row are
    /// circles, they lie on a cone and on a sphere: a fit cannot tell which, planar faces can.
    bool is_strip(std::size_t i) const {
        return fitted_[i].is_border && std::ranges::all_of(rings_.ring(fitted_[i].group),
                                                           [&](std::uint32_t u) { return is_border(rings_, u); });
    }

    /// 0 to 1: of the weights `max` and `angle`, in parts of the faces' spread. Where planar faces meet alike on both sides,
    /// as around a cone, both are exact, and a fit is not.
    double agreement(std::size_t i) const {
        const std::uint32_t g = fitted_[i].group;
        const double c = double(fitted_[i].faces.least_cosine),
                     spread = corner_angle(std::sqrt(std::max(1 - c * c, 0.0)), c);
        const double off = angle_rad(normal_by_angle(rings_, g, by_area(i)), by_max(g));
        return 1 - step_between(off / std::max(spread, 1e-6), 0.001, 0.004);
    }

    /// 0 to 1: of a place whose faces spread so much. It begins where places are fitted.
    static double share_of_fit(const PlaceFaces& faces) {
        constexpr double mild = 1 - mild_cosine;
        return step_between(1 - double(faces.least_cosine), mild, 2 * mild);
    }

    dvec3 by_area(std::size_t i) const { return cast<double>(fitted_[i].faces.by_area); }
    dvec3 wide_guess(std::uint32_t g) const {
        const dvec3 own = by_area(number_[g]);
        dvec3 guess = own;
        for (const std::uint32_t u : rings_.ring(g)) guess += number_[u] == none ? by_max(u) : by_area(number_[u]);
        return unit_or(guess, own);
    }

    dvec3 decided(std::size_t i, const Decision& d) const {
        dvec3 n = cast<double>(fits_[i].cubic);
        if (d.cubic < 1) {
            n = d.quadric < 1 ? blend(base(i, d), cast<double>(fits_[i].quadric), d.quadric)
                              : cast<double>(fits_[i].quadric);
            n = blend(n, cast<double>(fits_[i].cubic), d.cubic);
        }
        n = bounded(n, i);
        if (!fitted_[i].is_border) n = blend(by_max(fitted_[i].group), n, share_of_fit(fitted_[i].faces));
        const double plane = share_of_plane(d);
        return plane > 0 ? blend(n, d.planes.normal, plane) : n;
    }

    static double share_of_plane(const Decision& d) {
        return d.planes.rules ? step_between(d.planes.share, 0.78, 0.86) : 0;
    }
    static Choice choice_of(const Decision& d) {
        if (share_of_plane(d) > 0.5) return Choice::plane;
        if (d.cubic > 0.5) return Choice::fit;
        if (d.quadric > 0.5) return Choice::edge_fit;
        if (d.wide > 0.5) return Choice::noise;
        return d.planarity > 0.5 ? Choice::planar : Choice::angle;
    }

    /// Where no fit is trusted.
    dvec3 base(std::size_t i, const Decision& d) const {
        const std::uint32_t g = fitted_[i].group;
        const dvec3 n = blend(normal_by_angle(rings_, g, by_area(i)), by_max(g), d.planarity);
        if (!(d.wide > 0)) return n;
        const double off = angle_rad(d.wide_normal, by_area(i)) / std::max(d.noise, 1e-8);
        return blend(n, d.wide_normal, d.wide * (1 - step_between(off, 4, 8)));
    }

    /// Not farther from the faces' mean than they spread; at an open border the surface goes on outside of them.
    dvec3 bounded(dvec3 n, std::size_t i) const {
        const dvec3 mean = by_area(i);
        const double c = double(fitted_[i].faces.least_cosine);
        if (dot(n, mean) >= c || mean == dvec3{}) return n;
        const double spread = corner_angle(std::sqrt(std::max(1 - c * c, 0.0)), c);
        return geometry::bounded(n, mean, (fitted_[i].is_border ? 3 : 1) * spread + radians(1));
    }

    const FitInput from_;
    const Topology& topology_;
    Context& context_;
    GeneralScratch& scratch_;
    FittedPlaces found_;
    const GroupRings& rings_;
    const std::vector<FittedPlace>& fitted_;
    std::vector<std::uint32_t> number_;  // [groups] in fitted_, or none
    BlockArray<Fits> fits_;              // [fitted_]
    BlockArray<Qualities> qualities_;    // [fitted_]
    BlockArray<vec3> normals_;           // [groups] zero: nothing was fitted
    MemoryCharge charge_;
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

BlockArray<vec3> fit_groups(const FitInput& from, GeneralScratch& scratch, Context& context, NormalChoices* choices) {
    NormalFits fits(from, scratch, context);
    fits.run();
    if (choices) *choices = fits.choices();
    return fits.take_normals();
}

void fit_normals(VoteSums& sums, const Topology& topology, const AttributeInput& input, const AttributeOptions& options,
                 GeneralScratch& scratch, Context& context, NormalChoices* choices) {
    const std::size_t count = topology.group.size(), step = vertices_per_chunk;
    const MemoryCharge charge(context.memory(), 2 * count * sizeof(vec3), "fitting normals");
    BlockArray<vec3> by_max = scratch.take<vec3>(count);
    context.parallel_for((count + step - 1) / step, [&](std::size_t c) {
        for (std::size_t row = c * step; row < std::min(count, (c + 1) * step); ++row)
            by_max[row] = cast<float>(direction_of(sums.normals[row].normal).unit);
    });
    const FitInput from{
        topology, input, std::span(by_max.data(), count), {}, options.weight == CornerWeight::automatic};
    BlockArray<vec3> normals = fit_groups(from, scratch, context, choices);
    const std::vector<std::uint8_t> keeps = groups_with_authored(topology, input);
    context.parallel_for((count + step - 1) / step, [&](std::size_t c) {
        for (std::size_t row = c * step; row < std::min(count, (c + 1) * step); ++row) {
            const std::uint32_t g = topology.group[row];
            NormalRow& sum = sums.normals[row];
            const bool takes = (keeps.empty() || keeps[g] == 0) && sum.weight > 0 && !has_cancelled(sum);
            const dvec3 n = takes ? cast<double>(normals[g]) : dvec3{};
            if (n != dvec3{}) sum.normal = n * sum.weight;
        }
    });
    scratch.give(by_max), scratch.give(normals);
    scratch.free_spare();
}

}  // namespace rakelight::geometry
