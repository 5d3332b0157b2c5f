// SPDX-License-Identifier: Apache-2.0
#include <rakelight/picture_parts.h>

#include <rakelight/validate.h>

#include "render/asked_scenes.h"
#include "render/look.h"
#include "render/picture_lights.h"
#include "world/coloring.h"

namespace rakelight {

Scene with_requested_look(Scene scene, PictureRequest& request, Context& context) {
    validate(scene);
    const std::vector<ClipTime> clips = clips_of(scene, request.motion);
    scene = at_moment(std::move(scene), clips, context);
    apply_look(scene, request, context);
    request.coloring = completed(scene, request.coloring);
    return valid::as_requested(std::move(scene), request, context);
}

void apply_look_exposure(Session& session, const Shot& shot, PictureRequest& request, Context& context) {
    adjust_to_picture(request, session, {shot.camera, request.settings, shot.lights}, context);
}

void apply_look_exposure(const Scene& requested, PictureRequest& request, Context& context) {
    if (request.look == Look::plain) return;
    PictureRequest drawn = request;
    if (drawn.settings.method == RayMethod::radiosity) drawn.settings.method = RayMethod::automatic;
    Session session("soft");
    session.set(requested, drawn.prepare);
    const double aspect = double(drawn.settings.width) / double(drawn.settings.height);
    const Camera camera = choose_camera(requested, drawn.view, aspect, drawn.settings.visibility, context);
    adjust_to_picture(request, session, plan_shot(requested, drawn, camera, {}, context), context);
}

vec4 separate_background(RenderSettings& settings, const ToneSettings& tone) {
    PictureRequest request;
    request.settings = settings, request.tone = tone, request.lights.emplace();
    Context quiet({.threads = 1});
    const Shot shot = plan_shot({}, request, {}, {}, quiet);
    settings = shot.settings;
    return shot.behind;
}

std::optional<std::vector<Light>> shot_lights(const Scene& scene, const PictureRequest& request, const Camera& camera) {
    Report told_elsewhere;
    return lights_of_shot(scene, request, camera, true, told_elsewhere);
}

}  // namespace rakelight
