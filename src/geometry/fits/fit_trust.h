// SPDX-License-Identifier: Apache-2.0
// How far a fitted height function is to be trusted, from what it leaves unexplained here and at the neighbors, and how
// answers are blended: so that nothing jumps where trust begins.
#pragma once
#include <algorithm>
#include <cmath>

#include "geometry/fits/height_fit.h"
#include "geometry/input/face_vote.h"

namespace rakelight::geometry {

/// 0 below a, 1 above b, smooth between.
inline double step_between(double x, double a, double b) {
    const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}
inline dvec3 unit_or(dvec3 v, dvec3 otherwise) {
    const Direction d = direction_of(v);
    return d.length > 0 ? d.unit : otherwise;
}
inline dvec3 blend(dvec3 a, dvec3 b, double share) { return unit_or(a * (1 - share) + b * share, a); }
/// [rad] accurate to 2e-8
inline double angle_rad(dvec3 a, dvec3 b) { return corner_angle(length(cross(a, b)), dot(a, b)); }

/// What a fit says of a place, per weight and in squares of edges; sums of several say it of places around.
struct FitQuality {
    float residual = 0, bent = 0;
    float noise = 0;  ///< residual per degree of freedom

    /// @param neighbors  that were fitted
    static FitQuality of(const HeightFit& fit, std::size_t neighbors, HeightForm form) {
        if (!(fit.weight > 0)) return {};
        const double residual = std::min(fit.residual / fit.weight, 1e9), n = double(neighbors);
        return {float(residual), float(std::min(std::max(fit.bent / fit.weight, 1e-9), 1e9)),
                float(residual * n / std::max(n - terms_of(form), 1.0))};
    }
    FitQuality times(float share) const { return {residual * share, bent * share, noise * share}; }
    void operator+=(const FitQuality& o) { residual += o.residual, bent += o.bent, noise += o.noise; }

    /// The share of the heights that stays unexplained. @param around  where the neighbors' fits fail, this one may be
    /// right by chance
    double unexplained(const FitQuality& around) const {
        if (!(bent > 0)) return 1;
        return std::max(double(residual) / double(bent),
                        0.5 * double(around.residual) / std::max(double(around.bent), 1e-30));
    }
    /// [edges] Noise here and at the neighbors. @param around  sum over `count` neighbors
    double noise_with(const FitQuality& around, std::size_t count) const {
        return std::sqrt((double(noise) + double(around.noise) / std::max<double>(double(count), 1)) / 2);
    }
};

/// Factor on what a fit may leave unexplained: where planes rule, it must explain more.
inline double strictness(double planarity) { return 1 - 0.9 * planarity; }
/// 0 to 1: what a cubic explains better than a quadric is shape: noise it explains no better.
inline double share_of_shape(double planarity, double of_cubic, double of_quadric) {
    return (1 - planarity) * (1 - step_between(of_cubic / std::max(of_quadric, 1e-12), 0.5, 0.85));
}
/// Neighbors whose normals turn away by more are of another side of a thin part: cosine of 78 degrees.
constexpr double least_cosine_around = 0.2;
/// Of a wide fit.
constexpr std::uint32_t least_around = 8;

/// Trust in how well the neighbors determine a slope. @param certainty  HeightFit::certainty: of rows between two borders, or of one
/// row at a border, up to 0.02
constexpr double least_certainty = 0.01;
inline double trust_of_certainty(double certainty) {
    return step_between(certainty, least_certainty, 4 * least_certainty);
}

/// 0 to 1.
/// @param allowed    factor on the share of the heights that the fit may leave unexplained
/// @param determined  trust_of_certainty()
inline double trust(double unexplained, double allowed, double determined, std::size_t neighbors, HeightForm form) {
    if (neighbors < std::size_t(terms_of(form)) + 2) return 0;
    return (1 - step_between(unexplained / allowed, 0.01, 0.05)) * determined;
}
inline double trust_in(const HeightFit& fit, std::size_t neighbors, HeightForm form, const FitQuality& around,
                       double allowed) {
    const double unexplained = FitQuality::of(fit, neighbors, form).unexplained(around);
    return trust(unexplained, allowed, trust_of_certainty(fit.certainty), neighbors, form);
}

/// Not farther from a mean of faces than `most_rad`.
inline dvec3 bounded(dvec3 n, dvec3 mean, double most_rad) {
    const double off = angle_rad(n, mean);
    return off > most_rad ? blend(mean, n, most_rad / off) : n;
}

}  // namespace rakelight::geometry
