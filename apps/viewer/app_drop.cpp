// SPDX-License-Identifier: Apache-2.0
// What is dropped on the window.
#include <filesystem>

#include "app.h"
#include "view/drop.h"

namespace rakelight::viewer {

void App::drop(const Event& event) {
    const DropPlan plan = plan_of_drop(event.files, event.modifiers & mod_shift);
    if (plan.is_empty_folder) return ui_.say("there is no model in this folder");
    if (!plan.models.empty()) return files_.open_dropped(plan.models, event.modifiers & mod_control);
    if (!model_) return ui_.say("drop a model first: pictures are for what is shown");
    activate_at(event.x, event.y);
    if (!plan.environment.empty()) {
        PictureRequest& request = active().look.request;
        request.hdri_file = plan.environment;
        request.hdri_ambient = request.hdri_skybox = true;
    }
    if (!plan.picture.empty()) give_picture(event, plan.picture);
}

/// The object at the pointer gets the picture as the base color texture of its material.
void App::give_picture(const Event& event, const std::string& file) {
    View& view = active();
    if (!view.painter || !view.area.holds(event.x, event.y))
        return ui_.say("drop a picture on an object, which gets it as its texture");
    const int x = int(event.x) - view.area.x, y = int(event.y) - view.area.y;
    view.painter->look_at_pixel(x, y, [this, &view, file, model = model_](std::optional<Painter::Hit> hit) {
        if (model != model_) return;
        if (!hit) return ui_.say("drop a picture on an object, which gets it as its texture");
        try {
            const std::uint32_t material = source_material(model_->scene, view.look.materials, hit->material);
            const MaterialTarget target = ui_.is_object_alone ? target_in_object(model_->scene, material, hit->object)
                                                              : target_of(model_->scene, material, hit->object);
            if (ui_.is_object_alone) ui_.material = material, ui_.object = hit->object;
            set_material(view.look, target, "color_texture=" + file);
            ui_.say("texture of " + title_of(model_->scene, target) + ": " +
                    std::filesystem::path(file).filename().string());
        } catch (const Error& error) {
            ui_.report(error);
        }
    });
}

}  // namespace rakelight::viewer
