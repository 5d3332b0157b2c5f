// SPDX-License-Identifier: Apache-2.0
#include "window_times.h"

#include <algorithm>
#include <cstdio>

namespace rakelight::viewer {
namespace {

double milliseconds(WindowTimes::Clock::duration d) { return std::chrono::duration<double, std::milli>(d).count(); }

}  // namespace

void WindowTimes::begin_turn(bool is_loading, bool is_gl_drawing) {
    turn_began_ = Clock::now();
    is_loading_ = is_loading, is_gl_drawing_ = is_gl_drawing;
}

void WindowTimes::end_turn() {
    const double pause_ms = milliseconds(Clock::now() - turn_began_);
    longest_pause_ms_ = std::max(longest_pause_ms_, pause_ms);
    if (is_loading_) longest_load_pause_ms_ = std::max(longest_load_pause_ms_, pause_ms);
    if (is_gl_drawing_) longest_gl_pause_ms_ = std::max(longest_gl_pause_ms_, pause_ms);
}

void WindowTimes::display(std::uint64_t number) {
    motion_.displayed(number, Clock::now());
    if (first_picture_ms_ == 0) first_picture_ms_ = milliseconds(Clock::now() - began_);
}

void WindowTimes::print(std::uint64_t moments, std::uint64_t gl_pictures, const std::string& renderer) const {
    std::fprintf(
        stderr,
        "first picture after %.0f ms, longest pause of the window %.0f ms (while loading %.0f ms, while gl "
        "draws %.0f ms), %zu pictures in motion after %.0f ms (median; at most %.0f ms), %llu moments played, %llu "
        "pictures by GlView, %s\n",
        first_picture_ms_, longest_pause_ms_, longest_load_pause_ms_, longest_gl_pause_ms_, motion_.count(),
        motion_.quantile_ms(0.5), motion_.quantile_ms(1), static_cast<unsigned long long>(moments),
        static_cast<unsigned long long>(gl_pictures), renderer.c_str());
}

}  // namespace rakelight::viewer
