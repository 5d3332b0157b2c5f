// SPDX-License-Identifier: Apache-2.0
// Cameras, projection, up axis, split and recording.
#include "panels.h"
#include "widgets.h"

namespace rakelight::viewer {
namespace {

void draw_cameras(PanelView& view) {
    const auto& cameras = view.model->box.cameras();
    ImGui::TextDisabled(cameras.empty() ? "The file has no cameras" : "Cameras of the file");
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const bool is_shown = current_camera(view.look, *view.model) == i;
        if (!ImGui::Selectable((cameras[i] + "##" + std::to_string(i)).c_str(), is_shown)) continue;
        view.look.eye.reset();
        view.look.request.view = {.camera = std::to_string(i)};
    }
}

void draw_side_buttons(PanelView& view) {
    constexpr struct {
        const char* name;
        Command command;
    } sides[] = {{"front", Command::front},         {"back", Command::back}, {"right", Command::right},
                 {"left", Command::left},           {"top", Command::top},   {"bottom", Command::bottom},
                 {"isometric", Command::isometric}, {"fit", Command::fit}};
    for (std::size_t i = 0; i < std::size(sides); ++i) {
        if (i % 4 != 0) ImGui::SameLine();
        if (ImGui::Button(sides[i].name)) view.commands.push_back(sides[i].command);
    }
}

}  // namespace

void draw_view_panel(PanelView& view) {
    draw_side_buttons(view);
    Eye eye = seen_eye(view.look, *view.model, view.width, view.height);
    const Eye before = eye;
    ImGui::Checkbox("orthographic", &eye.is_orthographic);
    if (slide("field of view", eye.fov_deg, 1, 170, "%.1f deg")) eye.horizontal_fov_deg.reset();
    const double step = 0.002 * view.model->box.bounds().diagonal();
    edit_place("position", eye.position, step);
    edit_place("target", eye.focal, step);
    if (!(eye == before)) set_eye(view.look, eye, *view.model, view.width, view.height);
    const dvec3 up = view.look.world_up;
    const std::string axis = up == dvec3{0, 1, 0}   ? "+Y"
                             : up == dvec3{0, 0, 1} ? "+Z"
                             : up == dvec3{1, 0, 0} ? "+X"
                                                    : "as given";
    if (ImGui::Button(("up axis: " + axis).c_str())) view.commands.push_back(Command::up_axis);
    ImGui::SameLine();
    ImGui::Checkbox("arcball", &view.ui.is_arcball);
    ImGui::SameLine();
    ImGui::Checkbox("Blender's mouse", &view.ui.has_blender_mouse);
    draw_cameras(view);
    ImGui::Separator();
    int split = int(view.ui.split);
    ImGui::RadioButton("single", &split, 0);
    ImGui::SameLine();
    ImGui::RadioButton("A|B", &split, 1);
    ImGui::SameLine();
    ImGui::RadioButton("side by side", &split, 2);
    if (split != int(view.ui.split))
        view.commands.push_back(split == 0   ? (view.ui.split == Split::wipe ? Command::split : Command::second_view)
                                : split == 1 ? Command::split
                                             : Command::second_view);
    ImGui::InputInt("turntable frames", &view.ui.record_frames);
    view.ui.record_frames = std::clamp(view.ui.record_frames, 1, 10000);
    if (ImGui::Button("record turntable")) view.commands.push_back(Command::record);
    ImGui::SameLine();
    if (ImGui::Button("screenshot")) view.commands.push_back(Command::screenshot);
    if (ImGui::Button("save scene")) view.commands.push_back(Command::save_world);
    ImGui::SameLine();
    if (ImGui::Button("copy command line")) view.commands.push_back(Command::copy_command_line);
}

}  // namespace rakelight::viewer
