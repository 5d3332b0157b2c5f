// SPDX-License-Identifier: Apache-2.0
// Every setting of pictures as the command line has it.
#include <imgui.h>
// clang-format off: it stands on the line above
#include <imgui_stdlib.h>
// clang-format on

#include "../common/picture_options.h"
#include "display_path.h"
#include "panels.h"
#include "widgets.h"

namespace rakelight::viewer {
namespace {

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) text += (i > 0 ? " " : "") + words[i];
    return text;
}

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        if (end > at) words.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

/// The request with one key set again, checked with all others. @throws Error usage
PictureRequest with_key(const PictureRequest& request, const std::string& key, const std::string& text) {
    PictureRequest plain = request;
    plain.settings.material_shading = PictureRequest().settings.material_shading;  // it has no key; see below
    std::vector<WorldValue> values = written_render_keys(plain);
    std::erase_if(values, [&](const WorldValue& value) {
        return value.key == key || (key == "preset" && is_preset_key(value.key));
    });
    if (!text.empty()) {
        const bool is_list = require_render_key(key).kind == RenderKey::Kind::list;
        values.push_back(
            {.key = key, .words = is_list ? split(text) : std::vector<std::string>{text}, .is_array = is_list});
    }
    PictureRequest changed;
    changed.input = request.input, changed.load = request.load;
    read_render_keys(values, changed);
    changed.settings.material_shading = request.settings.material_shading && key != "shading";
    return changed;
}

void draw_setting(PanelView& view, const apps::Option& option) {
    const RenderKey* const key = find_render_key(option.name);
    static std::string edited, text;  // of the one field that has the keyboard
    const std::string now = joined(key->write(view.look.request));
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
            view.look.request = with_key(view.look.request, option.name, shown);
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
