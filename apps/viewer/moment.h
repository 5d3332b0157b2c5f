// SPDX-License-Identifier: Apache-2.0
// A scene at a moment without a copy of all its clips: of a character with a hundred of them that takes as long as its pose.
#pragma once
#include <vector>

#include <rakelight/motion.h>

namespace rakelight::viewer {

/// scene_at() with the clips that are shown alone, which stay in the result.
/// @param still  without its clips @param animations  which are these
Scene scene_at_moment(Scene still, const std::vector<Animation>& animations, std::vector<ClipTime> clips);

}  // namespace rakelight::viewer
