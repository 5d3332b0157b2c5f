// SPDX-License-Identifier: Apache-2.0
#include "input.h"

#include <algorithm>

namespace rakelight::viewer {

Drag drag_of(Button button, int modifiers, bool is_blender) {
    if (button == Button::middle && is_blender)
        return modifiers & mod_shift ? Drag::pan : modifiers & mod_control ? Drag::zoom : Drag::orbit;
    if (button == Button::middle) return Drag::pan;
    if (button == Button::right) return Drag::zoom;
    if (button != Button::left) return Drag::none;
    if (modifiers & mod_shift) return Drag::pan;
    return modifiers & mod_control ? Drag::roll : Drag::orbit;
}

void HeldKeys::take(const Event& event) {
    std::erase(keys_, event.place);
    if (event.kind == Event::Kind::key_down) keys_.push_back(event.place);
}

bool HeldKeys::has(Key key) const { return std::ranges::find(keys_, key) != keys_.end(); }

}  // namespace rakelight::viewer
