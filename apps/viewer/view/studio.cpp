// SPDX-License-Identifier: Apache-2.0
#include "studio.h"

#include <rakelight/render/shot.h>

#include "../document/materials.h"

namespace rakelight::viewer {

Shot Studio::plan(const std::shared_ptr<const Model>& model, const Look& look, const PictureRequest& request,
                  const Camera& camera, Context& context) {
    const bool is_new_engine = !session_ || engine_ != request.engine;
    const bool is_new_model = model_ != model || edits_ != look.materials;
    context.progress(is_new_engine || is_new_model || prepare_ != request.prepare ? "prepare" : "render", 0);
    if (is_new_engine) session_.emplace(request.engine);
    engine_ = request.engine, prepare_ = request.prepare;
    if (is_new_model) {
        edited_ = std::make_shared<const Scene>(with_edits(model->scene, look.materials, context));
        model_ = model, edits_ = look.materials;
    }
    const Scene& scene = session_->show(edited_, request, clips_of(model->scene, request.motion), context);
    return plan_shot(scene, request, camera, {.is_view = true}, context);
}

void Studio::prepare(const Shot& shot, Context& context) { prepared_ = session_->prepared_for(shot, context); }

RenderStats Studio::draw(Shot shot, std::uint32_t wished, Sink& sink, Context& context) {
    shot.settings.channels |= wished & session_->engine().capabilities().channels;
    prepare(shot, context);
    return session_->render(shot, sink, context);  // which takes the scene up where it is new
}

}  // namespace rakelight::viewer
