// SPDX-License-Identifier: Apache-2.0
#include "tools/open_engine.h"

#include "render/picture_steps.h"

namespace rakelight {

std::unique_ptr<const raster::Inspection> open_engine(const PictureRequest& request, Context& context) {
    const RenderSettings& settings = request.settings;
    if (settings.edges || settings.points != PointShape::none || !settings.surfaces)
        throw Error(ErrorCode::usage,
                    "only surfaces can be looked into: leave --edges, --wireframe, --points and --point-sprites out");
    context.progress("load", 0);
    Scene loaded = scene_of_request(request, context);
    context.progress("prepare", 0);
    const auto [scene, camera] = ready_scene(std::move(loaded), request, context);
    return std::make_unique<const raster::Inspection>(scene, camera, settings, context);
}

}  // namespace rakelight
