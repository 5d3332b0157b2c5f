// SPDX-License-Identifier: Apache-2.0
// What keys do: one table for the window, the cheat sheet and the documentation.
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace rakelight::viewer {

enum class Command : std::uint8_t {
    none,
    // files
    next_file,
    previous_file,
    reload,
    screenshot,
    clean_screenshot,
    save_world,
    copy_command_line,
    save_seamless,
    record,
    quit,
    // view
    fit,
    reset_view,
    front,
    back,
    right,
    left,
    top,
    bottom,
    isometric,
    orthographic,
    roll_left,
    roll_right,
    raise,
    lower,
    next_camera,
    up_axis,
    walk,
    arcball,
    // picture
    shading,
    lighting,
    bump,
    channel,
    previous_channel,
    samples,
    tone,
    shadows,
    edges,
    wireframe,
    points,
    environment_light,
    environment_background,
    brighter,
    darker,
    engine,
    // motion
    play,
    next_clip,
    previous_clip,
    at_rest,
    frame_back,
    frame_on,
    slower,
    faster,
    loop,
    turntable,
    set_key,
    delete_key,
    // marks over the picture
    grid,
    axes,
    light_glyphs,
    follow_camera,
    normals,
    tangents,
    bitangents,
    seams,
    // window
    panel_view,
    panel_shading,
    panel_normals,
    panel_lights,
    panel_materials,
    panel_pixel,
    panel_statistics,
    panel_motion,
    all_panels,
    file_name,
    frame_time,
    split,
    second_view,
    pick,
    theme,
    full_screen,
    help,
    leave,
};

/// Keys by GLFW's numbers: letters and digits are their ASCII capitals.
using Key = int;
constexpr Key key_left_shift = 340, key_right_shift = 344;  // numbers of keys are GLFW's
enum Modifier : int { mod_none = 0, mod_shift = 1, mod_control = 2, mod_alt = 4 };

struct Binding {
    Command command;
    Key key;
    int modifiers;
    const char *keys, *what, *group;  ///< for people; `keys` is empty where the row above says both
};

std::span<const Binding> bindings();
/// Command::none: nothing is bound.
Command command_of(Key key, int modifiers);
/// The keypad's digits and point as those above the letters.
Key without_keypad(Key key);
/// The cheat sheet as lines of text, for the documentation: a Markdown table.
std::string key_table_text();

}  // namespace rakelight::viewer
