// SPDX-License-Identifier: Apache-2.0
// Values of materials, by the keys of [[material]].
#include <imgui.h>
// clang-format off: it stands on the line above
#include <imgui_stdlib.h>
// clang-format on

#include <cstdio>

#include "panels.h"
#include "widgets.h"

namespace rakelight::viewer {
namespace {

/// Numbers of a key: edited ones, else the file's.
void value_of(const PanelView& view, const std::string& name, const char* key, float* values, std::size_t count) {
    for (const MaterialEdit& edit : view.look.materials)
        if (edit.name == name)
            for (const WorldValue& value : edit.values)
                for (std::size_t i = 0; value.key == key && i < std::min(count, value.numbers.size()); ++i)
                    values[i] = float(value.numbers[i]);
}

void set(PanelView& view, const std::string& name, const std::string& key_and_value) try {
    set_material(view.look, name, key_and_value);
} catch (const Error& error) {
    view.ui.message = error.what(), view.ui.is_message_error = true;
}

void draw_number(PanelView& view, const std::string& name, const char* key, float value, float low, float high) {
    value_of(view, name, key, &value, 1);
    if (!slide(key, value, low, high)) return;
    char text[80];
    std::snprintf(text, sizeof text, "%s=%.9g", key, double(value));
    set(view, name, text);
}

void draw_color(PanelView& view, const std::string& name, const char* key, vec3 value) {
    value_of(view, name, key, &value.x, 3);
    if (!edit_light_color(key, value)) return;
    char text[120];
    std::snprintf(text, sizeof text, "%s=%.9g,%.9g,%.9g", key, double(std::max(0.0f, value.x)),
                  double(std::max(0.0f, value.y)), double(std::max(0.0f, value.z)));
    set(view, name, text);
}

void draw_material(PanelView& view, const Material& m) {
    draw_color(view, m.name, "color", m.base_color.xyz());
    draw_number(view, m.name, "opacity", m.base_color.w, 0, 1);
    if (m.model == MaterialModel::classical) {
        draw_color(view, m.name, "specular", m.classical.specular);
        draw_number(view, m.name, "shininess", m.classical.shininess, 1, 1000);
    } else if (m.model == MaterialModel::metallic_roughness) {
        draw_number(view, m.name, "roughness", m.metallic_roughness.roughness, 0, 1);
        draw_number(view, m.name, "metallic", m.metallic_roughness.metallic, 0, 1);
        draw_number(view, m.name, "clearcoat", m.metallic_roughness.clearcoat, 0, 1);
    }
    draw_color(view, m.name, "emission", m.emission);
    draw_number(view, m.name, "normal_scale", m.normal_scale, 0, 4);
    static std::string text;
    if (ImGui::InputTextWithHint("any key", "bump_depth=0.1", &text, ImGuiInputTextFlags_EnterReturnsTrue))
        set(view, m.name, text);
    if (ImGui::Button("as in the file"))
        std::erase_if(view.look.materials, [&](const MaterialEdit& e) { return e.name == m.name; });
}

}  // namespace

void draw_materials_panel(PanelView& view) {
    const std::vector<Material>& materials = view.model->scene.materials;
    ImGui::TextDisabled(materials.empty() ? "The file has no materials" : "Alt+click on the picture selects");
    ImGui::BeginChild(
        "list", {0, std::min(160 * view.scale, float(materials.size() + 1) * ImGui::GetTextLineHeightWithSpacing())});
    ImGuiListClipper clipper;
    clipper.Begin(int(materials.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const std::string& name = materials[std::size_t(i)].name;
            const std::string title = (name.empty() ? "without a name" : one_line(name, 60)) + "##" + std::to_string(i);
            if (ImGui::Selectable(title.c_str(), view.ui.material == std::size_t(i))) view.ui.material = std::size_t(i);
        }
    ImGui::EndChild();
    if (view.ui.material >= materials.size()) return;
    const Material& m = materials[view.ui.material];
    if (m.name.empty())
        ImGui::TextWrapped("Materials are changed by name, and this one has none.");
    else
        draw_material(view, m);
}

}  // namespace rakelight::viewer
