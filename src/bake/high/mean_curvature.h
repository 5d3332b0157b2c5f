// SPDX-License-Identifier: Apache-2.0
// Mean curvature of triangle meshes at their vertices.
#pragma once
#include <span>
#include <vector>

#include <rakelight/geometry/attributes.h>

namespace rakelight::bake {

/// H = div n / 2 (do Carmo 1976, "Differential Geometry of Curves and Surfaces", section 3-3), of normals made over all
/// objects and linear on each triangle. Their divergence is the sum over the corners of n_i . (N x e_i) / (2 A), with
/// e_i the edge across corner i. A place has the mean over its triangles, weighted by their areas (as Rusinkiewicz
/// 2004, "Estimating Curvatures and Their Derivatives on Triangle Meshes", does with the whole tensor). A sphere of
/// radius r has 1 / r.
/// @return [meshes][V] [1/m] convex > 0; 0 where no triangle with an area is
std::vector<std::vector<float>> mean_curvatures(std::span<const AttributeMesh> meshes, Context& context);

}  // namespace rakelight::bake
