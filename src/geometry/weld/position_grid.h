// SPDX-License-Identifier: Apache-2.0
// How far the positions of a file are rounded: to steps of quantization, decimals, binary digits, or floats.
#pragma once
#include <vector>

#include "geometry/input/attribute_input.h"

namespace rakelight::geometry {

/// [meshes] [m] world space: the largest rounding error of a coordinate, half a step. A grid of decimals or binary
/// digits counts if all coordinates lie on it, it is coarser than floats, and enough different coordinates use its last
/// digit, as measured or computed numbers do. It is sought for all meshes together, else for each mesh alone.
std::vector<double> position_rounding(const AttributeInput& input, Context& context);

}  // namespace rakelight::geometry
