// SPDX-License-Identifier: Apache-2.0
#include "world/scene_of_request.h"

#include <utility>

#include "world/coloring.h"
#include "world/keys/fixed_function.h"

namespace rakelight {

Scene with_requested_surfaces(Scene scene, const PictureRequest& request, Context& context) {
    if (!(request.materials == MaterialOverrides{}))
        scene = valid::override_materials(std::move(scene), request.materials, context);
    if (request.coloring.is_on)
        scene = color_by_array(std::move(scene), request.coloring, context);
    else
        note_arrays(scene, context.report());
    return with_preset(with_environment(std::move(scene), request, context), request);
}

}  // namespace rakelight
