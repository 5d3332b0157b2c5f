// SPDX-License-Identifier: Apache-2.0
// Form factors in closed form.
#pragma once
#include <array>

#include <rakelight/math/linear.h>

namespace rakelight::radiosity {

/// The unoccluded form factor from a differential area to a triangle, 0..1: its cosine-weighted share of the
/// hemisphere. The triangle is clipped at the horizon; both of its sides count. Sum over its edges: Lambert 1760,
/// "Photometria"; Baum, Rushmeier & Winget 1989, "Improving Radiosity Solutions Through the Use of Analytically
/// Determined Form-Factors". Error below 1e-7.
/// @param normal  unit
double form_factor_of_triangle(dvec3 at, dvec3 normal, const std::array<dvec3, 3>& triangle);

}  // namespace rakelight::radiosity
