// SPDX-License-Identifier: Apache-2.0
// Every setting of pictures as the command line has it.
#include <imgui.h>
// clang-format off: it stands on the line above
#include <imgui_stdlib.h>
// clang-format on

#include "../../common/picture_options.h"
#include "../document/display_path.h"
#include "../document/setting_text.h"
#include "panels.h"
#include "widgets.h"

namespace rakelight::viewer {
namespace {

void draw_setting(PanelView& view, const apps::Option& option) {
    static std::string edited, text;  // of the one field that has the keyboard
    const std::string now = setting_text(view.look.request, option.name);
    std::string shown = edited == option.name ? text : now;
    const bool is_entered = ImGui::InputText(option.name, &shown, ImGuiInputTextFlags_EnterReturnsTrue);
    if (ImGui::IsItemActive()) edited = option.name, text = shown;
    if (!ImGui::IsItemActive() && edited == option.name) edited.clear();
    if (ImGui::IsItemHovered()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(400 * view.scale);
        ImGui::TextUnformatted(option.help);
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
    if (is_entered && shown != now) try {
            set_setting(view.look, option.name, shown);
            view.ui.message.clear();
        } catch (const Error& error) {
            view.ui.message.fail(with_short_paths(error.what()));
        }
}

/// Of the view, the picture's size and its files the window decides; lights have a panel of their own.
bool is_left_out(const std::string& name) {
    constexpr const char* names[] = {"resolution", "window", "channels", "channel-files",
                                     "exr-colors", "light",  "material"};
    return std::ranges::find(names, name) != std::end(names);
}

}  // namespace

void draw_all_settings(PanelView& view) {
    static const std::vector<apps::Option> options = apps::picture_options();
    ImGui::InputTextWithHint("##filter", "filter", &view.ui.option_filter);
    for (const apps::Option& option : options) {
        const std::string name = option.name, group = option.group;
        if (is_left_out(name) || group == "Camera" || name.find(view.ui.option_filter) == std::string::npos) continue;
        draw_setting(view, option);
    }
}

}  // namespace rakelight::viewer
