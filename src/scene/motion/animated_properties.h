// SPDX-License-Identifier: Apache-2.0
// Setters of the animated properties of materials, lights and cameras; <rakelight/scene/motion.h> lists them.
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include <rakelight/scene/animated_properties.h>
#include <rakelight/scene/motion.h>

namespace rakelight {

/// Sets a property. Call settle() afterwards.
/// @param values [width] finite; clamped to the range of the property
void set_property(Scene& scene, const AnimatedProperty& property, std::uint32_t element, std::span<const float> values);

/// Enforces constraints between properties after all are set: if near would exceed far, both are restored; the inner
/// cone is clamped to the outer cone.
void settle(Camera& camera, const Camera& before);
void settle(Light& light);

}  // namespace rakelight
