// SPDX-License-Identifier: Apache-2.0
// How long the user waits: pauses of the window, the first picture, pictures in motion.
#pragma once
#include <chrono>
#include <cstdint>
#include <string>

#include "../motion/motion_times.h"

namespace rakelight::viewer {

class WindowTimes {
public:
    using Clock = std::chrono::steady_clock;

    /// The window begins to look at events. @param is_loading, is_gl_drawing  what runs beside it
    void begin_turn(bool is_loading, bool is_gl_drawing);
    /// It processes no events from begin_turn() to here.
    void end_turn();
    /// A picture in motion of the first view is requested, by the events of this turn.
    void request(std::uint64_t number) { motion_.asked(number, turn_began_); }
    /// A picture of the first view is on the screen.
    void display(std::uint64_t number);

    double longest_pause_ms() const { return longest_pause_ms_; }
    /// One line to stderr. @param moments  that were played @param gl_pictures  that GlView has drawn
    void print(std::uint64_t moments, std::uint64_t gl_pictures, const std::string& renderer) const;

private:
    Clock::time_point began_ = Clock::now(), turn_began_{};
    bool is_loading_ = false, is_gl_drawing_ = false;  ///< in this turn
    double first_picture_ms_ = 0, longest_pause_ms_ = 0, longest_load_pause_ms_ = 0, longest_gl_pause_ms_ = 0;
    MotionTimes motion_;
};

}  // namespace rakelight::viewer
