// SPDX-License-Identifier: Apache-2.0
// How far a fitted height function is trusted, and how answers are blended: so that nothing jumps where trust begins.
#pragma once
#include <algorithm>

#include "geometry/face_vote.h"
#include "geometry/height_fit.h"

namespace rakelight::geometry {

/// 0 below a, 1 above b, smooth between.
inline double step_between(double x, double a, double b) {
    const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}
inline dvec3 blend(dvec3 a, dvec3 b, double share) { return normalize_or(a * (1 - share) + b * share, a); }
/// [rad] accurate to 2e-8
inline double angle_rad(dvec3 a, dvec3 b) { return corner_angle(length(cross(a, b)), dot(a, b)); }

/// What a fit says of a place, per weight; sums of several say it of places around.
struct FitQuality {
    double residual = 0, bent = 0;
    FitQuality& operator+=(const FitQuality& other) {
        residual += other.residual, bent += other.bent;
        return *this;
    }
};
inline FitQuality quality_of(const HeightFit& fit) {
    if (!(fit.weight > 0)) return {};
    return {std::min(fit.residual / fit.weight, 1e9), std::max(fit.bent, 1e-9 * fit.weight) / fit.weight};
}

/// 0 to 1.
/// @param around   sum over the fits of the neighbors: where they fail, this one may be right by chance
/// @param allowed  factor on the share of the heights that the fit may leave unexplained
inline double trust_in(const HeightFit& fit, std::size_t neighbors, HeightForm form, const FitQuality& around,
                       double allowed) {
    if (!(fit.weight > 0) || neighbors < std::size_t(terms_of(form)) + 2) return 0;
    const FitQuality own = quality_of(fit);
    const double unexplained = std::max(own.residual / own.bent, 0.5 * around.residual / std::max(around.bent, 1e-30));
    return (1 - step_between(unexplained / allowed, 0.01, 0.05)) * step_between(fit.rank, 1e-5, 1e-4);
}

/// Not farther from a mean of faces than `most_rad`.
inline dvec3 bounded(dvec3 n, dvec3 mean, double most_rad) {
    const double off = angle_rad(n, mean);
    return off > most_rad ? blend(mean, n, most_rad / off) : n;
}

}  // namespace rakelight::geometry
