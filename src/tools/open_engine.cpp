// SPDX-License-Identifier: Apache-2.0
#include "tools/open_engine.h"

#include <rakelight/session.h>
#include <rakelight/validate.h>

#include "engines/check_settings.h"
#include "engines/shader_text.h"
#include "render/look.h"
#include "render/picture_steps.h"

namespace rakelight {
namespace {

void require_surfaces(const RenderSettings& settings) {
    if (settings.edges || settings.points != PointShape::none || !settings.surfaces)
        throw Error(ErrorCode::usage,
                    "only surfaces can be explained or shown in stages: leave out 'edges', 'wireframe', 'points' and "
                    "'point-sprites'")
            .naming({"edges", "wireframe", "points", "point-sprites"});
}

}  // namespace

Scene load_for_engine(PictureRequest& request, Context& context) {
    require_surfaces(request.settings);
    return loaded_as_asked(request, context);
}

Scene asked_for_engine(const Scene& scene, PictureRequest& request, Context& context) {
    require_surfaces(request.settings);
    check_settings(request.settings);
    validate(scene);
    return looked_as_asked(scene, request, context);
}

namespace {

/// Engine gl for what soft leaves out, whichever the request names.
void open_shaders(const ReadyScene& ready, PictureRequest& request, Context& context,
                  std::unique_ptr<ShaderTerms>* shaders) {
    if (!has_shaders(request.settings)) return;
    if (!shaders)
        return context.report().add(Remark::warning, request.input, {},
                                    "shaders from GLSL files are left out: what is shown is the built-in lighting");
    if (request.motion.time_s) request.settings.shader_time_s = *request.motion.time_s;
    *shaders = std::make_unique<ShaderTerms>(scene_of(*ready.prepared), ready.camera, request.settings, context);
}

}  // namespace

std::unique_ptr<const raster::Inspection> open_engine(Scene loaded, PictureRequest& request, Context& context,
                                                      std::unique_ptr<ShaderTerms>* shaders) {
    context.progress("prepare", 0);
    const ReadyScene ready = ready_scene(std::move(loaded), request, context);
    if (request.look != Look::plain) {
        Session session("soft");
        session.set(ready.prepared);
        adjust_to_picture(request, session, ready.shot(), context);
    }
    separate_background(request.settings, request.tone);
    open_shaders(ready, request, context, shaders);
    return std::make_unique<const raster::Inspection>(scene_of(*ready.prepared), ready.camera, request.settings,
                                                      context);
}

std::unique_ptr<const raster::Inspection> open_engine(PictureRequest& request, Context& context,
                                                      std::unique_ptr<ShaderTerms>* shaders) {
    Scene loaded = load_for_engine(request, context);
    return open_engine(std::move(loaded), request, context, shaders);
}

}  // namespace rakelight
