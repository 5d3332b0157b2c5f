// SPDX-License-Identifier: Apache-2.0
#include "pick.h"

#include <filesystem>

#include "../document/materials.h"

namespace rakelight::viewer {
namespace {

constexpr const char* no_object_for_texture = "drop a picture on an object, which gets it as its texture";

/// Calls `use` with the picture and what is there, if the model is still shown then.
template <class Use>
void with_hit(int x, int y, Pictures& pictures, Use use) {
    PictureView& view = pictures.active();
    view.look_at_pixel(x, y, [&pictures, &view, use, model = pictures.model()](std::optional<Painter::Hit> hit) {
        if (model == pictures.model()) use(view, hit);
    });
}

/// The object's material gets a picture as its base color texture.
void set_texture_at(int x, int y, const std::string& file, Pictures& pictures, UiState& ui) {
    with_hit(x, y, pictures, [&pictures, &ui, file](PictureView& view, const std::optional<Painter::Hit>& hit) {
        if (!hit) return ui.say(no_object_for_texture);
        const Scene& scene = pictures.model()->scene;
        try {
            const std::uint32_t material = source_material(scene, view.look.materials, hit->material);
            const MaterialTarget target = ui.is_object_alone ? target_in_object(scene, material, hit->object)
                                                             : target_of(scene, material, hit->object);
            if (ui.is_object_alone) ui.material = material, ui.object = hit->object;
            set_material(view.look, target, "color_texture=" + file);
            ui.say("texture of " + title_of(scene, target) + ": " + std::filesystem::path(file).filename().string());
        } catch (const Error& error) {
            ui.report(error);
        }
    });
}

}  // namespace

void select_material_at(int x, int y, Pictures& pictures, UiState& ui) {
    with_hit(x, y, pictures, [&pictures, &ui](const PictureView& view, const std::optional<Painter::Hit>& hit) {
        if (!hit || hit->material == no_index) return ui.say("there is no surface at this pixel");
        ui.material = source_material(pictures.model()->scene, view.look.materials, hit->material);
        ui.object = hit->object;
        ui.open[std::size_t(Panel::materials)] = true, ui.are_panels_hidden = false;
        ui.redraw();
    });
}

void center_at(int x, int y, Pictures& pictures) {
    with_hit(x, y, pictures, [&pictures](PictureView& view, const std::optional<Painter::Hit>& hit) {
        if (!hit) return;
        center_on(moving_eye(view.look, *pictures.model(), view.area.width, view.area.height), hit->position);
    });
}

void use_pictures(const DropPlan& plan, double window_x, double window_y, Pictures& pictures, UiState& ui) {
    pictures.activate_at(window_x, window_y);
    PictureView& view = pictures.active();
    if (!plan.environment.empty()) {
        PictureRequest& request = view.look.request;
        request.hdri_file = plan.environment;
        request.hdri_ambient = request.hdri_skybox = true;
    }
    if (plan.picture.empty()) return;
    if (!view.is_open() || !view.area.holds(window_x, window_y)) return ui.say(no_object_for_texture);
    set_texture_at(int(window_x) - view.area.x, int(window_y) - view.area.y, plan.picture, pictures, ui);
}

}  // namespace rakelight::viewer
