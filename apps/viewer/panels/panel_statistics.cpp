// SPDX-License-Identifier: Apache-2.0
// What was counted; and the pixel that was picked.
#include "panels.h"
#include "widgets.h"

#include <cstdio>

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
    // What an engine does not count is left out.
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

}  // namespace

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

}  // namespace rakelight::viewer
