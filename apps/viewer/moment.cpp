// SPDX-License-Identifier: Apache-2.0
#include "moment.h"

#include <utility>

namespace rakelight::viewer {

Scene scene_at_moment(Scene still, const std::vector<Animation>& animations, std::vector<ClipTime> clips) {
    for (ClipTime& clip : clips) {
        still.animations.push_back(animations[clip.animation]);
        clip.animation = std::uint32_t(still.animations.size() - 1);
    }
    return scene_at(std::move(still), clips);
}

}  // namespace rakelight::viewer
