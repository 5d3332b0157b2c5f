// SPDX-License-Identifier: Apache-2.0
// The properties of materials, lights and cameras that clips can animate.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

#include <rakelight/base/export.h>
#include <rakelight/scene/scene.h>

namespace rakelight {

/// A property of materials, lights or cameras that can be animated.
struct AnimatedProperty {
    AnimationPath path;
    std::string_view name;  ///< AnimationChannel::property
    std::uint32_t width;    ///< numbers per key: 1..4
};
/// All properties that can be animated.
RL_API std::span<const AnimatedProperty> animated_properties();
/// The property of that name, or null.
RL_API const AnimatedProperty* animated_property(AnimationPath path, std::string_view name);

}  // namespace rakelight
