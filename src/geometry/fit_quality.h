// SPDX-License-Identifier: Apache-2.0
// How far a fitted height function is to be trusted, from what it leaves unexplained here and at the neighbors.
#pragma once
#include <algorithm>
#include <cmath>

#include "geometry/height_fit.h"

namespace rakelight::geometry {

/// 0 below a, 1 above b, smooth between.
inline double step_between(double x, double a, double b) {
    const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// What a fit says of a place, per weight and in squares of edges: kept for its neighbors.
struct FitQuality {
    float residual = 0, bent = 0;
    float noise = 0;  ///< residual per degree of freedom

    /// @param neighbors  that were fitted
    static FitQuality of(const HeightFit& fit, std::uint32_t neighbors, HeightForm form) {
        if (!(fit.weight > 0)) return {};
        const double residual = std::min(fit.residual / fit.weight, 1e9);
        return {float(residual), float(std::min(std::max(fit.bent / fit.weight, 1e-9), 1e9)),
                float(residual * neighbors / std::max(int(neighbors) - terms_of(form), 1))};
    }
    void operator+=(const FitQuality& o) { residual += o.residual, bent += o.bent, noise += o.noise; }

    /// The share of the heights that stays unexplained. @param around  sum over the neighbors
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

/// 0 to 1. @param allowed  factor on what the fit may leave unexplained
inline double trust(double unexplained, double allowed, double rank, std::uint32_t neighbors, HeightForm form) {
    if (int(neighbors) < terms_of(form) + 2) return 0;
    return (1 - step_between(unexplained / allowed, 0.01, 0.05)) * step_between(rank, 1e-5, 1e-4);
}

}  // namespace rakelight::geometry
