// SPDX-License-Identifier: Apache-2.0
#include "panels.h"

#include <cstdio>

#include <rakelight/picture_parts.h>

#include "widgets.h"

namespace rakelight::viewer {
namespace {

struct PanelEntry {
    Panel panel;
    void (*draw)(PanelView&);
};
constexpr PanelEntry entries[] = {{Panel::view, draw_view_panel},           {Panel::shading, draw_shading_panel},
                                  {Panel::normals, draw_normals_panel},     {Panel::lights, draw_lights_panel},
                                  {Panel::materials, draw_materials_panel}, {Panel::pixel, draw_pixel_panel},
                                  {Panel::statistics, draw_statistics_panel}};

constexpr ImGuiWindowFlags floating = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                      ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoInputs;

void draw_help_group(const char* group) {
    ImGui::TextColored({0.4f, 0.65f, 1, 1}, "%s", group);
    if (!ImGui::BeginTable(group, 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (const Binding& binding : bindings()) {
        if (std::string(binding.group) != group || !*binding.keys) continue;
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(binding.keys);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(binding.what);
    }
    ImGui::EndTable();
}

std::string time_text(const Painting& painting) {
    char text[200];
    std::snprintf(text, sizeof text, "%.1f ms  %d x %d  %s%s", painting.ms, painting.width, painting.height,
                  painting.request.engine.c_str(), painting.is_final ? "" : painting.is_whole ? "  (1 sample)" : "  (coarse)");
    return text;
}

}  // namespace

void draw_panels(PanelView& view) {
    view.ui.panel_width = 0;
    if (!view.ui.shows_panels() || !view.model) return;
    const float widest = 0.6f * float(view.window_width);
    const float width = std::min(380 * view.scale, widest);
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({width, float(view.window_height)});
    ImGui::Begin("Panels", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PushItemWidth(0.55f * ImGui::GetWindowWidth());
    if (view.ui.split != Split::none)
        ImGui::TextDisabled("Keys and panels change picture %s (click into the other one)", view.ui.active == 0 ? "A" : "B");
    for (const PanelEntry& entry : entries) {
        bool& is_open = view.ui.open[std::size_t(entry.panel)];
        if (!is_open) continue;
        if (!ImGui::CollapsingHeader(panel_titles[std::size_t(entry.panel)], &is_open, ImGuiTreeNodeFlags_DefaultOpen)) continue;
        ImGui::PushID(int(entry.panel));
        entry.draw(view);
        ImGui::PopID();
        ImGui::Spacing();
    }
    ImGui::PopItemWidth();
    ImGui::End();
    view.ui.panel_width = width;
}

void draw_status(const PanelView& view) {
    const float left = view.ui.panel_width + 8 * view.scale;
    std::string text;
    if (view.ui.file_name && view.model) text += one_line(view.model->file, 100) + "\n";
    if (view.ui.frame_time && view.painting) text += time_text(*view.painting) + "\n";
    for (const std::string& work : view.works) text += work + "  (Esc cancels)\n";
    if (view.ui.is_walking) text += "walking: W A S D, Q E, mouse, Shift; Esc leaves\n";
    if (view.ui.is_picking) text += "click a pixel to have it explained; Esc leaves\n";
    if (view.model && view.look.channel) {
        int bit = 0;
        while (view.look.channel >> bit != 1) ++bit;
        text += "channel: " + channel_words()[std::size_t(bit)] + "\n";
    }
    if (!view.model && view.works.empty()) text += "Drop a model here, or name one on the command line\nH: keys\n";
    if (!view.ui.message.empty()) text += view.ui.message + "\n";
    if (text.empty()) return;
    text.pop_back();
    ImGui::SetNextWindowPos({left, float(view.window_height) - 8 * view.scale}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowBgAlpha(0.75f);
    ImGui::Begin("Status", nullptr, floating);
    ImGui::PushTextWrapPos(std::max(100.0f, float(view.window_width) - left - 24 * view.scale));
    if (view.ui.is_message_error) ImGui::PushStyleColor(ImGuiCol_Text, view.ui.is_dark ? ImVec4{1, 0.6f, 0.5f, 1} : ImVec4{0.7f, 0.1f, 0, 1});
    ImGui::TextUnformatted(text.c_str());
    if (view.ui.is_message_error) ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::End();
}

void draw_help(PanelView& view) {
    if (!view.ui.help) return;
    const ImVec2 middle{0.5f * float(view.window_width), 0.5f * float(view.window_height)};
    ImGui::SetNextWindowPos(middle, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {0.96f * float(view.window_width), 0.96f * float(view.window_height)});
    ImGui::Begin("Keys (H closes)", &view.ui.help, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse);
    if (ImGui::BeginTable("columns", 2, ImGuiTableFlags_SizingFixedFit)) {
        ImGui::TableNextColumn();
        for (const char* group : {"View", "Files"}) draw_help_group(group);
        ImGui::TextColored({0.4f, 0.65f, 1, 1}, "Mouse");
        ImGui::TextUnformatted("left: orbit    Shift+left, middle: pan\nwheel, right: zoom    Ctrl+left: roll\n"
                               "middle click, double click: center on the point\ndrop: model; Shift: environment; picture on an object: texture");
        ImGui::TableNextColumn();
        for (const char* group : {"Picture", "Marks", "Window"}) draw_help_group(group);
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace rakelight::viewer
