// SPDX-License-Identifier: Apache-2.0
#include "app.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "../common/interrupt.h"
#include "document/display_path.h"

namespace rakelight::viewer {
namespace {

constexpr int most_faults = 3;            // of one turn of the loop after another: the window's context may be lost
constexpr double longest_writing_s = 10;  // after the window is closed
constexpr double motion_s = 0.15;         // after the last step of a motion the whole picture is made

std::string wrong_settings(const Remembered& remembered) {
    std::string text = settings_path() + " has lines that are not understood:";
    for (std::size_t i = 0; i < std::min<std::size_t>(5, remembered.wrong_lines.size()); ++i)
        text += "\n" + remembered.wrong_lines[i];
    return text;
}

double seconds(std::chrono::steady_clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

App::App(Start start)
    : start_(std::move(start)),
      remembered_(read_settings()),
      ui_(remembered_.ui),
      files_(start_, GlfwWindow::wake, ui_),
      exports_(start_, GlfwWindow::wake, ui_),
      analysis_(start_, GlfwWindow::wake, ui_) {
    files_.load(false);  // beside the opening of the window
    if (!remembered_.wrong_lines.empty()) ui_.message.fail(wrong_settings(remembered_));
    int width = remembered_.width, height = remembered_.height;
    PictureRequest given;
    for (const WorldValue& value : start_.settings)
        if (value.key == "resolution")
            read_render_keys({&value, 1}, given), width = given.settings.width, height = given.settings.height;
    window_ = std::make_unique<GlfwWindow>("Rakelight", width, height);
    window_->set_theme(ui_.is_dark);
    views_[0].screen = std::make_unique<GlView>();
}

App::~App() {
    cancel_work();
    for (View& view : views_) {  // before their contexts
        view.painter.reset();
        view.gl.reset();
        view.screen.reset();
    }
    lost_gl_.clear();
}

std::vector<const Background*> App::works() const {
    std::vector<const Background*> works{&files_.loader(), &exports_.writer()};
    for (const Background* work : analysis_.works()) works.push_back(work);
    return works;
}

bool App::has_background_work() const { return std::ranges::any_of(works(), &Background::is_running); }

bool App::is_busy() const { return has_background_work() || views_[0].is_painting || views_[1].is_painting; }

int App::run() {
    std::exception_ptr fault;
    try {
        loop();
    } catch (...) {
        fault = std::current_exception();
    }
    finish_writing();
    if (!window_->is_full_screen() && window_->width() > 0)
        remembered_.width = window_->width(), remembered_.height = window_->height();
    remembered_.ui = ui_;
    write_settings(remembered_);
    if (fault) std::rethrow_exception(fault);
    if (start_.wants_stats) times_.print(moments_, gl_pictures_, one_line(views_[0].screen->renderer(), 100));
    return exports_.has_lost_file() ? 1 : 0;
}

void App::loop() {
    int faults = 0;  // one after another
    times_.begin_turn(false, false);
    while (!window_->is_closing() && !is_quitting_ && !apps::CancelOnInterrupt::happened()) try {
            step();
            faults = 0;
        } catch (const Error& error) {
            if (++faults > most_faults) throw;
            window_->abandon_panels();
            ui_.report(error);
        }
}

/// Files that were requested are written, unless that takes long.
void App::finish_writing() {
    const Clock::time_point begin = Clock::now();
    window_->hide();
    files_.cancel();
    analysis_.cancel();
    for (View& view : views_)
        if (view.painter) view.painter->cancel();
    while (exports_.writer().is_running() && seconds(Clock::now() - begin) < longest_writing_s) {
        window_->wait(0.05);
        exports_.poll();
    }
    exports_.give_up();
}

/// Takes what has happened, and shows it.
void App::step() {
    times_.end_turn();
    window_->wait(wait_s());
    times_.begin_turn(files_.loader().is_running(),
                      std::ranges::any_of(views_, [](const View& v) { return v.is_painting && v.gl; }));
    const std::vector<Event> events = window_->take_events();
    if (!events.empty()) ui_.redraw();
    for (const Event& event : events) handle(event);
    for (const Command command : std::exchange(from_panels_, {})) this->command(command);
    poll();
    if (ui_.is_walking) step_walk();
    lay_out();
    play();
    for (std::size_t i = 0; i < view_count(); ++i) submit(views_[i]);
    analysis_.look_for_seams(model_, active().look.request.prepare, drag_ == Drag::none);
    const bool has_progress = plays() ? has_background_work() : is_busy();
    if (has_progress || window_->needs_drawing()) ui_.redraw(1);
    if (ui_.frames_to_draw == 0) return;
    --ui_.frames_to_draw;
    draw();
}

void App::poll() {
    if (const auto arrival = files_.poll()) take_model(*arrival);
    exports_.poll();
    analysis_.poll();
    for (std::size_t i = 0; i < 2; ++i) poll_view(views_[i]);
    if (ui_.message.is_over()) ui_.message.clear(), ui_.redraw();
    if (seconds(Clock::now() - last_watch_) > 0.5) watch_file();
}

void App::poll_view(View& view) {
    if (!view.painter) return;
    view.painter->poll();
    if (auto painting = view.painter->take()) {
        view.displayed = std::move(painting);
        gl_pictures_ += view.displayed->picture != nullptr;
        note_warnings(*view.displayed);
        if (view.displayed->is_final) ui_.redraw();  // what was said of its progress is gone
        ui_.redraw(1);
        if (view.displayed->number == view.number) {
            view.good = view.submitted, view.good_model = view.submitted_model;
            if (view.displayed->is_final || view.is_submitted_moving) view.is_painting = false;
        }
    }
    const auto fault = view.painter->take_fault();
    if (!fault) return;
    if (fault->is_of_gl) return handle_gl_fault(fault->error);
    ui_.report(fault->error);
    if (fault->number != view.number) return;
    ui_.player.is_playing = ui_.player.is_turning = false;
    view.is_painting = false;
    const bool can_go_back = view.good_model == model_ && !(view.good == view.submitted);
    if (can_go_back) view.look = view.good;  // what worked last
}

/// Shows the first of them that was not shown before.
void App::note_warnings(const Painting& painting) {
    for (const std::string& warning : painting.warnings)
        if (ui_.announces && std::ranges::find(warned_, warning) == warned_.end()) {
            warned_.push_back(warning);
            return ui_.say(warning);
        }
}

void App::lay_out() {
    const int panels = int(ui_.panel_width * window_->pixels_a_point());
    const int left = std::min(panels, std::max(0, window_->width() - 1));
    const int width = std::max(1, window_->width() - left), height = std::max(1, window_->height());
    if (window_->width() == 0 || window_->height() == 0) return;  // minimized: as it was
    views_[0].area = views_[1].area = {left, 0, width, height};
    if (ui_.split != Split::beside) return;
    views_[0].area.width = std::max(1, width / 2);
    views_[1].area = {left + views_[0].area.width, 0, std::max(1, width - views_[0].area.width), height};
}

/// Where the camera of a view stands; false: nowhere, and the view is what it was before.
bool App::take_camera(View& view) {
    try {
        const Camera camera = quick_camera_of(view.look, *model_, view.area.width, view.area.height);
        if (view.submitted_model == model_) carry_lights(view.look, view.camera, camera);
        view.camera = camera;
        return true;
    } catch (const Error& error) {
        ui_.report(error);
        if (view.submitted_model == model_)
            view.look = view.submitted;
        else
            view.look.eye.reset(), view.look.request.view = {.side = "default"};
        return false;
    }
}

/// Has a picture made where another one is wanted than the last time.
void App::submit(View& view) {
    if (!model_) return;
    if (ui_.split == Split::wipe) {  // one view of two looks
        const Look& leader = active().look;
        view.look.eye = leader.eye, view.look.world_up = leader.world_up, view.look.request.view = leader.request.view;
        view.look.request.motion = leader.request.motion, view.look.time_s = leader.time_s,
        view.look.keys = leader.keys;
    }
    const bool is_playing = plays();
    const bool is_moving = is_playing || drag_ == Drag::orbit || drag_ == Drag::pan || drag_ == Drag::zoom ||
                           drag_ == Drag::roll || drag_ == Drag::light ||
                           seconds(Clock::now() - last_motion_) < motion_s;
    const bool wants_depth = ui_.normals || ui_.tangents || ui_.bitangents || ui_.seams || ui_.grid;
    const Rectangle &a = view.area, &b = view.submitted_area;
    const bool is_by_gl = is_drawn_by_gl(view.look);  // then lines are in the picture
    Marks wanted_marks = marks(view);
    const bool is_same = view.submitted_model == model_ && view.look == view.submitted && a.width == b.width &&
                         a.height == b.height && view.is_submitted_with_depth == wants_depth &&
                         (!is_by_gl || view.submitted_marks == wanted_marks);
    if (is_same && (is_moving || !view.is_submitted_moving)) return;
    if (!view.painter) view.painter = std::make_unique<Painter>(GlfwWindow::wake, start_.threads, start_.max_memory);
    if (!take_camera(view)) return;
    view.submitted = view.look, view.submitted_model = model_, view.submitted_area = a;
    view.submitted_marks = wanted_marks;
    view.is_submitted_moving = is_moving, view.is_submitted_with_depth = wants_depth, view.is_painting = true;
    if (is_moving && &view == &views_[0]) times_.request(view.number + 1);
    view.painter->paint({.model = model_,
                         .look = view.look,
                         .width = a.width,
                         .height = a.height,
                         .is_moving = is_moving,
                         .is_playing = is_playing,
                         .wants_depth = wants_depth,
                         .number = ++view.number,
                         .gl = is_by_gl ? gl_of(view) : nullptr,
                         .marks = std::move(wanted_marks)});
}

}  // namespace rakelight::viewer
