// SPDX-License-Identifier: Apache-2.0
// The normal of a place by a height function that is fitted to its neighbors by least squares. Kin: Cazals & Pouget 2003,
// "Estimating differential quantities using polynomial fitting of osculating jets". Ours: the quadratic terms of a
// neighbor (x, y, z) are multiplied by (x^2 + y^2 + z^2) / (x^2 + y^2), so that normal sections are circles through the
// place, not parabolas. So spheres are exact, and cylinders across their axis.
#pragma once
#include <span>

#include <rakelight/vector.h>

namespace rakelight::geometry {

/// - `quadric`, `cubic`: through the place; neighbors count by the inverse fourth power of their distance.
/// - `wide`: a quadric that need not meet the place, which is one neighbor of many: for noise. All count alike.
enum class HeightForm { quadric, cubic, wide };

/// Number of coefficients.
constexpr int terms_of(HeightForm form) { return form == HeightForm::cubic ? 9 : form == HeightForm::quadric ? 5 : 6; }

struct HeightFit {
    dvec3 normal;         ///< unit
    double residual = 0;  ///< sum of weight times the square of what is unexplained
    double weight = 0;    ///< sum of weights
    double bent = 0;      ///< sum of weight times the square of the heights above the tangent plane
    /// Of the matrix of the normal equations, its diagonal scaled to 1: a lower bound of its smallest eigenvalue, at
    /// least a ninth of it. 0: the neighbors do not determine the coefficients.
    double rank = 0;
};

/// @param neighbors  from the place, in units of about an edge
/// @param normal     unit, a first guess, to which the heights are measured
HeightFit fit_height(std::span<const dvec3> neighbors, dvec3 normal, HeightForm form);

}  // namespace rakelight::geometry
