// SPDX-License-Identifier: Apache-2.0
// Normals of points on a surface, estimated from neighbors.
#pragma once
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/math/vector.h>

namespace rakelight::geometry {

/// For each point the direction of least variance of its neighborhood: the eigenvector of the smallest eigenvalue of
/// the covariance (Hoppe et al. 1992, "Surface Reconstruction from Unorganized Points", section 3.1). The sign is
/// arbitrary. Neighbors lie within 2.5 times the point's spacing; at most the first 48 in grid order are used.
/// Bit-identical for any number of threads.
/// @param points   [P]
/// @param spacing  [P] of point_spacing()
/// @return [P] unit, or (0, 0, 0) if undetermined; empty if the points are not on a surface: for half of them the
///         smallest variance is more than a fifth of the middle one
/// @throws Error bad_file: over the memory limit; failed: cancelled
std::vector<vec3> point_normals(std::span<const vec3> points, std::span<const float> spacing, Context& context);

}  // namespace rakelight::geometry
