// SPDX-License-Identifier: Apache-2.0
#include "light_handles.h"

#include <cmath>

#include "overlay.h"

namespace rakelight::viewer {
namespace {

constexpr double glyph_px = 14;  // from its middle a press takes a light

dvec2 pixel_in(const PixelBox& area, dvec2 pointer) { return {pointer.x - area.x, pointer.y - area.y}; }

}  // namespace

GizmoView LightHandles::gizmo_view(double scale) const {
    const PictureView& view = pictures_.active();
    return {view.camera(), view.area.width, view.area.height, scale, pictures_.model()->box.bounds()};
}

bool LightHandles::are_displayed() const {
    return ui_.light_glyphs && pictures_.model() && pictures_.active().displayed();
}

std::vector<LightItem> LightHandles::displayed_lights() const {
    const PictureView& view = pictures_.active();
    Look lit = view.look;
    return changing_lights(lit, *pictures_.model(), view.area.width, view.area.height);
}

bool LightHandles::take(dvec2 pointer, double scale) {
    if (!are_displayed()) return false;
    const dvec2 pixel = pixel_in(pictures_.active().area, pointer);
    const std::vector<LightItem> lights = displayed_lights();
    if (ui_.light < lights.size()) {
        const Handle handle = handle_at(pixel, lights[ui_.light].light, gizmo_view(scale));
        if (handle != Handle::none) return drag_ = {handle, lights[ui_.light].light, pixel}, true;
    }
    return take_glyph(lights, pixel, scale);
}

bool LightHandles::take_glyph(const std::vector<LightItem>& lights, dvec2 pixel, double scale) {
    const GizmoView view = gizmo_view(scale);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Light& light = lights[i].light;
        const std::optional<dvec3> place = place_of(light, view.bounds);
        const std::optional<dvec2> p = place ? pixel_of(*place, view.camera, view.width, view.height) : std::nullopt;
        if (!p || std::hypot(p->x - pixel.x, p->y - pixel.y) > glyph_px * scale) continue;
        ui_.light = i;
        drag_ = {light.type == LightType::directional ? Handle::tip : Handle::center, light, pixel};
        return true;
    }
    return false;
}

void LightHandles::move(dvec2 pointer, double scale) {
    PictureView& view = pictures_.active();
    std::vector<LightItem>& lights = changing_lights(view.look, *pictures_.model(), view.area.width, view.area.height);
    if (ui_.light >= lights.size()) return;
    const Light moved = dragged(drag_.start, drag_.handle, drag_.from, pixel_in(view.area, pointer), gizmo_view(scale));
    lights[ui_.light].light.position = moved.position;
    lights[ui_.light].light.direction = moved.direction;
}

void LightHandles::hover(std::optional<dvec2> pointer, double scale) {
    hovered_ = Handle::none;
    if (!pointer || !are_displayed()) return;
    const std::vector<LightItem> lights = displayed_lights();
    if (ui_.light >= lights.size()) return;
    hovered_ = handle_at(pixel_in(pictures_.active().area, *pointer), lights[ui_.light].light, gizmo_view(scale));
}

}  // namespace rakelight::viewer
