// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rakelight/picture.h>

namespace rakelight {

/// What the scales of PNG channels span for a scene seen by a camera that choose_camera() gave.
ChannelRange channel_range(const Scene& scene, const Camera& camera);

}  // namespace rakelight
