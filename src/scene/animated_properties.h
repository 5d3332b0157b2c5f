// SPDX-License-Identifier: Apache-2.0
// The numbers of materials, lights and cameras that channels move, one row each: <rakelight/motion.h> shows the rows.
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include <rakelight/motion.h>

namespace rakelight {

/// Puts the numbers of one moment in place. @param values  [width] finite; what lies outside of the number's range is
/// brought to its nearest end. settle() comes after
void set_property(Scene& scene, const AnimatedProperty& property, std::uint32_t element, std::span<const float> values);

/// Numbers that are right only beside one another, when all of a moment are in place: where the near plane would lie beyond the
/// far one both are as before; a cone of full light ends with the light's.
void settle(Camera& camera, const Camera& before);
void settle(Light& light);

}  // namespace rakelight
