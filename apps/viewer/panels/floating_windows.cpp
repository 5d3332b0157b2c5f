// SPDX-License-Identifier: Apache-2.0
#include "floating_windows.h"

#include <cstdio>

#include <rakelight/render/picture.h>
#include <rakelight_internal/base/text.h>

#include "../document/display_path.h"
#include "widgets.h"

namespace rakelight::viewer {
namespace {

constexpr ImGuiWindowFlags floating = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                                      ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoInputs;

/// Legible on dark and on light ground.
ImVec4 heading() {
    return ImGui::GetStyle().Colors[ImGuiCol_WindowBg].x < 0.5f ? ImVec4{0.45f, 0.7f, 1, 1}
                                                                : ImVec4{0.05f, 0.3f, 0.7f, 1};
}

void draw_help_group(const char* group, float scale) {
    ImGui::TextColored(heading(), "%s", group);
    for (const Binding& binding : bindings()) {
        if (std::string(binding.group) != group || !*binding.keys) continue;
        ImGui::TextUnformatted(binding.keys);
        ImGui::SameLine(112 * scale);
        ImGui::TextUnformatted(binding.what);
    }
    ImGui::Spacing();
}

void draw_own_keys(std::span<const OwnKey> keys, float scale) {
    if (keys.empty()) return;
    ImGui::TextColored(heading(), "Keys of your own");
    for (const OwnKey& own : keys) {
        ImGui::TextUnformatted(own.keys.c_str());
        ImGui::SameLine(112 * scale);
        ImGui::TextUnformatted(own.command == Command::none ? "nothing" : ("as " + own.usual).c_str());
    }
    ImGui::Spacing();
}

void draw_mouse_help(bool is_blender, float scale) {
    const char* const middle = is_blender ? "orbit (Shift: pan, Ctrl: zoom)" : "pan; click: center there";
    const char* const rows[][2] = {{"left", "orbit"},
                                   {"Shift+left", "pan"},
                                   {"Ctrl+left", "roll"},
                                   {"middle", middle},
                                   {"wheel, right", "zoom"},
                                   {"2 clicks", "center on the point"},
                                   {"Alt+click", "its material"}};
    ImGui::TextColored(heading(), "Mouse");
    for (const auto& row : rows) {
        ImGui::TextUnformatted(row[0]);
        ImGui::SameLine(112 * scale);
        ImGui::TextUnformatted(row[1]);
    }
    ImGui::TextUnformatted("drop: model (Ctrl: add), .hdr: environment,\npicture on an object: its texture");
}

std::string count_of_samples(int samples) { return counted(std::uint64_t(samples), "sample"); }

/// How far it has come.
std::string refinement_text(const Painting& painting) {
    if (!painting.is_whole) return "  (coarse)";
    const RayStats& rays = painting.stats.rays;
    const int wanted = painting.request.settings.samples;
    if (!painting.is_final)
        return "  (" + std::to_string(std::max(rays.samples, 1)) + " of " + count_of_samples(wanted) + ")";
    if (rays.passes == 0) return "";
    char noise[40] = "";
    if (rays.noise > 0) std::snprintf(noise, sizeof noise, ", error %.2g %%", 100 * rays.noise);
    return "  (" + count_of_samples(rays.samples) + noise + ")";
}

std::string time_text(const Painting& painting) {
    char text[200];
    std::snprintf(text, sizeof text, "%.1f ms  %d x %d  %s%s", painting.ms, painting.width, painting.height,
                  painting.request.engine.c_str(), refinement_text(painting).c_str());
    return text;
}

}  // namespace

void draw_status(const PanelView& view) {
    const float left = view.ui.panel_width + 8 * view.scale;
    std::string text;
    if (view.ui.file_name && view.model) {
        text += one_line(display_path(view.model->file), 100);
        if (view.file_count > 1)
            text += "  " + std::to_string(view.file_number + 1) + " of " + std::to_string(view.file_count);
        text += "\n";
    }
    if (view.ui.frame_time && view.painting)
        text += time_text(*view.painting) + "\n";
    else if (view.painting && comes_in_passes(view.painting->request) && !view.painting->is_final)
        text += "paths" + refinement_text(*view.painting) + "\n";
    for (const std::string& work : view.works) text += work + "  (Esc cancels)\n";
    if (view.ui.is_walking) text += "walking: W A S D, Q E, mouse, Shift; Esc leaves\n";
    if (view.ui.is_picking) text += "click a pixel to have it explained; Esc leaves\n";
    if (view.model && view.look.channel) {
        int bit = 0;
        while (view.look.channel >> bit != 1) ++bit;
        text += "channel: " + channel_words()[std::size_t(bit)] + "\n";
    }
    if (!view.model && view.works.empty()) text += "Drop a model here, or name one on the command line\nH: keys\n";
    if ((text.empty() && view.ui.message.text().empty()) || view.ui.help) return;
    if (!text.empty()) text.pop_back();
    ImGui::SetNextWindowPos({left, float(view.window_height) - 8 * view.scale}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowBgAlpha(0.75f);
    ImGui::Begin("Status", nullptr, floating);
    ImGui::PushTextWrapPos(std::max(100.0f, float(view.window_width) - left - 24 * view.scale));
    if (!text.empty()) ImGui::TextUnformatted(text.c_str());
    const ImVec4 alarm = view.ui.is_dark ? ImVec4{1, 0.6f, 0.5f, 1} : ImVec4{0.7f, 0.1f, 0, 1};
    if (view.ui.message.is_error()) ImGui::PushStyleColor(ImGuiCol_Text, alarm);
    if (!view.ui.message.text().empty()) ImGui::TextUnformatted(view.ui.message.text().c_str());
    if (view.ui.message.is_error()) ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::End();
}

void draw_help(PanelView& view) {
    if (!view.ui.help) return;
    const ImVec2 middle{0.5f * float(view.window_width), 0.5f * float(view.window_height)};
    ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {0.96f * float(view.window_width), 0.96f * float(view.window_height)});
    ImGui::Begin(
        "Keys (H closes)", &view.ui.help,
        ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_HorizontalScrollbar);
    constexpr float wide = 1200,
                    smallest = 0.6f;  // what the sheet takes at scale 1; texts are smaller where there is less
    const float shrink = std::clamp(float(view.window_width) / (wide * view.scale), smallest, 1.0f),
                scale = view.scale * shrink;
    ImGui::SetWindowFontScale(shrink);
    ImGui::BeginGroup();
    draw_help_group("View", scale), draw_help_group("Motion", scale);
    ImGui::EndGroup();
    ImGui::SameLine(0, 24 * scale);
    ImGui::BeginGroup();
    draw_help_group("Picture", scale), draw_help_group("Marks", scale);
    draw_mouse_help(view.ui.has_blender_mouse, scale);
    ImGui::EndGroup();
    ImGui::SameLine(0, 24 * scale);
    ImGui::BeginGroup();
    draw_help_group("Files", scale), draw_help_group("Window", scale), draw_own_keys(view.own_keys, scale);
    ImGui::EndGroup();
    ImGui::End();
}

}  // namespace rakelight::viewer
