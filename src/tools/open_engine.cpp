// SPDX-License-Identifier: Apache-2.0
#include "tools/open_engine.h"

#include <rakelight/picture_parts.h>

#include "engines/check_settings.h"
#include "render/picture_steps.h"

namespace rakelight {
namespace {

void require_surfaces(const RenderSettings& settings) {
    if (settings.edges || settings.points != PointShape::none || !settings.surfaces)
        throw Error(ErrorCode::usage,
                    "only surfaces can be looked into: leave 'edges', 'wireframe', 'points' and 'point-sprites' out")
            .naming({"edges", "wireframe", "points", "point-sprites"});
}

}  // namespace

Scene load_for_engine(const PictureRequest& request, Context& context) {
    require_surfaces(request.settings);
    context.progress("load", 0);
    return scene_of_request(request, context);
}

Scene asked_for_engine(const Scene& scene, const PictureRequest& request, Context& context) {
    require_surfaces(request.settings);
    check_settings(request.settings);
    return with_asked_surfaces(scene, request, context);
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
