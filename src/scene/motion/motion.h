// SPDX-License-Identifier: Apache-2.0
// What scene_at() is made of.
#pragma once
#include <span>

#include <rakelight/scene/motion.h>

namespace rakelight {

/// @throws Error usage: no such clip, a time that is no number
void check_clips(const Scene& scene, std::span<const ClipTime> clips);

/// As the nodes stand by themselves.
ScenePose rest_pose(const Scene& scene);

}  // namespace rakelight
