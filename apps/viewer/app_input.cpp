// SPDX-License-Identifier: Apache-2.0
// What the user does.
#include <algorithm>
#include <cmath>

#include <rakelight/math/linear.h>

#include "app.h"
#include "document/commands.h"
#include "document/feedback.h"

namespace rakelight::viewer {
namespace {

constexpr double turn_of_window_rad = pi;  // by which a drag across the smaller side orbits
constexpr double double_click_s = 0.35;
constexpr double still_px = 4;  // a press that moves less is a click
constexpr std::string_view walking_keys = "WASDQE";
constexpr double walk_share = 0.25, fast = 4;  // of the model's size a second

double seconds(std::chrono::steady_clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

void App::handle(const Event& event) {
    switch (event.kind) {
        case Event::Kind::key_down:
            if (event.is_for_panels) return;
            held_.take(event);
            if (ui_.is_walking &&
                walking_keys.find(char(event.place < 128 ? event.place : 0)) != std::string_view::npos &&
                !(event.modifiers & mod_control))
                return;
            return command(command_of(event.key, event.modifiers, remembered_.own_keys));
        case Event::Kind::key_up:
            return event.key < 0 ? held_.clear() : held_.take(event);
        case Event::Kind::button_down:
            if (!event.is_for_panels) press(event.button, event);
            return;
        case Event::Kind::button_up:
            if (drag_ != Drag::none && std::hypot(event.x - press_x_, event.y - press_y_) < still_px) click(event);
            if (drag_ != Drag::none) last_motion_ = Clock::now() - std::chrono::seconds(1);
            drag_ = Drag::none;
            return;
        case Event::Kind::move:
            return move(event);
        case Event::Kind::scroll:
            if (!event.is_for_panels) zoom(event);
            return;
        case Event::Kind::drop:
            return drop(event);
    }
}

void App::activate_at(double x, double y) {
    if (ui_.split == Split::none) return;
    const bool is_right = ui_.split == Split::beside ? views_[1].area.holds(x, y)
                                                     : x > views_[0].area.x + ui_.wipe * views_[0].area.width;
    ui_.active = is_right ? 1 : 0;
}

void App::press(Button button, const Event& event) {
    last_x_ = press_x_ = event.x, last_y_ = press_y_ = event.y;
    press_modifiers_ = event.modifiers;
    const double line = views_[0].area.x + ui_.wipe * views_[0].area.width;
    if (ui_.split == Split::wipe && button == Button::left &&
        std::fabs(event.x - line) < 8 * double(window_->scale())) {
        drag_ = Drag::wipe;
        return;
    }
    activate_at(event.x, event.y);
    if (button == Button::left && take_light(event.x, event.y)) {
        drag_ = Drag::light;
        return;
    }
    drag_ = ui_.is_walking ? Drag::look : drag_of(button, event.modifiers, ui_.has_blender_mouse);
    if (button == Button::middle) press_modifiers_ |= 1 << 8;  // distinguished from a left click later
}

void App::move(const Event& event) {
    const double dx = event.x - last_x_, dy = event.y - last_y_;
    const dvec2 before{last_x_, last_y_};
    last_x_ = event.x, last_y_ = event.y;
    if (drag_ == Drag::wipe) {
        ui_.wipe = std::clamp((event.x - views_[0].area.x) / views_[0].area.width, 0.0, 1.0);
        return;
    }
    const bool looks = ui_.is_walking && (dx != 0 || dy != 0);
    if (drag_ == Drag::none) hover_light(event.x, event.y, event.is_for_panels);
    if (!model_ || (drag_ == Drag::none && !looks)) return;
    const bool is_click_yet = std::hypot(event.x - press_x_, event.y - press_y_) < still_px;
    if (!looks && is_click_yet) return;
    Look& look = active().look;
    const Rectangle& area = active().area;
    const double side = std::max(1, std::min(area.width, area.height)), angle = turn_of_window_rad / side;
    if (drag_ == Drag::light) return last_motion_ = Clock::now(), move_light(event.x, event.y);
    Eye& eye = moving_eye(look, *model_, area.width, area.height);
    const auto on_ball = [&](dvec2 p) {
        return dvec2{(2 * (p.x - area.x) - area.width) / side, (area.height - 2 * (p.y - area.y)) / side};
    };
    last_motion_ = Clock::now();
    if (looks) return viewer::look(eye, dx * angle, -dy * angle, look.world_up);
    switch (drag_) {
        case Drag::orbit:
            return ui_.is_arcball ? turn_ball(eye, on_ball(before), on_ball({event.x, event.y}))
                                  : turn_table(eye, dx * angle, dy * angle, look.world_up);
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

void App::zoom(const Event& event) {
    if (!model_ || event.y == 0) return;
    activate_at(last_x_, last_y_);
    const Rectangle& area = active().area;
    dolly(moving_eye(active().look, *model_, area.width, area.height),
          std::exp(-0.15 * std::clamp(event.y, -20.0, 20.0)));
    last_motion_ = Clock::now();
}

bool App::is_stepping() const {
    return std::ranges::any_of(walking_keys, [this](char key) { return held_.has(key); });
}

void App::step_walk() {
    const auto now = Clock::now();
    const double dt = is_walk_step_ ? std::min(0.1, seconds(now - last_step_)) : 0;
    last_step_ = now, is_walk_step_ = is_stepping();
    if (!model_ || !is_walk_step_) return;
    const auto axis = [this](Key more, Key less) { return double(held_.has(more)) - double(held_.has(less)); };
    const double ahead = axis('W', 'S'), right = axis('D', 'A'), up = axis('E', 'Q');
    Look& look = active().look;
    const double step = dt * walk_share * model_->box.bounds().diagonal() * (held_.is_fast() ? fast : 1);
    walk(moving_eye(look, *model_, active().area.width, active().area.height), ahead * step, right * step, up * step,
         look.world_up);
    last_motion_ = now;
}

void App::click(const Event& event) {
    View& view = active();
    if (!model_ || !view.painter || !view.area.holds(event.x, event.y) || ui_.is_walking) return;
    const int x = int(event.x) - view.area.x, y = int(event.y) - view.area.y;
    const auto now = Clock::now();
    const bool is_near = std::hypot(event.x - last_click_x_, event.y - last_click_y_) < 2 * still_px;
    const bool is_double = is_near && seconds(now - last_click_) < double_click_s;
    const bool is_middle = press_modifiers_ & (1 << 8);
    last_click_ = now, last_click_x_ = event.x, last_click_y_ = event.y;
    if (ui_.is_picking && event.button == Button::left)
        return analysis_.explain(model_, view.look, view.area.width, view.area.height, x, y);
    if (event.button == Button::left && (press_modifiers_ & mod_alt))
        return view.painter->look_at_pixel(x, y, [this, &view, model = model_](std::optional<Painter::Hit> hit) {
            if (model != model_) return;
            if (!hit || hit->material == no_index) return ui_.say("there is no surface at this pixel");
            ui_.material = source_material(model_->scene, view.look.materials, hit->material);
            ui_.object = hit->object;
            ui_.open[std::size_t(Panel::materials)] = true, ui_.are_panels_hidden = false;
            ui_.redraw();
        });
    if (!is_middle && !(event.button == Button::left && is_double)) return;
    view.painter->look_at_pixel(x, y, [this, &view, model = model_](std::optional<Painter::Hit> hit) {
        if (!hit || model != model_) return;
        center_on(moving_eye(view.look, *model_, view.area.width, view.area.height), hit->position);
    });
}

void App::leave() {
    if (window_->close_lists()) return;
    if (ui_.is_walking) return ui_.is_walking = false, window_->catch_pointer(false);
    if (ui_.is_picking) return void(ui_.is_picking = false);
    if (ui_.help) return void(ui_.help = false);
    if (has_background_work()) return cancel_work();
    for (View& view : views_)
        if (view.painter && view.is_painting && !to_text(view.painter->progress(), "render").empty())
            view.painter->cancel();
    if (!ui_.message.text().empty()) return ui_.message.clear();
    if (window_->is_full_screen()) window_->set_full_screen(false);
}

void App::command(Command command) {
    ui_.redraw();
    if (viewer::apply(command, ui_)) {
        window_->set_theme(ui_.is_dark);
        if (command == Command::walk) window_->catch_pointer(ui_.is_walking), last_step_ = Clock::now();
        const bool begins_split =
            (command == Command::split || command == Command::second_view) && ui_.split != Split::none;
        const std::shared_ptr<const Model>& other = views_[1].submitted_model;
        if (begins_split && !(other && model_ && other->file == model_->file)) views_[1].look = views_[0].look;
        if (ui_.split == Split::none) ui_.active = 0;
        return;
    }
    View& view = active();
    try {
        if (model_ && viewer::apply(command, ui_.player, view.look, *model_, view.area.width, view.area.height)) {
            return ui_.announces ? ui_.say(effect_of(command, ui_.player, view.look, *model_)) : void();
        }
        if (model_ && viewer::apply(command, view.look, *model_, view.area.width, view.area.height)) {
            const std::string effect = ui_.announces ? effect_of(command, view.look, *model_) : std::string();
            return effect.empty() ? void() : ui_.say(effect);
        }
    } catch (const Error& error) {
        return ui_.report(error);
    }
    switch (command) {
        case Command::next_file:
            return files_.step(1);
        case Command::previous_file:
            return files_.step(-1);
        case Command::reload:
            return files_.load(true);
        case Command::screenshot:
            return model_ ? exports_.write_picture(shown(), false) : void();
        case Command::clean_screenshot:
            return model_ ? exports_.write_picture(shown(), true) : void();
        case Command::save_world:
            return model_ ? exports_.save_scene(shown()) : void();
        case Command::save_seamless:
            return model_ ? exports_.save_seamless(shown()) : void();
        case Command::record:
            return model_ ? exports_.record(shown()) : void();
        case Command::copy_command_line:
        case Command::follow_camera:
        case Command::quit:
        case Command::full_screen:
        case Command::leave:
            break;
        default:
            return;
    }
    if (command == Command::quit) is_quitting_ = true;
    if (command == Command::full_screen) window_->set_full_screen(!window_->is_full_screen());
    if (command == Command::leave) leave();
    if (command == Command::copy_command_line) copy_command_line();
    if (command == Command::follow_camera) follow_camera();
}

}  // namespace rakelight::viewer
