// SPDX-License-Identifier: Apache-2.0
// The list of lights, the environment.
#include <algorithm>

#include <rakelight/math/linear.h>

#include "../document/display_path.h"
#include "panels.h"
#include "widgets.h"

namespace rakelight::viewer {
namespace {

constexpr const char* light_types[] = {"ambient", "directional", "point", "spot"};

void draw_classical(Light& light) {
    edit_light_color("color", light.diffuse);
    edit_light_color("specular", light.specular);
    edit_light_color("ambient", light.ambient);
    if (light.type == LightType::directional) return;
    ImGui::DragFloat3("attenuation", &light.constant, 0.01f, 0, 1e6f, "%.3f", ImGuiSliderFlags_AlwaysClamp);
    if (light.type != LightType::spot) return;
    float cutoff = float(degrees(double(light.cutoff_rad)));
    if (slide("cutoff", cutoff, 0, 90, "%.1f deg")) light.cutoff_rad = float(radians(double(cutoff)));
    slide("exponent", light.exponent, 0, 128);
}

void draw_photometric(Light& light) {
    edit_light_color("color", light.color);
    slide("intensity", light.intensity, 0, 100000, "%.2f", true);
    if (light.type != LightType::spot) return;
    float inner = float(degrees(double(light.inner_cone_rad))), outer = float(degrees(double(light.outer_cone_rad)));
    if (slide("outer cone", outer, 0.1f, 89.9f, "%.1f deg")) light.outer_cone_rad = float(radians(double(outer)));
    if (slide("inner cone", inner, 0, outer - 0.05f, "%.1f deg") || inner >= outer)
        light.inner_cone_rad = float(radians(double(std::clamp(inner, 0.0f, outer - 0.05f))));
}

void draw_light(PanelView& view, LightItem& item) {
    Light& light = item.light;
    int type = int(light.type);
    if (ImGui::Combo("type", &type, light_types, 4)) {
        light.type = LightType(type);
        if (light.type == LightType::ambient) light.units = LightUnits::classical;
    }
    if (light.type == LightType::ambient) {
        edit_light_color("color", light.ambient);
        return;
    }
    constexpr const char* units[] = {"classical", "photometric"};
    int unit = int(light.units);
    if (ImGui::Combo("units", &unit, units, 2)) light.units = LightUnits(unit);
    light.units == LightUnits::classical ? draw_classical(light) : draw_photometric(light);
    const double step = 0.005 * view.model->box.bounds().diagonal();
    if (light.type != LightType::directional) edit_place("position", light.position, step);
    dvec3 direction = light.direction;
    if (light.type != LightType::point && edit_place("direction", direction, 0.01) && !(direction == dvec3{}))
        light.direction = direction;
    ImGui::Checkbox("casts shadows", &light.casts_shadow);
    ImGui::SameLine();
    ImGui::Checkbox("follows the camera", &item.follows_camera);
}

void draw_environment(PanelView& view) {
    PictureRequest& r = view.look.request;
    const auto& own = view.model->scene.environment;
    bool gives_light = r.hdri_ambient.value_or(own && own->is_light),
         is_seen = r.hdri_skybox.value_or(own && own->is_background);
    if (ImGui::Checkbox("environment lighting", &gives_light)) r.hdri_ambient = gives_light;
    if (ImGui::Checkbox("environment as background", &is_seen)) r.hdri_skybox = is_seen;
    float intensity = float(r.hdri_intensity.value_or(1)), turn = float(degrees(r.hdri_rotation_rad.value_or(0)));
    if (slide("intensity", intensity, 0, 10)) r.hdri_intensity = double(intensity);
    if (slide("rotation", turn, -180, 180, "%.1f deg")) r.hdri_rotation_rad = radians(double(turn));
    ImGui::TextDisabled("%s", r.hdri_file.empty() ? "drop a .hdr or .exr file to use it"
                                                  : one_line(display_path(r.hdri_file), 60).c_str());
}

/// Before the model, a little up and to the right, where it can be seen and dragged.
dvec3 place_in_view(const PanelView& view) {
    const Bounds& bounds = view.model->box.bounds();
    if (!view.painting) return bounds.high;
    const dmat4& m = view.painting->camera.to_world;
    const double to_center = -dot(bounds.center() - m[3].xyz(), m[2].xyz());
    const double away = 0.6 * std::max(to_center, 0.2 * bounds.diagonal());
    return m[3].xyz() - m[2].xyz() * away + (m[0].xyz() + m[1].xyz()) * (0.2 * away);
}

Light new_light(const PanelView& view) {
    Light light;
    light.position = place_in_view(view);
    light.diffuse = light.specular = {0.6f, 0.6f, 0.6f};
    return light;
}

}  // namespace

void draw_lights_panel(PanelView& view) {
    Look changed = view.look;  // looking at the list does not change it
    std::vector<LightItem>& lights = changing_lights(changed, *view.model, view.width, view.height);
    const std::vector<LightItem> before = lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        ImGui::PushID(int(i));
        ImGui::Checkbox("##on", &lights[i].is_on);
        ImGui::SameLine();
        const std::string& name = lights[i].light.name;
        const std::string title = std::string(light_types[std::size_t(lights[i].light.type)]) +
                                  (name.empty() ? "" : " " + one_line(name, 40));
        if (ImGui::Selectable(title.c_str(), view.ui.light == i)) view.ui.light = i;
        ImGui::PopID();
    }
    if (ImGui::Button("add")) lights.push_back({.light = new_light(view)}), view.ui.light = lights.size() - 1;
    if (view.ui.light < lights.size()) {
        ImGui::SameLine();
        const bool is_removed = ImGui::Button("remove");
        ImGui::PushID("light");
        draw_light(view, lights[view.ui.light]);
        ImGui::PopID();
        if (is_removed) lights.erase(lights.begin() + std::ptrdiff_t(view.ui.light)), view.ui.light = 0;
    }
    if (lights != before) view.look.lights = lights;
    if (view.look.lights && ImGui::Button("reset lights")) view.look.lights.reset();
    double intensity = view.look.request.light_intensity;
    if (slide("factor on all lights", intensity, 0, 10)) view.look.request.light_intensity = intensity;
    if (ImGui::Checkbox("shadows", &view.look.request.settings.shadows)) view.look.shadows_by_nature = false;
    ImGui::SameLine();
    ImGui::Checkbox("show lights", &view.ui.light_glyphs);
    draw_environment(view);
}

}  // namespace rakelight::viewer
