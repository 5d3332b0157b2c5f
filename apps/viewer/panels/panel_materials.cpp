// SPDX-License-Identifier: Apache-2.0
// Values of materials, by the keys of [[material]].
#include <imgui.h>
// clang-format off: it stands on the line above
#include <imgui_stdlib.h>
// clang-format on

#include <algorithm>
#include <cstdio>

#include "../document/display_path.h"
#include "../document/materials.h"
#include "panels.h"
#include "widgets.h"

namespace rakelight::viewer {
namespace {

/// One material being edited.
struct Edited {
    PanelView& view;
    MaterialTarget target;
};

/// Numbers of a key: edited ones, else the file's. What is said of one object goes over what is said of all.
void value_of(const Edited& edited, const char* key, float* values, std::size_t count) {
    const std::uint32_t node = edited.target.node;
    for (const bool is_of_object : {false, true})
        for (const MaterialEdit& edit : edited.view.look.materials) {
            const bool is_meant = (edit.target.name == edited.target.name || edit.target.name == "*") &&
                                  edit.target.node == (is_of_object ? node : no_index);
            if (!is_meant || (is_of_object && node == no_index)) continue;
            for (const WorldValue& value : edit.values)
                for (std::size_t i = 0; value.key == key && i < std::min(count, value.numbers.size()); ++i)
                    values[i] = float(value.numbers[i]);
        }
}

void set(const Edited& edited, const std::string& key_and_value) try {
    set_material(edited.view.look, edited.target, key_and_value);
    if (edited.view.ui.message.is_error()) edited.view.ui.message.clear();
} catch (const Error& error) {
    edited.view.ui.message.fail(with_short_paths(error.what()));
}

void draw_number(const Edited& edited, const char* key, float value, float low, float high) {
    value_of(edited, key, &value, 1);
    if (!slide(key, value, low, high)) return;
    char text[80];
    std::snprintf(text, sizeof text, "%s=%.9g", key, double(value));
    set(edited, text);
}

void draw_color(const Edited& edited, const char* key, vec3 value) {
    value_of(edited, key, &value.x, 3);
    if (!edit_light_color(key, value)) return;
    char text[120];
    std::snprintf(text, sizeof text, "%s=%.9g,%.9g,%.9g", key, double(std::max(0.0f, value.x)),
                  double(std::max(0.0f, value.y)), double(std::max(0.0f, value.z)));
    set(edited, text);
}

/// A choice that the look makes; what the file says is not known by its word.
template <class T, std::size_t n>
void draw_word(const Edited& edited, const char* key, const Word<T> (&words)[n]) {
    std::string now = "as in the file";
    if (const std::vector<WorldValue>* const values = edited_values(edited.view.look, edited.target))
        for (const WorldValue& value : *values)
            if (value.key == key && !value.words.empty()) now = value.words[0];
    if (!ImGui::BeginCombo(key, now.c_str())) return;
    for (const Word<T>& word : words)
        if (ImGui::Selectable(word.name, now == word.name)) set(edited, std::string(key) + "=" + word.name);
    ImGui::EndCombo();
}

void draw_values(const Edited& edited, const Material& m) {
    draw_color(edited, "color", m.base_color.xyz());
    draw_number(edited, "opacity", m.base_color.w, 0, 1);
    if (m.model == MaterialModel::classical) {
        draw_color(edited, "specular", m.classical.specular);
        draw_number(edited, "shininess", m.classical.shininess, 1, 1000);
    } else if (m.model == MaterialModel::metallic_roughness) {
        draw_number(edited, "roughness", m.metallic_roughness.roughness, 0, 1);
        draw_number(edited, "metallic", m.metallic_roughness.metallic, 0, 1);
        draw_number(edited, "clearcoat", m.metallic_roughness.clearcoat, 0, 1);
    }
    draw_color(edited, "emission", m.emission);
    draw_number(edited, "normal_scale", m.normal_scale, 0, 4);
    draw_word(edited, "lighting", lighting_words);
    draw_word(edited, "shading", shading_words);
    draw_word(edited, "bump", bump_words);
    static std::string text;
    if (ImGui::InputTextWithHint("any key", "bump_depth=0.1", &text, ImGuiInputTextFlags_EnterReturnsTrue))
        set(edited, text);
    if (edited_values(edited.view.look, edited.target) && ImGui::Button("reset"))
        forget_material(edited.view.look, edited.target);
}

void draw_list(PanelView& view, std::size_t count) {
    const Scene& scene = view.model->scene;
    const float row = ImGui::GetTextLineHeightWithSpacing();
    ImGui::BeginChild("list", {0, std::min(160 * view.scale, float(count) * row + 4 * view.scale)});
    ImGuiListClipper clipper;
    clipper.Begin(int(count));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const std::string name = material_name(scene, std::uint32_t(i));
            const std::string title =
                (name.empty() ? "material " + std::to_string(i) : one_line(name, 60)) + "##" + std::to_string(i);
            if (!ImGui::Selectable(title.c_str(), view.ui.material == std::size_t(i))) continue;
            view.ui.material = std::size_t(i), view.ui.object = no_index;
        }
    ImGui::EndChild();
}

void draw_objects(PanelView& view) {
    const Scene& scene = view.model->scene;
    const std::vector<std::uint32_t>& objects = view.ui.objects_with_material;
    const bool is_chosen = view.ui.object != no_index;
    if (!ImGui::BeginCombo("object", is_chosen ? object_title(scene, view.ui.object).c_str() : "choose one")) return;
    ImGuiListClipper clipper;
    clipper.Begin(int(objects.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const std::uint32_t node = objects[std::size_t(i)];
            const std::string title = object_title(scene, node) + "##" + std::to_string(i);
            if (ImGui::Selectable(title.c_str(), view.ui.object == node)) view.ui.object = node;
        }
    ImGui::EndCombo();
}

/// Whose material is changed: that of all objects that share it, or of one; none: no object was chosen yet.
std::optional<MaterialTarget> draw_target(PanelView& view, std::uint32_t material) {
    const Scene& scene = view.model->scene;
    const std::string name = material_name(scene, material);
    std::vector<std::uint32_t>& objects = view.ui.objects_with_material;
    if (view.ui.objects_are_of != material) {
        objects = objects_with(scene, material < scene.materials.size() ? material : no_index);
        view.ui.objects_are_of = material;
    }
    if (objects.empty()) {
        ImGui::TextDisabled("no object has it");
        return {};
    }
    if (objects.size() == 1 && view.ui.object == no_index) view.ui.object = objects[0];
    if (std::ranges::find(objects, view.ui.object) == objects.end()) view.ui.object = no_index;
    if (objects.size() == 1) return target_of(scene, material, objects[0]);
    ImGui::TextDisabled("%zu objects share it", objects.size());
    if (!name.empty()) ImGui::Checkbox("change it for one object alone", &view.ui.is_object_alone);
    if (!name.empty() && !view.ui.is_object_alone) return MaterialTarget{.name = name};
    draw_objects(view);
    return view.ui.object == no_index ? std::nullopt : std::optional(target_in_object(scene, material, view.ui.object));
}

}  // namespace

void draw_materials_panel(PanelView& view) {
    const Scene& scene = view.model->scene;
    const std::size_t count = scene.materials.size() + (view.model->has_meshes_without_material ? 1 : 0);
    ImGui::TextDisabled("Alt+click an object selects its material");
    draw_list(view, count);
    if (view.ui.material >= count) return;
    const auto material = std::uint32_t(view.ui.material);
    const std::optional<MaterialTarget> target = draw_target(view, material);
    const Material plain;  // as engines draw meshes without one
    if (target) draw_values({view, *target}, material < scene.materials.size() ? scene.materials[material] : plain);
}

}  // namespace rakelight::viewer
