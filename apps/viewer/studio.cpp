// SPDX-License-Identifier: Apache-2.0
#include "studio.h"

#include <algorithm>

#include <rakelight/picture_parts.h>

#include "materials.h"
#include "moment.h"

namespace rakelight::viewer {
namespace {

/// Then the default rig follows the camera by itself.
bool leaves_lights_to_the_session(const PictureRequest& r, const Scene& scene) {
    return !r.lights && !r.default_lights && !r.studio_lights && r.light_intensity == 1 && r.light_cutoff == 0 &&
           scene.lights.empty();
}

/// Material settings of the request override clips, so they are applied again at each moment.
bool moves_overridden_materials(const Scene& scene, std::span<const ClipTime> clips, const PictureRequest& request) {
    if (request.materials == MaterialOverrides{} && !request.coloring.is_on) return false;
    return std::ranges::any_of(clips, [&](const ClipTime& clip) {
        return std::ranges::any_of(scene.animations[clip.animation].channels, [](const AnimationChannel& channel) {
            return channel.path == AnimationPath::material;
        });
    });
}

}  // namespace

bool Studio::is_taken_up(const std::shared_ptr<const Model>& model, const Look& look,
                         const PictureRequest& request) const {
    return is_set_ && engine_ == request.engine && model_ == model && look_ && have_same_surfaces(*look_, look) &&
           prepare_ == request.prepare;
}

void Studio::warm_up(const std::shared_ptr<const Model>& model, const Look& look, const PictureRequest& request,
                     const Camera& camera, Context& context) {
    if (!session_ || engine_ != request.engine) {
        is_set_ = false;
        session_.emplace(request.engine);
        engine_ = request.engine;
    }
    std::vector<ClipTime> clips = clips_of(model->scene, request.motion), surface_clips;
    if (moves_overridden_materials(model->scene, clips, request)) surface_clips = clips;
    if (model_ != model || !look_ || !have_same_surfaces(*look_, look) || surface_clips_ != surface_clips) {
        is_set_ = false;
        look_.reset();
        scene_ = scene_at(with_edits(model->scene, look.materials, context), surface_clips);
        scene_ = with_requested_surfaces(std::move(scene_), request, context);
        scene_.animations.clear();
        model_ = model;
        look_ = look;
        surface_clips_ = surface_clips;
    }
    const auto& animations = model->scene.animations;
    Scene lit = scene_at_moment(scene_, animations, surface_clips.empty() ? clips : std::vector<ClipTime>());
    if (!animations.empty())
        lit.animations = {Animation{}};  // one for all: by it a scene is known as one that can move
    if (leaves_lights_to_the_session(request, lit))
        lit.lights.clear();
    else
        lit.lights = requested_lights(lit, request, camera);
    lit.fog = request.fog.value_or(lit.fog);
    if (is_set_ && lit.lights == lights_ && lit.fog == fog_ && clips == clips_ && prepare_ == request.prepare) return;
    is_set_ = false;
    lights_ = lit.lights, fog_ = lit.fog, clips_ = std::move(clips), prepare_ = request.prepare;
    session_->set(std::move(lit), request.prepare);
    is_set_ = true;
}

const std::shared_ptr<const PreparedScene>& Studio::prepare(const std::shared_ptr<const Model>& model, const Look& look,
                                                            const PictureRequest& request, const Camera& camera,
                                                            Context& context) {
    context.progress(is_taken_up(model, look, request) ? "render" : "prepare", 0);
    warm_up(model, look, request, camera, context);
    prepared_ = session_->prepared(request.settings, context);
    return prepared_;
}

RenderStats Studio::draw(const std::shared_ptr<const Model>& model, const Look& look, PictureRequest request,
                         const Camera& camera, std::uint32_t wished, Sink& sink, Context& context) {
    context.progress(is_taken_up(model, look, request) ? "render" : "prepare", 0);
    warm_up(model, look, request, camera, context);
    request.settings.channels |= wished & session_->engine().capabilities().channels;
    prepared_ = session_->prepared(request.settings, context);
    return session_->render(camera, request.settings, sink, context);  // which takes the scene up where it is new
}

}  // namespace rakelight::viewer
