// SPDX-License-Identifier: Apache-2.0
// Clips with their lengths, the player, the moment, recorded keys.
#include <cstdio>

#include "../motion/recorded_keys.h"
#include "panels.h"
#include "widgets.h"

namespace rakelight::viewer {
namespace {

void draw_clip(PanelView& view, std::optional<int> clip) {
    Look& look = view.look;
    const bool is_shown = clip == -1 ? look.request.motion.index == -1
                          : clip     ? chosen_clip(look, *view.model) == clip
                                     : !look.request.motion.is_set();
    ImGui::PushID(clip.value_or(-2));
    if (ImGui::Selectable(clip_title(*view.model, clip).c_str(), is_shown)) choose_clip(look, clip);
    ImGui::PopID();
}

void draw_clips(PanelView& view) {
    const int count = int(view.model->scene.animations.size());
    if (count == 0) return ImGui::TextDisabled("The file has no clips");
    constexpr int most_rows = 8;
    const float rows = float(std::min(count + 1 + (count > 1), most_rows));
    ImGui::BeginChild("clips", {0, rows * ImGui::GetTextLineHeightWithSpacing() + 4 * view.scale}, true);
    draw_clip(view, {});
    for (int i = 0; i < count; ++i) draw_clip(view, i);
    if (count > 1) draw_clip(view, -1);
    ImGui::EndChild();
}

void draw_buttons(PanelView& view) {
    const Player& player = view.ui.player;
    const auto button = [&](const char* name, Command command) {
        if (ImGui::Button(name)) view.commands.push_back(command);
        ImGui::SameLine();
    };
    button("|<", Command::frame_back);
    button(player.is_playing ? "pause###play" : "play###play", Command::play);
    button(">|", Command::frame_on);
    bool loops = player.loops;
    if (ImGui::Checkbox("loop", &loops)) view.commands.push_back(Command::loop);
}

/// The moment, with a mark for each key.
void draw_moment(PanelView& view) {
    Player& player = view.ui.player;
    const ClipSpan span = span_of(view.look, *view.model, player);
    double time_s = time_of(view.look, *view.model, player);
    ImGui::PushItemWidth(-1);
    if (slide("##moment", time_s, span.begin_s, span.end_s, "%.3f s")) {
        player.is_playing = false;
        set_time(view.look, *view.model, player, view.width, view.height, time_s);
    }
    ImGui::PopItemWidth();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    if (!(span.length() > 0)) return;
    const float grab = ImGui::GetStyle().GrabMinSize + 4;  // the slider's grab moves between its halves at both ends
    for (const double key_s : key_times(view.look)) {
        const float share = float((key_s - span.begin_s) / span.length()), half = 4 * view.scale;
        const float x = low.x + 0.5f * grab + share * (high.x - low.x - grab);
        ImGui::GetWindowDrawList()->AddTriangleFilled({x - half, high.y + half}, {x, high.y - half},
                                                      {x + half, high.y + half},
                                                      ImGui::GetColorU32(ImGuiCol_PlotHistogram));
    }
}

void draw_keys(PanelView& view) {
    if (ImGui::Button("set key")) view.commands.push_back(Command::set_key);
    const std::vector<double> times = key_times(view.look);
    if (times.empty()) {
        ImGui::SameLine();
        return ImGui::TextDisabled("for the camera and moved lights");
    }
    ImGui::SameLine();
    if (ImGui::Button("delete key")) view.commands.push_back(Command::delete_key);
    ImGui::TextUnformatted("keys at");
    for (std::size_t i = 0; i < times.size(); ++i) {
        char text[40];
        std::snprintf(text, sizeof text, "%.3f s##%zu", times[i], i);
        if (i % 4 != 0) ImGui::SameLine();
        if (!ImGui::Button(text)) continue;
        view.ui.player.is_playing = false;
        set_time(view.look, *view.model, view.ui.player, view.width, view.height, times[i]);
    }
}

}  // namespace

void draw_motion_panel(PanelView& view) {
    Player& player = view.ui.player;
    draw_clips(view);
    draw_buttons(view);
    draw_moment(view);
    ImGui::Dummy({0, 2 * view.scale});
    slide("speed", player.speed, 1.0 / 16, 16.0, "%.3g times", true);
    if (!view.look.request.motion.is_set()) slide("length", player.length_s, 0.1, 120.0, "%.1f s", true);
    draw_keys(view);
    ImGui::Separator();
    ImGui::Checkbox("turntable", &player.is_turning);
    slide("duration of a turn", player.turn_s, 1.0, 120.0, "%.1f s", true);
}

}  // namespace rakelight::viewer
