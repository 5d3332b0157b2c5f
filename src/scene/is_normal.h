// SPDX-License-Identifier: Apache-2.0
// What counts as the normal of a vertex.
#pragma once
#include "math/linear.h"

namespace rakelight {

/// Finite and not zero.
inline bool is_normal(vec3 v) { return is_finite(v) && !(v == vec3{}); }

}  // namespace rakelight
