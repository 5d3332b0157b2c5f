// SPDX-License-Identifier: Apache-2.0
#include "tools/open_engine.h"

#include "render/picture_steps.h"

namespace rakelight {

Scene load_for_engine(const PictureRequest& request, Context& context) {
    const RenderSettings& settings = request.settings;
    if (settings.edges || settings.points != PointShape::none || !settings.surfaces)
        throw Error(ErrorCode::usage,
                    "only surfaces can be looked into: leave 'edges', 'wireframe', 'points' and 'point-sprites' out")
            .naming({"edges", "wireframe", "points", "point-sprites"});
    context.progress("load", 0);
    return scene_of_request(request, context);
}

std::unique_ptr<const raster::Inspection> open_engine(Scene loaded, const PictureRequest& request, Context& context) {
    context.progress("prepare", 0);
    const ReadyScene ready = ready_scene(std::move(loaded), request, context);
    return std::make_unique<const raster::Inspection>(scene_of(*ready.prepared), ready.camera, request.settings,
                                                      context);
}

std::unique_ptr<const raster::Inspection> open_engine(const PictureRequest& request, Context& context) {
    return open_engine(load_for_engine(request, context), request, context);
}

}  // namespace rakelight
