// SPDX-License-Identifier: Apache-2.0
// What the window shows beside the picture. None of it is saved with a look.
#pragma once
#include <array>
#include <string>
#include <vector>

#include <rakelight/base/error.h>

#include "../motion/player.h"
#include "document.h"
#include "keys.h"
#include "message.h"

namespace rakelight::viewer {

enum class Panel : std::uint8_t { view, shading, normals, lights, materials, pixel, statistics, motion };
inline constexpr std::size_t panel_count = 8;
inline constexpr const char* panel_titles[panel_count] = {"View",      "Shading", "Normals",    "Lights",
                                                          "Materials", "Pixel",   "Statistics", "Motion"};

/// Two pictures: none; B over A right of a line; side by side, each with a camera of its own.
enum class Split : std::uint8_t { none, wipe, beside };

inline constexpr int settling_frames = 3;  ///< that ImGui needs after a change

struct UiState {
    std::array<bool, panel_count> open{};
    bool are_panels_hidden = false;
    float panel_width = 0;   ///< [points] that the panels take at the left
    float panel_column = 0;  ///< [px at scale 1] as wide as the user has dragged them; 0: as wide as they need
    bool grid = false, axes = false, light_glyphs = false, normals = false, tangents = false, bitangents = false,
         seams = false;
    bool announces = true;  ///< messages tell what a key did
    bool file_name = true, frame_time = false, help = false, is_picking = false, is_walking = false;
    bool has_blender_mouse = false;  ///< the middle button orbits
    bool is_arcball = false, is_dark = true;
    Split split = Split::none;
    double wipe = 0.5;                    ///< 0..1 across the picture
    std::size_t active = 0;               ///< look that keys and panels change
    std::size_t light = 0, material = 0;  ///< selected
    std::uint32_t object = no_index;      ///< node that was selected with its material
    bool is_object_alone = false;         ///< its material alone is changed, not that of all objects that share it
    /// Nodes that have the selected material, of the material of this number; no_index: not known yet.
    std::vector<std::uint32_t> objects_with_material;
    std::uint32_t objects_are_of = no_index;
    Player player;  ///< of the looks that are seen
    Message message;
    std::string explained;
    int record_frames = 72;
    std::string option_filter;
    int frames_to_draw = settling_frames;  ///< at least, also if nothing else changes

    bool shows_panels() const;
    void toggle(Panel panel);
    void redraw(int frames = settling_frames);
    void say(const std::string& text);  ///< what was done
    void report(const Error& error);    ///< what could not be done
};

/// Applies a command that changes the window's state alone; false: it does not.
bool apply(Command command, UiState& ui);

}  // namespace rakelight::viewer
