// SPDX-License-Identifier: Apache-2.0
// How the pointer and held keys move what is seen: cameras, lights, the line between two pictures.
#pragma once
#include <chrono>
#include <optional>

#include "../view/light_handles.h"
#include "../view/pictures.h"
#include "input.h"

namespace rakelight::viewer {

/// A press and a release at one place of the active picture.
struct Click {
    int x = 0, y = 0;                                      ///< [px] of the picture
    Button button = Button::none, pressed = Button::none;  ///< that was released; that was pressed last
    int modifiers = 0;                                     ///< of the press
    bool is_double = false;
};

/// `scale` is that of the display.
class Navigation {
public:
    Navigation(Pictures& pictures, UiState& ui) : pictures_(pictures), ui_(ui), lights_(pictures, ui) {}

    /// @return the key walks: it is no command
    bool take_key(const Event& event);
    void release_key(const Event& event);
    void press(const Event& event, double scale);
    void move(const Event& event, double scale);
    /// Ends a drag. @return it was none but a click
    std::optional<Click> release(const Event& event);
    void zoom(const Event& event);
    /// Time for walking begins.
    void begin_walk() { last_step_ = Clock::now(); }
    /// Walks as far as keys were held since the last step.
    void step_walk();

    bool holds_walking_key() const;  ///< a key that walks is held
    bool is_dragging() const { return drag_ != Drag::none; }
    bool moves_picture() const;  ///< a coarse picture is enough now
    /// The handle of a light that is highlighted.
    Handle highlighted() const { return drag_ == Drag::light ? lights_.taken() : lights_.hovered(); }

private:
    using Clock = std::chrono::steady_clock;
    void drag_eye(Eye& eye, const Event& event, dvec2 from);
    bool is_still(const Event& event) const;

    Pictures& pictures_;
    UiState& ui_;
    LightHandles lights_;
    HeldKeys held_;
    Drag drag_ = Drag::none;
    dvec2 pointer_{}, pressed_at_{}, clicked_at_{};
    Button pressed_ = Button::none;
    int press_modifiers_ = 0;
    bool is_walk_step_ = false;  ///< the last step has a beginning
    Clock::time_point last_click_{}, last_motion_{}, last_step_{};
};

}  // namespace rakelight::viewer
