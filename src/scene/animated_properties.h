// SPDX-License-Identifier: Apache-2.0
// The numbers of materials, lights and cameras that channels move, one row each: <rakelight/motion.h> shows the rows.
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include <rakelight/motion.h>

namespace rakelight {

/// Puts the numbers of one moment in place. @param values  [width] finite; what lies outside of the number's range is
/// brought to its nearest end
void set_property(Scene& scene, const AnimatedProperty& property, std::uint32_t element, std::span<const float> values);

}  // namespace rakelight
