// SPDX-License-Identifier: Apache-2.0
#include "studio.h"

#include <rakelight/picture_parts.h>

#include "materials.h"

namespace rakelight::viewer {
namespace {

/// Then the default rig follows the camera by itself.
bool leaves_lights_to_the_session(const PictureRequest& r, const Scene& scene) {
    return !r.lights && !r.default_lights && !r.studio_lights && r.light_intensity == 1 && r.light_cutoff == 0 &&
           scene.lights.empty();
}

}  // namespace

bool Studio::is_taken_up(const std::shared_ptr<const Model>& model, const Look& look,
                         const PictureRequest& request) const {
    return is_set_ && engine_ == request.engine && model_ == model && look_ && have_same_surfaces(*look_, look) &&
           prepare_ == request.prepare;
}

void Studio::take_up(const std::shared_ptr<const Model>& model, const Look& look, const PictureRequest& request,
                     const Camera& camera, Context& context) {
    if (!session_ || engine_ != request.engine) {
        is_set_ = false;
        session_.emplace(request.engine);
        engine_ = request.engine;
    }
    if (model_ != model || !look_ || !have_same_surfaces(*look_, look)) {
        is_set_ = false;
        look_.reset();
        scene_ = with_asked_surfaces(with_edits(model->scene, look.materials, context), request, context);
        model_ = model;
        look_ = look;
    }
    std::vector<Light> lights =
        leaves_lights_to_the_session(request, scene_) ? std::vector<Light>() : asked_lights(scene_, request, camera);
    const Fog fog = request.fog.value_or(scene_.fog);
    if (is_set_ && lights == lights_ && fog == fog_ && prepare_ == request.prepare) return;
    Scene lit = scene_;
    lit.lights = lights;
    lit.fog = fog;
    is_set_ = false;
    session_->set(std::move(lit), request.prepare);
    lights_ = std::move(lights), fog_ = fog, prepare_ = request.prepare;
    is_set_ = true;
}

const std::shared_ptr<const PreparedScene>& Studio::prepare(const std::shared_ptr<const Model>& model, const Look& look,
                                                            const PictureRequest& request, const Camera& camera,
                                                            Context& context) {
    context.progress(is_taken_up(model, look, request) ? "render" : "prepare", 0);
    take_up(model, look, request, camera, context);
    prepared_ = session_->prepared(request.settings, context);
    return prepared_;
}

RenderStats Studio::draw(const std::shared_ptr<const Model>& model, const Look& look, PictureRequest request,
                         const Camera& camera, std::uint32_t wished, Sink& sink, Context& context) {
    context.progress(is_taken_up(model, look, request) ? "render" : "prepare", 0);
    take_up(model, look, request, camera, context);
    request.settings.channels |= wished & session_->engine().abilities().channels;
    prepared_ = session_->prepared(request.settings, context);
    return session_->render(camera, request.settings, sink, context);  // which takes the scene up where it is new
}

}  // namespace rakelight::viewer
