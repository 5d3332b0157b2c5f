// SPDX-License-Identifier: Apache-2.0
// What the window's user does, one after another: a queue of our own, since Dear ImGui 1.86 loses keys that are pressed and
// released within one of its frames.
#pragma once
#include <string>
#include <vector>

#include "../document/keys.h"

namespace rakelight::viewer {

enum class Button : int { left = 0, right = 1, middle = 2, none = -1 };

struct Event {
    enum class Kind { key_down, key_up, button_down, button_up, move, scroll, drop };
    Kind kind{};
    Key key = 0;        ///< by its letter or sign on the keyboard as it is laid out
    Key place = 0;      ///< the key that is there on a keyboard of the USA
    int modifiers = 0;  ///< Modifier bits
    Button button = Button::none;
    double x = 0, y = 0;  ///< [px] of the framebuffer, y down; of scroll: how far
    std::vector<std::string> files{};
    bool is_for_panels = false;  ///< it happened over a panel, or a text field has the keyboard
};

/// The action of the pointer while a button is down.
enum class Drag { none, orbit, pan, zoom, roll, look, wipe, light };

/// F3D's buttons: left orbits, with Shift pans, with Control rolls; middle pans, right zooms. Blender's: middle orbits, with Shift
/// pans, with Control zooms; the others as before.
Drag drag_of(Button button, int modifiers, bool is_blender = false);

/// Keys that are held down, by their place, for walking.
class HeldKeys {
public:
    void take(const Event& event);
    bool has(Key key) const;
    void clear() { keys_.clear(); }
    bool is_fast() const { return has(key_left_shift) || has(key_right_shift); }

private:
    std::vector<Key> keys_;
};

}  // namespace rakelight::viewer
