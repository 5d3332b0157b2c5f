// SPDX-License-Identifier: Apache-2.0
#include "world/scene_of_request.h"

#include <utility>

#include "engines/check_settings.h"
#include "world/coloring.h"
#include "world/fixed_function.h"

namespace rakelight {

Scene scene_of_request(const PictureRequest& request, Context& context) {
    check_settings(request.settings);
    return as_requested(with_requested_clips(load(request.input, request.load, context), request, context), request,
                        context);
}

Scene with_requested_clips(Scene scene, const PictureRequest& request, Context& context) {
    const std::vector<ClipTime> clips = clips_of(scene, request.motion);
    return scene_at(std::move(scene), clips, context.memory());
}

Scene as_requested(Scene scene, const PictureRequest& request, Context& context) {
    if (!(request.materials == MaterialOverrides{}))
        scene = valid::override_materials(std::move(scene), request.materials, context);
    if (request.coloring.is_on)
        scene = color_by_array(std::move(scene), request.coloring, context);
    else
        note_arrays(scene, context.report());
    return with_preset(with_environment(std::move(scene), request, context), request);
}

}  // namespace rakelight
