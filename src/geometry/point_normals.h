// SPDX-License-Identifier: Apache-2.0
// Normals of points that lie in a surface, by their neighbors.
#pragma once
#include <span>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/vector.h>

namespace rakelight::geometry {

/// For each point the direction in which it and its neighbors spread the least: the eigenvector of the least eigenvalue of their
/// covariance (Hoppe et al. 1992, "Surface Reconstruction from Unorganized Points", section 3.1). Which of the two ways it
/// points is not decided. Neighbors lie within 2.5 times the point's spacing; of many the first 48 in the order of the grid count. The
/// same bits for any number of threads.
/// @param points   [P]
/// @param spacing  [P] of point_spacing()
/// @return         [P] unit, or (0, 0, 0) where neighbors do not say; empty where the points do not lie in a surface: for half of
///                 them the least spread is more than a fifth of the middle one
/// @throws Error bad_file: over the memory limit; failed: cancelled
std::vector<vec3> point_normals(std::span<const vec3> points, std::span<const float> spacing, Context& context);

}  // namespace rakelight::geometry
