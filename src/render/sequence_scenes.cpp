// SPDX-License-Identifier: Apache-2.0
#include "render/sequence_scenes.h"

#include <utility>

namespace rakelight {

void SequenceScenes::show(Scene scene, const PrepareOptions& options, const RenderSettings& settings,
                          Context& context) {
    const bool is_alike = ready_ && are_prepared_alike(scene, known_);
    const bool is_still = is_alike && scene.pose == known_.pose;
    if (is_still) {  // only lights and cameras: the session notices their changes itself
        take_surroundings(*ready_, scene);
    } else if (is_alike && ready_->bound) {
        ready_ = make_posed(*ready_, scene.pose, context);
        take_surroundings(*ready_, scene);
    } else {
        ready_ = make_prepared(scene, options, settings, context);
    }
    ready_->has_chosen_lights = true;
    known_ = std::move(scene);
    if (!is_still) session_.set(ready_);
}

}  // namespace rakelight
