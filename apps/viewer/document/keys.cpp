// SPDX-License-Identifier: Apache-2.0
#include "keys.h"

namespace rakelight::viewer {
namespace {

// GLFW's numbers of keys that are no characters (glfw3.h, which is the window's alone).
constexpr Key escape = 256, enter = 257, tab = 258, backspace = 259, insert = 260, del = 261, right = 262, left = 263,
              up = 265, page_down = 267, home = 268, f1 = 290, keypad_0 = 320, keypad_decimal = 330, keypad_enter = 335;
constexpr const char *files = "Files", *view = "View", *picture = "Picture", *motion = "Motion", *marks = "Marks",
                     *window = "Window";

constexpr Binding table[] = {
    {Command::next_file, right, 0, "Right", "next file of the list", files},
    {Command::previous_file, left, 0, "Left", "previous file", files},
    {Command::reload, up, 0, "Up", "reload the file", files},
    {Command::screenshot, f1 + 11, 0, "F12", "screenshot", files},
    {Command::clean_screenshot, f1 + 11, mod_control, "Ctrl+F12", "transparent screenshot", files},
    {Command::save_world, 'S', mod_control, "Ctrl+S", "save as *.scene.toml", files},
    {Command::copy_command_line, 'C', mod_control, "Ctrl+C", "copy as command line", files},
    {Command::save_seamless, 'S', mod_control | mod_shift, "Ctrl+Shift+S", "save with seam-free normals", files},
    {Command::record, f1 + 8, 0, "F9", "record a turntable as PNG files", files},
    {Command::quit, 'Q', mod_control, "Ctrl+Q", "quit", files},

    {Command::fit, 'F', 0, "F, .", "fit the model to the view", view},
    {Command::fit, '.', 0, "", "", view},
    {Command::reset_view, home, 0, "Enter, Home", "reset the view", view},
    {Command::reset_view, enter, 0, "", "", view},
    {Command::reset_view, keypad_enter, 0, "", "", view},
    {Command::front, '1', 0, "1, Ctrl+1", "from the front, from the back", view},
    {Command::back, '1', mod_control, "", "", view},
    {Command::right, '3', 0, "3, Ctrl+3", "from the right, from the left", view},
    {Command::left, '3', mod_control, "", "", view},
    {Command::top, '7', 0, "7, Ctrl+7", "from above, from below", view},
    {Command::bottom, '7', mod_control, "", "", view},
    {Command::isometric, '9', 0, "9", "isometric view", view},
    {Command::orthographic, '5', 0, "5", "orthographic projection", view},
    {Command::roll_left, '4', 0, "4, 6", "roll by 90 degrees", view},
    {Command::roll_right, '6', 0, "", "", view},
    {Command::raise, '8', 0, "8, 2", "orbit up, down by 90 degrees", view},
    {Command::lower, '2', 0, "", "", view},
    {Command::next_camera, page_down, 0, "Page down", "next camera of the file", view},
    {Command::up_axis, 'U', 0, "U", "up axis: +Y, +Z, +X", view},
    {Command::walk, '`', 0, "`", "walk: W A S D, Q E, mouse, Shift; Esc", view},
    {Command::arcball, 'K', 0, "K", "arcball or turntable", view},

    {Command::shading, 'S', 0, "S", "shading frequency", picture},
    {Command::lighting, 'Y', 0, "Y", "lighting model", picture},
    {Command::bump, 'B', 0, "B", "bump technique", picture},
    {Command::channel, 'C', 0, "C, Shift+C", "next, previous data channel", picture},
    {Command::previous_channel, 'C', mod_shift, "", "", picture},
    {Command::samples, 'A', 0, "A", "samples per pixel: 1, 4, 8", picture},
    {Command::tone, 'T', 0, "T", "tone mapping", picture},
    {Command::shadows, 'Q', 0, "Q", "shadows", picture},
    {Command::edges, 'E', 0, "E", "edges of the triangles", picture},
    {Command::wireframe, 'W', 0, "W", "wireframe", picture},
    {Command::points, 'O', 0, "O", "vertices", picture},
    {Command::environment_light, 'I', 0, "I", "light from the environment", picture},
    {Command::environment_background, 'J', 0, "J", "environment as background", picture},
    {Command::brighter, 'L', 0, "L, Shift+L", "lights brighter, darker", picture},
    {Command::darker, 'L', mod_shift, "", "", picture},
    {Command::engine, 'R', 0, "R", "next engine", picture},

    {Command::play, ' ', 0, "Space", "play or pause", motion},
    {Command::next_clip, 'W', mod_shift, "Shift+W", "next clip", motion},
    {Command::previous_clip, 'W', mod_alt, "Alt+W", "previous clip", motion},
    {Command::at_rest, backspace, 0, "Backspace", "no clip: at rest", motion},
    {Command::frame_back, left, mod_shift, "Shift+Left", "1/30 s back", motion},
    {Command::frame_on, right, mod_shift, "Shift+Right", "1/30 s forward", motion},
    {Command::slower, '[', 0, "[, ]", "slower, faster", motion},
    {Command::faster, ']', 0, "", "", motion},
    {Command::loop, 'L', mod_control, "Ctrl+L", "loop", motion},
    {Command::turntable, ' ', mod_shift, "Shift+Space", "turntable", motion},
    {Command::set_key, insert, 0, "Insert", "set a key for camera and lights", motion},
    {Command::delete_key, del, 0, "Del", "delete the key of this moment", motion},

    {Command::grid, 'G', 0, "G", "grid", marks},
    {Command::axes, 'X', 0, "X", "axes", marks},
    {Command::light_glyphs, 'D', 0, "D", "lights; drag their handles", marks},
    {Command::follow_camera, 'D', mod_shift, "Shift+D", "selected light follows the camera", marks},
    {Command::normals, 'N', mod_shift, "Shift+N T B", "normals, tangents, bitangents", marks},
    {Command::tangents, 'T', mod_shift, "", "", marks},
    {Command::bitangents, 'B', mod_shift, "", "", marks},
    {Command::seams, 'V', 0, "V", "seams between parts by angle", marks},

    {Command::panel_view, f1 + 1, 0, "F2 to F8", "view, shading, normals, lights,", window},
    {Command::panel_shading, f1 + 2, 0, " ", "materials, pixel, statistics", window},
    {Command::panel_normals, f1 + 3, 0, "", "", window},
    {Command::panel_lights, f1 + 4, 0, "", "", window},
    {Command::panel_materials, f1 + 5, 0, "", "", window},
    {Command::panel_pixel, f1 + 6, 0, "", "", window},
    {Command::panel_statistics, f1 + 7, 0, "", "", window},
    {Command::panel_statistics, 'M', 0, "M", "statistics", window},
    {Command::panel_motion, 'M', mod_shift, "Shift+M", "motion", window},
    {Command::all_panels, tab, 0, "Tab", "hide or show the panels", window},
    {Command::file_name, 'N', 0, "N", "file name", window},
    {Command::frame_time, 'Z', 0, "Z", "frame time", window},
    {Command::split, '\\', 0, "\\", "split A|B; drag the line", window},
    {Command::second_view, '\\', mod_shift, "Shift+\\", "second view beside the first", window},
    {Command::pick, 'P', 0, "P", "explain a clicked pixel", window},
    {Command::theme, f1 + 9, 0, "F10", "dark or light theme", window},
    {Command::full_screen, f1 + 10, 0, "F11", "full screen", window},
    {Command::help, 'H', 0, "H, ?, F1", "this sheet", window},
    {Command::help, '/', mod_shift, "", "", window},
    {Command::help, f1, 0, "", "", window},
    {Command::leave, escape, 0, "Esc", "leave a mode, cancel a task", window},
};

}  // namespace

Key without_keypad(Key key) {
    if (key >= keypad_0 && key < keypad_0 + 10) return '0' + (key - keypad_0);
    return key == keypad_decimal ? '.' : key;
}

std::span<const Binding> bindings() { return table; }

Command command_of(Key key, int modifiers) {
    const Key plain = without_keypad(key);
    for (const Binding& b : table)
        if (b.key == plain && b.modifiers == modifiers) return b.command;
    return Command::none;
}

std::string key_table_text() {
    const auto cell = [](const std::string& text) {
        std::string out;
        for (const char c : text) out += c == '|' || c == '`' || c == '\\' ? std::string("\\") + c : std::string(1, c);
        return out;
    };
    std::string text, group;
    for (const Binding& b : table) {
        const std::string keys = b.keys;
        if (keys.empty()) continue;
        if (group != b.group) text += (group.empty() ? "" : "\n") + ("| " + std::string(b.group) + " | |\n|---|---|\n");
        group = b.group;
        if (keys == " ") text.erase(text.size() - 3);  // continues with the row above
        text += keys == " " ? " " + cell(b.what) + " |\n" : "| " + cell(keys) + " | " + cell(b.what) + " |\n";
    }
    return text;
}

}  // namespace rakelight::viewer
