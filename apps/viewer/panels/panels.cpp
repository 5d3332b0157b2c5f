// SPDX-License-Identifier: Apache-2.0
#include "panels.h"

#include <cstdio>

#include "widgets.h"

namespace rakelight::viewer {
namespace {

void row(const char* what, const std::string& value) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(what);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(value.c_str());
}

std::string ms(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.1f ms", value);
    return text;
}

void draw_painting(const Painting& p) {
    const RenderStats& s = p.stats;
    row("engine", p.request.engine);
    row("picture", std::to_string(p.width) + " x " + std::to_string(p.height));
    row("frame time", ms(p.ms));
    row("front end", ms(1e3 * s.times.front_end));
    row("tiles", ms(1e3 * s.times.tiles));
    // Numbers that an engine does not count are left out.
    const auto count = [](const char* what, std::uint64_t number) {
        if (number > 0) row(what, std::to_string(number));
    };
    count("triangles in", s.triangles_in);
    count("culled: back", s.culled_back);
    count("culled: outside", s.culled_outside);
    count("drawn", s.drawn);
    count("pixels shaded", s.pixels_shaded);
    count("shadow maps", s.shadow_maps);
    count("primary rays", s.rays.primary);
    count("shadow rays", s.rays.shadow);
    count("reflected rays", s.rays.reflected);
    count("refracted rays", s.rays.refracted);
    if (s.rays.primary > 0) row("ray tree", std::to_string(s.rays.scene_bytes / 1024) + " KiB");
    for (const GpuPass& pass : s.gpu_passes) row(("GPU: " + pass.name).c_str(), ms(1e3 * pass.seconds));
}

void draw_statistics_panel(PanelView& view) {
    const Model& m = *view.model;
    if (ImGui::BeginTable("statistics", 2, ImGuiTableFlags_SizingStretchProp)) {
        row("objects", std::to_string(m.objects));
        row("triangles", std::to_string(m.triangles));
        row("vertices", std::to_string(m.vertices));
        row("materials", std::to_string(m.scene.materials.size()));
        row("textures", std::to_string(m.scene.textures.size()));
        row("lights of the file", std::to_string(m.scene.lights.size()));
        row("loaded in", ms(m.load_ms));
        if (view.painting) draw_painting(*view.painting);
        row("longest pause", ms(view.longest_block_ms));
        ImGui::EndTable();
    }
    for (const ReportEntry& entry : m.remarks)
        if (entry.remark != Remark::note)
            ImGui::TextWrapped("%s: %s", name_of(entry.remark), one_line(entry.message).c_str());
    if (view.painting)
        for (const std::string& warning : view.painting->warnings) ImGui::TextWrapped("%s", warning.c_str());
}

/// [px] of the column in which the text of an explained pixel is seen whole; 0: there is none.
float explained_width(const PanelView& view) {
    if (view.ui.explained.empty()) return 0;
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
    const char* const text = view.ui.explained.c_str();
    const float width = ImGui::CalcTextSize(text, text + view.ui.explained.size()).x;
    ImGui::PopFont();
    const ImGuiStyle& style = ImGui::GetStyle();
    return width + 4 * style.WindowPadding.x + 2 * style.ScrollbarSize;
}

void draw_pixel_panel(PanelView& view) {
    ImGui::Checkbox("explain the clicked pixel (P)", &view.ui.is_picking);
    if (view.ui.explained.empty()) return;
    const bool is_last = !view.ui.open[std::size_t(Panel::statistics)];
    const float least = 420 * view.scale;
    const float height = is_last ? std::max(least, ImGui::GetContentRegionAvail().y - 8 * view.scale) : least;
    ImGui::BeginChild("explained", {0, height}, true, ImGuiWindowFlags_HorizontalScrollbar);
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
    ImGui::TextUnformatted(view.ui.explained.c_str(), view.ui.explained.c_str() + view.ui.explained.size());
    ImGui::PopFont();
    ImGui::EndChild();
}

struct PanelEntry {
    Panel panel;
    void (*draw)(PanelView&);
};
constexpr PanelEntry entries[] = {{Panel::view, draw_view_panel},       {Panel::motion, draw_motion_panel},
                                  {Panel::shading, draw_shading_panel}, {Panel::normals, draw_normals_panel},
                                  {Panel::lights, draw_lights_panel},   {Panel::materials, draw_materials_panel},
                                  {Panel::pixel, draw_pixel_panel},     {Panel::statistics, draw_statistics_panel}};

/// As wide as the user dragged it; else as the panels need it, the table of an explained pixel too.
float column_width(const PanelView& view) {
    const UiState& ui = view.ui;
    const float widest = 0.75f * float(view.window_width), narrowest = std::min(200 * view.scale, widest);
    float width = 380 * view.scale;
    if (ui.open[std::size_t(Panel::pixel)])
        width = std::max(width, std::min(explained_width(view), 0.5f * float(view.window_width)));
    if (ui.panel_column > 0) width = ui.panel_column * view.scale;
    return std::clamp(width, narrowest, widest);
}

/// The column's right edge, to be dragged.
void draw_splitter(PanelView& view, float width) {
    const float half = 4 * view.scale, height = float(view.window_height);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::SetNextWindowPos({width - half, 0});
    ImGui::SetNextWindowSize({2 * half, height});
    ImGui::Begin("Splitter", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::InvisibleButton("edge", {2 * half, height});
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1))
        view.ui.panel_column = std::max(1.0f, ImGui::GetIO().MousePos.x / view.scale);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        ImGui::GetWindowDrawList()->AddLine({width, 0}, {width, height}, ImGui::GetColorU32(ImGuiCol_SeparatorHovered),
                                            2 * view.scale);
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) view.ui.panel_column = 0;
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace

void draw_panels(PanelView& view) {
    view.ui.panel_width = 0;
    if (!view.ui.shows_panels() || !view.model) return;
    const float width = column_width(view);
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({width, float(view.window_height)});
    ImGui::Begin("Panels", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PushItemWidth(0.55f * ImGui::GetWindowWidth());
    if (view.ui.split != Split::none)
        ImGui::TextWrapped("Keys and panels change picture %s; click into the other one to change that.",
                           view.ui.active == 0 ? "A" : "B");
    for (const PanelEntry& entry : entries) {
        bool& is_open = view.ui.open[std::size_t(entry.panel)];
        if (!is_open) continue;
        if (!ImGui::CollapsingHeader(panel_titles[std::size_t(entry.panel)], &is_open, ImGuiTreeNodeFlags_DefaultOpen))
            continue;
        ImGui::PushID(int(entry.panel));
        entry.draw(view);
        ImGui::PopID();
        ImGui::Spacing();
    }
    ImGui::PopItemWidth();
    ImGui::End();
    draw_splitter(view, width);
    view.ui.panel_width = width;
}

}  // namespace rakelight::viewer
