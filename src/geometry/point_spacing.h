// SPDX-License-Identifier: Apache-2.0
// Local spacing of the points of a cloud.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/context.h>
#include <rakelight/vector.h>

namespace rakelight::geometry {

/// For each point the side of a square cell that holds one point, if those around it lie in a surface: the median
/// splits of a k-d tree (Bentley 1975) leave groups of 8 to 16 neighbors, and a group of m points in a box with the
/// longest sides a and b fills m squares of side s where (a + s) (b + s) = m s^2. O(n log n) for any points; the result
/// is equal for any number of threads.
/// @param points  [P] those that are not finite get 0
/// @return        [P] in units of the points, >= 0; 0 for points that all lie in one place
/// @throws Error bad_file: over the memory limit; failed: cancelled
std::vector<float> point_spacing(std::span<const vec3> points, Context& context);

/// The middle one of those that are more than 0; 0 where there are none.
float median_spacing(std::span<const float> spacing);

}  // namespace rakelight::geometry
