// SPDX-License-Identifier: Apache-2.0
#include "ui_state.h"

#include <algorithm>

#include "display_path.h"

namespace rakelight::viewer {

bool UiState::shows_panels() const { return !are_panels_hidden && std::ranges::find(open, true) != open.end(); }

void UiState::toggle(Panel panel) {
    bool& is_open = open[std::size_t(panel)];
    is_open = are_panels_hidden || !is_open;
    are_panels_hidden = false;
}

void UiState::redraw(int frames) { frames_to_draw = std::max(frames_to_draw, frames); }

void UiState::say(const std::string& text) {
    message.say(text);
    redraw();
}

void UiState::report(const Error& error) {
    message.fail(with_short_paths(error.what()));
    redraw();
}

bool apply(Command command, UiState& ui) {
    const auto flip = [](bool& value) { return value = !value, true; };
    const auto split = [&ui](Split to) { return ui.split = ui.split == to ? Split::none : to, true; };
    if (command >= Command::panel_view && command <= Command::panel_motion)
        return ui.toggle(Panel(std::size_t(command) - std::size_t(Command::panel_view))), true;
    switch (command) {
        case Command::grid:
            return flip(ui.grid);
        case Command::axes:
            return flip(ui.axes);
        case Command::light_glyphs:
            return flip(ui.light_glyphs);
        case Command::normals:
            return flip(ui.normals);
        case Command::tangents:
            return flip(ui.tangents);
        case Command::bitangents:
            return flip(ui.bitangents);
        case Command::seams:
            return flip(ui.seams);
        case Command::all_panels:
            if (!ui.shows_panels() && !ui.are_panels_hidden) return ui.open.fill(true), true;
            return flip(ui.are_panels_hidden);
        case Command::file_name:
            return flip(ui.file_name);
        case Command::frame_time:
            return flip(ui.frame_time);
        case Command::split:
            return split(Split::wipe);
        case Command::second_view:
            return split(Split::beside);
        case Command::pick:
            return flip(ui.is_picking);
        case Command::arcball:
            return flip(ui.is_arcball);
        case Command::walk:
            return flip(ui.is_walking);
        case Command::help:
            return flip(ui.help);
        case Command::theme:
            return flip(ui.is_dark);
        default:
            return false;
    }
}

}  // namespace rakelight::viewer
