// SPDX-License-Identifier: Apache-2.0
#include <rakelight/render/shot.h>

#include <rakelight/render/picture.h>
#include <rakelight/render/session.h>

#include "engines/empty_pixel.h"
#include "image/tone_curves.h"
#include "render/asked_scenes.h"
#include "render/camera/camera_chooser.h"
#include "render/check_request.h"
#include "render/look.h"
#include "render/picture_lights.h"
#include "render/prepared_scene.h"
#include "render/shot.h"
#include "world/coloring.h"

namespace rakelight {
namespace {

/// With an exposure or a tone curve, the background must be composited after tone mapping, so that it keeps its display
/// color. The settings then render without it.
/// @return the background to composite
vec4 separate_background(RenderSettings& settings, const ToneSettings& tone) {
    const bool changes_colors = tone.mapping != ToneMapping::none || tone.exposure_ev != 0;
    if (!changes_colors || !(settings.background.w > 0)) return {};
    settings.composites_background = false;
    settings.background_light = ToneCurve(tone).light_for(settings.background.xyz());
    return laid_behind(settings);
}

void take_settings(Shot& shot, const PictureRequest& request, const ShotOptions& options) {
    shot.settings = request.settings;
    shot.behind = options.is_linear ? vec4{} : separate_background(shot.settings, request.tone);
}

}  // namespace

Shot plan_shot(const Scene& shown, const PictureRequest& request, const Camera& camera, const ShotOptions& options,
               Context& context) {
    Shot shot{.camera = camera, .lights = lights_of_shot(shown, request, camera, options.is_view, context.report())};
    take_settings(shot, request, options);
    return shot;
}

void adjust_shot(Session& session, Shot& shot, PictureRequest& request, const ShotOptions& options, Context& context) {
    adjust_to_picture(request, session, shot, context);
    take_settings(shot, request, options);
}

Shot decide_shown(Session& session, const Scene& shown, PictureRequest& request, const CameraOf& camera,
                  const ShotOptions& options, Context& context) {
    warn_of_unused(request, context.report());
    warn_of_unused_normals(shown, request, context.report());
    warn_of_unknown_names(shown, request.settings, context.report());
    const Camera chosen = camera ? camera(shown)
                                 : valid::choose_camera(shown, request.view, aspect_of(request.settings),
                                                        request.settings.visibility, context);
    Shot shot = plan_shot(shown, request, chosen, options, context);
    if (!options.without_adjusting) adjust_shot(session, shot, request, options, context);
    return shot;
}

Shot decide(Session& session, const std::shared_ptr<const Scene>& loaded, PictureRequest& request,
            std::span<const ClipTime> first, const CameraOf& camera, const ShotOptions& options, Context& context) {
    if (!loaded) throw Error(ErrorCode::usage, "there is no scene to draw");
    const auto choose = [&](const Scene& moment) {
        apply_look(moment, request, context);
        request.coloring = completed(moment, request.coloring);
    };
    if (first.empty())
        choose(*loaded);
    else
        choose(at_moment(*loaded, first, context));
    return decide_shown(session, session.show(loaded, request, first, context), request, camera, options, context);
}

namespace {

/// @param request  gets the choices of its coloring
const Scene& show_single(Session& session, Scene moment, PictureRequest& request, const PrepareOptions& prepare,
                         const ChangeScene& change, Context& context) {
    Scene scene = asked_single(std::move(moment), request, context);
    return session.set_single(change ? change(std::move(scene)) : std::move(scene), prepare);
}

}  // namespace

Shot decide_single(Session& session, Scene loaded, PictureRequest& request, const ChangeScene& change,
                   const ShotOptions& options, Context& context) {
    const std::vector<ClipTime> clips = clips_of(loaded, request.motion);
    Scene scene = at_moment(std::move(loaded), clips, context);
    apply_look(scene, request, context);
    return decide_shown(session, show_single(session, std::move(scene), request, request.prepare, change, context),
                        request, {}, options, context);
}

Shot decide_moment(Session& session, Scene moment, PictureRequest asked, PictureRequest& request,
                   const ShotOptions& options, Context& context) {
    return decide_shown(session, show_single(session, std::move(moment), asked, request.prepare, {}, context), request,
                        {}, options, context);
}

}  // namespace rakelight
