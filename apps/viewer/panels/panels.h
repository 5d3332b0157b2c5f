// SPDX-License-Identifier: Apache-2.0
// The panels beside the picture: they read and change a look, and ask for commands. Drawn by Dear ImGui.
#pragma once
#include <string>
#include <vector>

#include <rakelight/tools/inspect.h>

#include "../document/own_keys.h"
#include "../document/ui_state.h"
#include "../view/painter.h"

namespace rakelight::viewer {

/// The state of the viewer as the panels read it, and their requests to it.
struct PanelView {
    const Model* model = nullptr;  ///< null: nothing is loaded; then `look` is not read
    Look& look;
    UiState& ui;
    const Painting* painting = nullptr;       ///< what is shown; null: nothing yet
    int width = 1, height = 1;                ///< [px] of the picture
    int window_width = 1, window_height = 1;  ///< points, as ImGui counts
    float scale = 1;
    double longest_block_ms = 0;
    std::span<const OwnKey> own_keys{};
    std::size_t file_number = 0, file_count = 1;  ///< of the list, from 0
    const Seams* seams = nullptr;                 ///< null: not looked for
    std::vector<std::string> works;               ///< what runs: "load 40 %"
    std::vector<Command> commands;                ///< out: as if their keys had been pressed
};

/// The column at the left; sets UiState::panel_width.
void draw_panels(PanelView& view);
// One panel each, in the source of its name; the panels of text are in panels.cpp.
void draw_view_panel(PanelView& view);
void draw_motion_panel(PanelView& view);
void draw_shading_panel(PanelView& view);
void draw_normals_panel(PanelView& view);
void draw_lights_panel(PanelView& view);
void draw_materials_panel(PanelView& view);

}  // namespace rakelight::viewer
