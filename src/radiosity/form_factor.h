// SPDX-License-Identifier: Apache-2.0
// Form factors in closed form.
#pragma once
#include <array>

#include <rakelight/linear.h>

namespace rakelight::radiosity {

/// Share of the hemisphere over a point, by the cosine law, that a triangle takes which nothing hides: the form factor from a
/// differential area to a polygon, 0..1. What lies below the point's horizon is cut off; both sides of the triangle count.
/// The sum of its edges' angles: Lambert 1760, "Photometria"; Baum, Rushmeier & Winget 1989, "Improving Radiosity Solutions
/// Through the Use of Analytically Determined Form-Factors". Good to 1e-7.
/// @param normal  unit
double form_factor_of_triangle(dvec3 at, dvec3 normal, const std::array<dvec3, 3>& triangle);

}  // namespace rakelight::radiosity
