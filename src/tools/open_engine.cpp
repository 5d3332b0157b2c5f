// SPDX-License-Identifier: Apache-2.0
#include "tools/open_engine.h"

#include <rakelight/render/session.h>

#include "engines/check_settings.h"
#include "engines/shader_text.h"
#include "render/prepared_scene.h"
#include "render/shot.h"

namespace rakelight {
namespace {

void require_surfaces(const RenderSettings& settings) {
    if (settings.edges || settings.points != PointShape::none || !settings.surfaces)
        throw Error(ErrorCode::usage,
                    "only surfaces can be explained or shown in stages: leave out 'edges', 'wireframe', 'points' and "
                    "'point-sprites'")
            .naming({"edges", "wireframe", "points", "point-sprites"});
}

/// Engine gl for what soft leaves out, whichever the request names.
void open_shaders(const Scene& drawn, const Shot& shot, const PictureRequest& request, Context& context,
                  std::unique_ptr<ShaderTerms>* shaders) {
    if (!has_shaders(request.settings)) return;
    if (!shaders)
        return context.report().add(Remark::warning, request.input, {},
                                    "shaders from GLSL files are left out: what is shown is the built-in lighting");
    *shaders = std::make_unique<ShaderTerms>(drawn, shot.camera, shot.settings, context);
}

void warn_of_overlays(const PictureRequest& request, Context& context) {
    if (request.has_overlays())
        context.report().add(Remark::warning, request.input, {},
                             "grid, axes, texts and bar are drawn over finished pictures: they are left out here",
                             {"grid", "axis", "filename", "metadata", "bar"});
}

struct Decided {
    Scene drawn;  ///< as the engine gets it
    Shot shot;
};

Decided decided(Scene loaded, PictureRequest& request, Context& context) {
    if (request.motion.time_s) request.settings.shader_time_s = *request.motion.time_s;
    Session session("soft");
    Shot shot = decide_single(session, std::move(loaded), request, {}, {}, context);
    return {drawn_scene(*session.prepared_for(shot, context), shot, context), std::move(shot)};
}

}  // namespace

Scene load_for_engine(const PictureRequest& request, Context& context) {
    require_surfaces(request.settings);
    return load(request.input, request.load, context);
}

std::unique_ptr<const raster::Inspection> open_engine(Scene loaded, PictureRequest& request, Context& context,
                                                      std::unique_ptr<ShaderTerms>* shaders) {
    require_surfaces(request.settings);
    check_settings(request.settings);
    warn_of_overlays(request, context);
    context.progress("prepare", 0);
    const auto [drawn, shot] = decided(std::move(loaded), request, context);
    request.settings = shot.settings;
    open_shaders(drawn, shot, request, context, shaders);
    return std::make_unique<const raster::Inspection>(drawn, shot.camera, shot.settings, context);
}

}  // namespace rakelight
