// SPDX-License-Identifier: Apache-2.0
// Animations as data: channels of what is in the scene.
#pragma once
#include "io/gltf/accessors.h"
#include "io/gltf/motion/channel_targets.h"

namespace rakelight::io::gltf {

/// Channels whose data is broken, or whose target does not exist or cannot be moved, are left out with a remark; those of what
/// is outside the scene without one.
void read_animations(Accessors& accessors, const ChannelTargets& targets, Scene& scene);

}  // namespace rakelight::io::gltf
