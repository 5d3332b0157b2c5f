// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "geometry/fast_state.h"

namespace rakelight::geometry {

/// Gives the members of each class their common sums: normals of all; tangents of those members of one handedness whose own
/// tangents lie within 45 degrees of one another (connected pairs). Where float cannot tell what the general path would do
/// (normals that nearly cancel, mirrored charts at one vertex, angles near 45 degrees) the class is left to it: weight -1.
/// @param duplicates  whole classes: all members but one, with that one; sorted here
void join_classes(FastState& state, std::vector<Duplicate>& duplicates);

}  // namespace rakelight::geometry
