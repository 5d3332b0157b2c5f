// SPDX-License-Identifier: Apache-2.0
#include "navigation.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <rakelight/math/linear.h>

namespace rakelight::viewer {
namespace {

constexpr double turn_of_window_rad = pi;  // by which a drag across the smaller side orbits
constexpr double double_click_s = 0.35;
constexpr double still_px = 4;                 // a press that moves less is a click
constexpr double line_px = 8;                  // beside the line between two pictures, where a press takes it
constexpr double motion_s = 0.15;              // after the last step of a motion the whole picture is made
constexpr double walk_share = 0.25, fast = 4;  // of the model's size a second
constexpr std::string_view walking_keys = "WASDQE";

double seconds(std::chrono::steady_clock::duration d) { return std::chrono::duration<double>(d).count(); }

double distance(const Event& event, dvec2 from) { return std::hypot(event.x - from.x, event.y - from.y); }

}  // namespace

bool Navigation::take_key(const Event& event) {
    held_.take(event);
    const bool walks = walking_keys.find(char(event.place < 128 ? event.place : 0)) != std::string_view::npos;
    return ui_.is_walking && walks && !(event.modifiers & mod_control);
}

void Navigation::release_key(const Event& event) { event.key < 0 ? held_.clear() : held_.take(event); }

bool Navigation::is_still(const Event& event) const { return distance(event, pressed_at_) < still_px; }

void Navigation::press(const Event& event, double scale) {
    pointer_ = pressed_at_ = {event.x, event.y};
    press_modifiers_ = event.modifiers, pressed_ = event.button;
    const PixelBox& area = pictures_[0].area;
    const double line = area.x + ui_.wipe * area.width;
    if (ui_.split == Split::wipe && event.button == Button::left && std::fabs(event.x - line) < line_px * scale) {
        drag_ = Drag::wipe;
        return;
    }
    pictures_.activate_at(event.x, event.y);
    if (event.button == Button::left && lights_.take({event.x, event.y}, scale)) {
        drag_ = Drag::light;
        return;
    }
    drag_ = ui_.is_walking ? Drag::look : drag_of(event.button, event.modifiers, ui_.has_blender_mouse);
}

void Navigation::move(const Event& event, double scale) {
    const dvec2 from = pointer_, to{event.x, event.y};
    pointer_ = to;
    if (drag_ == Drag::wipe) {
        const PixelBox& area = pictures_[0].area;
        ui_.wipe = std::clamp((event.x - area.x) / area.width, 0.0, 1.0);
        return;
    }
    const bool looks = ui_.is_walking && (to.x != from.x || to.y != from.y);
    if (drag_ == Drag::none) lights_.hover(event.is_for_panels ? std::nullopt : std::optional(to), scale);
    if (!pictures_.model() || (drag_ == Drag::none && !looks)) return;
    if (!looks && is_still(event)) return;
    if (drag_ == Drag::light) return last_motion_ = Clock::now(), lights_.move(to, scale);
    PictureView& view = pictures_.active();
    Eye& eye = moving_eye(view.look, *pictures_.model(), view.area.width, view.area.height);
    last_motion_ = Clock::now();
    drag_eye(eye, event, from);
}

void Navigation::drag_eye(Eye& eye, const Event& event, dvec2 from) {
    const PictureView& view = pictures_.active();
    const PixelBox& area = view.area;
    const dvec3 world_up = view.look.world_up;
    const double dx = event.x - from.x, dy = event.y - from.y;
    const double side = std::max(1, std::min(area.width, area.height)), angle = turn_of_window_rad / side;
    const auto on_ball = [&](dvec2 p) {
        return dvec2{(2 * (p.x - area.x) - area.width) / side, (area.height - 2 * (p.y - area.y)) / side};
    };
    if (ui_.is_walking && (dx != 0 || dy != 0)) return look(eye, dx * angle, -dy * angle, world_up);
    switch (drag_) {
        case Drag::orbit:
            return ui_.is_arcball ? turn_ball(eye, on_ball(from), on_ball({event.x, event.y}))
                                  : turn_table(eye, dx * angle, dy * angle, world_up);
        case Drag::pan:
            return pan(eye, dx, dy, area.height);
        case Drag::zoom:
            return dolly(eye, std::exp(dy * 3 / side));
        case Drag::roll:
            return roll(eye, dx * angle);
        default:
            return;
    }
}

std::optional<Click> Navigation::release(const Event& event) {
    const Drag ended = std::exchange(drag_, Drag::none);
    if (ended == Drag::none) return {};
    last_motion_ = Clock::now() - std::chrono::seconds(1);
    const PictureView& view = pictures_.active();
    const bool is_on_picture = pictures_.model() && view.is_open() && view.area.holds(event.x, event.y);
    if (!is_still(event) || !is_on_picture || ui_.is_walking) return {};
    const auto now = Clock::now();
    const bool is_double = distance(event, clicked_at_) < 2 * still_px && seconds(now - last_click_) < double_click_s;
    last_click_ = now, clicked_at_ = {event.x, event.y};
    return Click{
        int(event.x) - view.area.x, int(event.y) - view.area.y, event.button, pressed_, press_modifiers_, is_double};
}

void Navigation::zoom(const Event& event) {
    if (!pictures_.model() || event.y == 0) return;
    pictures_.activate_at(pointer_.x, pointer_.y);
    PictureView& view = pictures_.active();
    dolly(moving_eye(view.look, *pictures_.model(), view.area.width, view.area.height),
          std::exp(-0.15 * std::clamp(event.y, -20.0, 20.0)));
    last_motion_ = Clock::now();
}

bool Navigation::holds_walking_key() const {
    return std::ranges::any_of(walking_keys, [this](char key) { return held_.has(key); });
}

void Navigation::step_walk() {
    const auto now = Clock::now();
    const double dt = is_walk_step_ ? std::min(0.1, seconds(now - last_step_)) : 0;
    last_step_ = now, is_walk_step_ = holds_walking_key();
    if (!pictures_.model() || !is_walk_step_) return;
    const auto axis = [this](Key more, Key less) { return double(held_.has(more)) - double(held_.has(less)); };
    const double ahead = axis('W', 'S'), right = axis('D', 'A'), up = axis('E', 'Q');
    PictureView& view = pictures_.active();
    const Model& model = *pictures_.model();
    const double step = dt * walk_share * model.box.bounds().diagonal() * (held_.is_fast() ? fast : 1);
    walk(moving_eye(view.look, model, view.area.width, view.area.height), ahead * step, right * step, up * step,
         view.look.world_up);
    last_motion_ = now;
}

bool Navigation::moves_picture() const {
    const bool is_drag_seen = drag_ == Drag::orbit || drag_ == Drag::pan || drag_ == Drag::zoom ||
                              drag_ == Drag::roll || drag_ == Drag::light;
    return is_drag_seen || seconds(Clock::now() - last_motion_) < motion_s;
}

}  // namespace rakelight::viewer
