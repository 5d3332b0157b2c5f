// SPDX-License-Identifier: Apache-2.0
#include "tools/open_engine.h"

#include "render/drawable.h"
#include "render/height_maps.h"
#include "render/picture_steps.h"

namespace rakelight {

std::unique_ptr<const raster::Inspection> open_engine(const PictureRequest& request, Context& context) {
    const RenderSettings& settings = request.settings;
    if (settings.edges || settings.points != PointShape::none || !settings.surfaces)
        throw Error(ErrorCode::usage,
                    "only surfaces can be looked into: leave --edges, --wireframe, --points and --point-sprites out");
    context.progress("load", 0);
    Scene scene = load(request.input, request.load, context);
    scene = override_materials(scene, request.materials, context);
    scene = with_height_maps(std::move(scene), request.settings, context);
    scene = with_environment(std::move(scene), request, context);
    context.progress("prepare", 0);
    check_drawable(scene);
    warn_of_unknown_names(scene, settings, context.report());
    const double aspect = double(settings.width) / double(settings.height);
    const Camera camera = choose_camera(scene, request.view, aspect, context);
    scene = prepare_scene(with_lights(std::move(scene), request, camera), prepare_options(request), context);
    return std::make_unique<const raster::Inspection>(scene, camera, settings, context);
}

}  // namespace rakelight
