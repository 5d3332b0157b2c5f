// SPDX-License-Identifier: Apache-2.0
// Smoothing: scope, weight, crease angle, and the seams that are left.
#include <cstdio>
#include <cstdlib>

#include <rakelight/prepare/prepare.h>

#include "panels.h"
#include "widgets.h"

namespace rakelight::viewer {
namespace {

/// In per cent of the model's diagonal, since gaps between parts are as large as models are; [m] in two digits, for the
/// file that it is saved to.
void slide_border_distance(double& distance, double diagonal) {
    if (!(diagonal > 0)) return;
    double percent = distance / diagonal * 100;
    char format[64] = "off";
    if (distance > 0) std::snprintf(format, sizeof format, "%%.3f %%%% (%.3g m)", distance);
    if (!slide("border distance", percent, 0, std::max(3.0, percent), format, true)) return;
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.2g", percent / 100 * diagonal);
    distance = std::strtod(digits, nullptr);
}

}  // namespace

void draw_normals_panel(PanelView& view) {
    PrepareOptions& p = view.look.request.prepare;
    constexpr Word<NormalSource> sources[] = {{"auto", NormalSource::automatic}, {"file", NormalSource::file},
                                              {"flat", NormalSource::flat},      {"object", NormalSource::object},
                                              {"model", NormalSource::model},    {"seams", NormalSource::seams}};
    choose("normals", sources, p.normals);
    choose("weight", corner_weight_words, p.weight);
    choose("creases", creasing_words, p.creases);
    double crease_deg = degrees(p.crease_angle_rad);
    if (slide("crease angle", crease_deg, 0, 180, "%.1f deg"))
        p.crease_angle_rad = radians(crease_deg), p.creases = Creasing::angle;
    slide_border_distance(p.border_distance, view.model ? view.model->box.bounds().diagonal() : 0);
    slide("subdivision", p.subdivision.level, 0, 4);
    ImGui::Checkbox("normals##lines", &view.ui.normals);
    ImGui::SameLine();
    ImGui::Checkbox("tangents##lines", &view.ui.tangents);
    ImGui::SameLine();
    ImGui::Checkbox("bitangents##lines", &view.ui.bitangents);
    ImGui::Checkbox("seams between parts", &view.ui.seams);
    if (view.seams) {
        ImGui::Text("%zu seam edges, worst %.2f degrees", view.seams->count, view.seams->worst_deg);
        if (view.seams->drawn.size() < view.seams->count)
            ImGui::TextDisabled("the worst %zu are drawn", view.seams->drawn.size());
    }
    if (ImGui::Button("save seamless")) view.commands.push_back(Command::save_seamless);
    ImGui::TextDisabled("writes the model, smoothed across objects");
}

}  // namespace rakelight::viewer
