// SPDX-License-Identifier: Apache-2.0
// Lights in the picture: how the pointer moves them.
#include <cmath>

#include "app.h"
#include "view/overlay.h"

namespace rakelight::viewer {

GizmoView App::gizmo_view(const View& view) const {
    return {view.camera, view.area.width, view.area.height, double(window_->scale()), model_->box.bounds()};
}

/// The selected light; none: there is no such, or lights are not displayed.
std::optional<Light> App::selected_light(const View& view) const {
    if (!ui_.light_glyphs || !model_ || !view.displayed) return {};
    Look lit = view.look;
    const std::vector<LightItem>& lights = changing_lights(lit, *model_, view.area.width, view.area.height);
    return ui_.light < lights.size() ? std::optional(lights[ui_.light].light) : std::nullopt;
}

/// Whether a light that is displayed, or a handle of the selected one, is under the pointer: that light is selected then.
bool App::take_light(double x, double y) {
    View& view = active();
    if (!ui_.light_glyphs || !model_ || !view.displayed) return false;
    const dvec2 pixel{x - view.area.x, y - view.area.y};
    Look lit = view.look;
    const std::vector<LightItem>& lights = changing_lights(lit, *model_, view.area.width, view.area.height);
    if (ui_.light < lights.size()) {
        const Handle handle = handle_at(pixel, lights[ui_.light].light, gizmo_view(view));
        if (handle != Handle::none) return light_drag_ = {handle, lights[ui_.light].light, pixel}, true;
    }
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const std::optional<dvec3> place = place_of(lights[i].light, model_->box.bounds());
        const std::optional<dvec2> p =
            place ? pixel_of(*place, view.camera, view.area.width, view.area.height) : std::nullopt;
        if (!p || std::hypot(p->x - pixel.x, p->y - pixel.y) > 14 * double(window_->scale())) continue;
        ui_.light = i;
        const bool is_turned = lights[i].light.type == LightType::directional;
        light_drag_ = {is_turned ? Handle::tip : Handle::center, lights[i].light, pixel};
        return true;
    }
    return false;
}

void App::move_light(double x, double y) {
    View& view = active();
    std::vector<LightItem>& lights = changing_lights(view.look, *model_, view.area.width, view.area.height);
    if (ui_.light >= lights.size()) return;
    const dvec2 pixel{x - view.area.x, y - view.area.y};
    const Light moved = dragged(light_drag_.start, light_drag_.handle, light_drag_.from, pixel, gizmo_view(view));
    lights[ui_.light].light.position = moved.position;
    lights[ui_.light].light.direction = moved.direction;
}

/// The handle that a press would take, to be highlighted.
void App::hover_light(double x, double y, bool is_over_panel) {
    const View& view = active();
    const std::optional<Light> light = is_over_panel ? std::nullopt : selected_light(view);
    hovered_ = light ? handle_at({x - view.area.x, y - view.area.y}, *light, gizmo_view(view)) : Handle::none;
}

void App::follow_camera() {
    if (!model_) return;
    View& view = active();
    std::vector<LightItem>& lights = changing_lights(view.look, *model_, view.area.width, view.area.height);
    if (ui_.light >= lights.size()) return ui_.say("there is no light that could follow the camera");
    LightItem& item = lights[ui_.light];
    item.follows_camera = !item.follows_camera;
    const std::string name =
        item.light.name.empty() ? "light " + std::to_string(ui_.light) : one_line(item.light.name, 40);
    ui_.say(name + (item.follows_camera ? " follows the camera" : " stays where it is"));
}

}  // namespace rakelight::viewer
