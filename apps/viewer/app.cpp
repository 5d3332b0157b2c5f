// SPDX-License-Identifier: Apache-2.0
#include "app.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <rakelight/world/render_keys.h>

#include "../common/interrupt.h"
#include "panels/floating_windows.h"
#include "view/drop.h"
#include "view/pick.h"

namespace rakelight::viewer {
namespace {

constexpr int most_faults = 3;            // of one turn of the loop after another: the window's context may be lost
constexpr double longest_writing_s = 10;  // after the window is closed
constexpr double watch_s = 0.5;           // from one look at the files to the next

double seconds(std::chrono::steady_clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

App::App(const Start& start)
    : wants_stats_(start.wants_stats),
      remembered_(read_settings()),
      ui_(remembered_.ui),
      files_(start, GlfwWindow::wake, ui_),
      exports_(start, GlfwWindow::wake, ui_),
      analysis_(start, GlfwWindow::wake, ui_),
      pictures_(
          start, GlfwWindow::wake, [this] { return window_->make_shared_context(); }, ui_),
      navigation_(pictures_, ui_) {
    files_.load(false);  // beside the opening of the window
    if (!remembered_.wrong_lines.empty()) ui_.message.fail(wrong_lines_text(remembered_));
    open_window(start);
}

void App::open_window(const Start& start) {
    int width = remembered_.width, height = remembered_.height;
    PictureRequest given;
    for (const WorldValue& value : start.settings)
        if (value.key == "resolution")
            read_render_keys({&value, 1}, given), width = given.settings.width, height = given.settings.height;
    window_ = std::make_unique<GlfwWindow>("Rakelight", width, height);
    window_->set_theme(ui_.is_dark);
    screen_ = std::make_unique<Screen>(*window_);
}

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
    if (wants_stats_) times_.print(pictures_.moments(), pictures_.gl_pictures(), one_line(screen_->renderer(), 100));
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
    pictures_.cancel();
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
    times_.begin_turn(files_.loader().is_running(), pictures_.is_gl_drawing());
    const std::vector<Event> events = window_->take_events();
    if (!events.empty()) ui_.redraw();
    for (const Event& event : events) handle(event);
    for (const Command command : std::exchange(from_panels_, {})) execute(command);
    poll();
    if (ui_.is_walking) navigation_.step_walk();
    pictures_.lay_out(window_->width(), window_->height(), int(ui_.panel_width * window_->pixels_a_point()));
    pictures_.play();
    request_pictures();
    analysis_.look_for_seams(pictures_.model(), pictures_.active().look.request.prepare, !navigation_.is_dragging());
    const bool has_progress = has_background_work() || (pictures_.is_painting() && !pictures_.plays());
    if (has_progress || window_->needs_drawing()) ui_.redraw(1);
    if (ui_.frames_to_draw == 0) return;
    --ui_.frames_to_draw;
    draw();
}

/// [s] How long the window may sleep; painters wake it.
double App::wait_s() const {
    if (ui_.frames_to_draw > 0 || (ui_.is_walking && navigation_.holds_walking_key())) return 0;
    if (pictures_.plays()) return pictures_.next_moment_s();
    return has_background_work() || pictures_.is_painting() ? 0.1 : 0.25;
}

void App::poll() {
    if (const auto arrival = files_.poll()) show(*arrival);
    exports_.poll();
    analysis_.poll();
    pictures_.poll();
    if (ui_.message.is_over()) ui_.message.clear(), ui_.redraw();
    if (seconds(Clock::now() - last_watch_) <= watch_s) return;
    last_watch_ = Clock::now();
    pictures_.read_changed_shaders();
    for (const PictureView& view : pictures_.all()) files_.watch(files_of(view.look));
    files_.reload_changed();
}

/// Shows a model that has been loaded.
void App::show(const ModelFiles::Arrival& arrival) {
    analysis_.forget_seams();
    pictures_.show(files_.model(), arrival.keeps_look);
    const std::string name = std::filesystem::path(files_.model()->file).filename().string();
    window_->set_title(one_line(name, 100) + " - Rakelight (H: keys)");
}

void App::request_pictures() {
    const bool is_playing = pictures_.plays(), is_moving = is_playing || navigation_.moves_picture();
    for (std::size_t i = 0; i < pictures_.count(); ++i) {
        const Demand demand{.is_moving = is_moving, .is_playing = is_playing, .marks = marks(i)};
        const bool is_new = pictures_.request(i, demand, screen_->has_gpu());
        if (is_new && is_moving && i == 0) times_.request(pictures_[0].number());
    }
}

/// The lines that are wanted over a picture.
Marks App::marks(std::size_t picture) const {
    const bool has_handles = ui_.light_glyphs && picture == ui_.active;
    const PrepareOptions& prepare = pictures_[picture].look.request.prepare;
    return {.grid = ui_.grid,
            .axes = ui_.axes,
            .lights = ui_.light_glyphs,
            .vectors = {ui_.normals, ui_.tangents, ui_.bitangents},
            .seams = ui_.seams ? analysis_.seams(pictures_.model(), prepare) : nullptr,
            .light = ui_.light,
            .has_handles = has_handles,
            .lit = has_handles ? navigation_.highlighted() : Handle::none,
            .scale = double(window_->scale())};
}

void App::handle(const Event& event) {
    const double scale = double(window_->scale());
    switch (event.kind) {
        case Event::Kind::key_down:
            if (event.is_for_panels || navigation_.take_key(event)) return;
            return execute(command_of(event.key, event.modifiers, remembered_.own_keys));
        case Event::Kind::key_up:
            return navigation_.release_key(event);
        case Event::Kind::button_down:
            return event.is_for_panels ? void() : navigation_.press(event, scale);
        case Event::Kind::button_up:
            if (const auto ended = navigation_.release(event)) click(*ended);
            return;
        case Event::Kind::move:
            return navigation_.move(event, scale);
        case Event::Kind::scroll:
            return event.is_for_panels ? void() : navigation_.zoom(event);
        case Event::Kind::drop:
            return drop(event);
    }
}

void App::click(const Click& click) {
    const PictureView& view = pictures_.active();
    const bool is_left = click.button == Button::left;
    if (ui_.is_picking && is_left)
        return analysis_.explain(pictures_.model(), view.look, view.area.width, view.area.height, click.x, click.y);
    if (is_left && (click.modifiers & mod_alt)) return select_material_at(click.x, click.y, pictures_, ui_);
    if (click.pressed == Button::middle || (is_left && click.is_double)) center_at(click.x, click.y, pictures_);
}

void App::drop(const Event& event) {
    const DropPlan plan = plan_of_drop(event.files, event.modifiers & mod_shift);
    if (plan.is_empty_folder) return ui_.say("there is no model in this folder");
    if (!plan.models.empty()) return files_.open_dropped(plan.models, event.modifiers & mod_control);
    if (!pictures_.model()) return ui_.say("drop a model first: pictures are for what is shown");
    use_pictures(plan, event.x, event.y, pictures_, ui_);
}

void App::execute(Command command) {
    ui_.redraw();
    if (apply(command, ui_)) return adapt_window(command);
    if (pictures_.model() && pictures_.change_look(command)) return;
    switch (command) {
        case Command::next_file:
            return files_.step(1);
        case Command::previous_file:
            return files_.step(-1);
        case Command::reload:
            return files_.load(true);
        case Command::quit:
            is_quitting_ = true;
            return;
        case Command::full_screen:
            return window_->set_full_screen(!window_->is_full_screen());
        case Command::leave:
            return leave();
        default:
            return pictures_.model() ? export_as(command) : void();
    }
}

/// Adapts the window to a change of its state.
void App::adapt_window(Command command) {
    window_->set_theme(ui_.is_dark);
    if (command == Command::walk) window_->catch_pointer(ui_.is_walking), navigation_.begin_walk();
    if ((command == Command::split || command == Command::second_view) && ui_.split != Split::none)
        pictures_.begin_split();
    if (ui_.split == Split::none) ui_.active = 0;
}

/// Commands that need a model and do not change its look.
void App::export_as(Command command) {
    switch (command) {
        case Command::screenshot:
            return exports_.write_picture(shown(), false);
        case Command::clean_screenshot:
            return exports_.write_picture(shown(), true);
        case Command::save_world:
            return exports_.save_scene(shown());
        case Command::save_seamless:
            return exports_.save_seamless(shown());
        case Command::record:
            return exports_.record(shown());
        case Command::copy_command_line:
            if (const auto line = exports_.command_line(shown())) window_->set_clipboard(*line);
            return;
        default:
            return;
    }
}

Shown App::shown() const {
    const PictureView& view = pictures_.active();
    return {pictures_.model(), view.look, view.area.width, view.area.height};
}

/// Ends the innermost of what can be ended.
void App::leave() {
    if (window_->close_lists()) return;
    if (ui_.is_walking) return ui_.is_walking = false, window_->catch_pointer(false);
    if (ui_.is_picking) return void(ui_.is_picking = false);
    if (ui_.help) return void(ui_.help = false);
    if (has_background_work()) {
        exports_.cancel();
        files_.cancel();
        return analysis_.cancel();
    }
    pictures_.cancel_preparation();
    if (!ui_.message.text().empty()) return ui_.message.clear();
    if (window_->is_full_screen()) window_->set_full_screen(false);
}

std::vector<const Background*> App::works() const {
    std::vector<const Background*> works{&files_.loader(), &exports_.writer()};
    for (const Background* work : analysis_.works()) works.push_back(work);
    return works;
}

bool App::has_background_work() const { return std::ranges::any_of(works(), &Background::is_running); }

/// The works that run, for people.
std::vector<std::string> App::work_texts() const {
    std::vector<std::string> texts;
    for (const Background* work : works())
        if (const std::string text = to_text(work->progress()); work->is_running() && !text.empty())
            texts.push_back(text);
    if (const std::size_t waiting = exports_.writer().waiting(); waiting > 0 && !texts.empty())
        texts.back() += ", " + std::to_string(waiting) + " more to be written";
    for (const PictureView& view : pictures_.all())
        if (const std::string text = view.preparation(); !text.empty()) texts.push_back(text);
    return texts;
}

void App::draw() {
    if (window_->width() == 0 || window_->height() == 0) return;
    window_->set_viewport(0, 0, 0, 0);
    window_->clear();
    window_->begin_panels();
    const Marks all_marks[] = {marks(0), marks(1)};
    screen_->draw(pictures_, ui_, all_marks);
    draw_panels_over();
    window_->end_panels();
    for (const PictureView& view : pictures_.all().first(pictures_.count()))
        if (view.displayed() && view.displayed()->picture) mark_as_displayed(*view.displayed()->picture);
    window_->swap();
    if (const auto& first = pictures_[0].displayed()) times_.display(first->number);
}

void App::draw_panels_over() {
    PictureView& view = pictures_.active();
    PanelView panels{
        .model = pictures_.model().get(), .look = view.look, .ui = ui_, .painting = view.displayed().get()};
    panels.width = view.area.width, panels.height = view.area.height;
    const float pixels_a_point = window_->pixels_a_point();
    panels.window_width = std::max(1, int(float(window_->width()) / pixels_a_point));
    panels.window_height = std::max(1, int(float(window_->height()) / pixels_a_point));
    panels.scale = window_->scale() / pixels_a_point, panels.longest_block_ms = times_.longest_pause_ms();
    panels.own_keys = remembered_.own_keys;
    panels.file_number = files_.number(), panels.file_count = files_.count();
    panels.seams = analysis_.seams(pictures_.model()).get();  // Analysis has them, too
    panels.works = work_texts();
    draw_panels(panels);
    draw_status(panels);
    draw_help(panels);
    from_panels_ = std::move(panels.commands);
    if (!from_panels_.empty()) ui_.redraw();
}

}  // namespace rakelight::viewer
