// SPDX-License-Identifier: Apache-2.0
// Local spacing of the points of a cloud.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/math/vector.h>

namespace rakelight::geometry {

/// For each point the side of a square cell with one point, assuming that its neighbors lie on a surface. Median splits
/// of a k-d tree (Bentley 1975) leave groups of 8 to 16 neighbors. A group of m points in a box with longest sides a
/// and b fills m squares of side s, where (a + s) (b + s) = m s^2. O(n log n) for any points; the result is equal for
/// any number of threads.
/// @param points [P] non-finite points get 0
/// @return [P] in units of the points, >= 0; 0 if all points are at one place
/// @throws Error bad_file: over the memory limit; failed: cancelled
std::vector<float> point_spacing(std::span<const vec3> points, Context& context);

/// The median of positive values; 0 without any.
float median_spacing(std::span<const float> spacing);

}  // namespace rakelight::geometry
