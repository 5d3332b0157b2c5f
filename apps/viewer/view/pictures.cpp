// SPDX-License-Identifier: Apache-2.0
#include "pictures.h"

#include <algorithm>

#include <rakelight_internal/base/text.h>

#include "../document/commands.h"
#include "../document/feedback.h"
#include "../document/materials.h"

namespace rakelight::viewer {
namespace {

constexpr double shortest_s = 1.0 / 60;  // from one moment to the next

/// Empty: there are none but notes.
std::string count_of_remarks(const Model& model) {
    std::size_t count = 0;
    for (const ReportEntry& entry : model.remarks) count += entry.remark != Remark::note;
    if (count == 0) return {};
    return counted(count, "remark") + " about the file: see the panel Statistics (F8)";
}

double seconds(Pictures::Clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

Pictures::Pictures(const Start& start, std::function<void()> wake, GlPainters::MakeContext make_context, UiState& ui)
    : ui_(ui),
      wake_(std::move(wake)),
      threads_(start.threads),
      max_memory_(start.max_memory),
      gl_(std::move(make_context)) {}

void Pictures::show(const std::shared_ptr<const Model>& model, bool keeps_looks) {
    const std::string lost = keeps_looks ? carry_edits_to(*model) : std::string();
    model_ = model;
    warned_.clear();
    ui_.objects_are_of = no_index;
    if (!keeps_looks) {
        for (PictureView& view : views_) view.look = first_look(*model);
        ui_.light = ui_.material = 0, ui_.object = no_index;
        ui_.explained.clear();
    }
    take_motion(keeps_looks);
    const std::string remarks = count_of_remarks(*model);
    const std::string news = lost + (lost.empty() || remarks.empty() ? "" : "\n") + remarks;
    if (!news.empty()) ui_.say(news);
    ui_.redraw();
}

/// Adapts all that refers to objects by their numbers to the file as it is now. @return a message for people; empty:
/// none
std::string Pictures::carry_edits_to(const Model& model) {
    std::vector<std::string> gone;
    for (PictureView& view : views_)
        for (const std::string& title : carry_edits(view.look.materials, model_->scene, model.scene))
            if (std::ranges::find(gone, title) == gone.end()) gone.push_back(title);
    ui_.object = same_object(model_->scene, ui_.object, model.scene);
    if (gone.empty()) return {};
    std::string text = "no longer in the file; changes of their materials are dropped: " + gone[0];
    for (std::size_t i = 1; i < std::min<std::size_t>(gone.size(), 5); ++i) text += ", " + gone[i];
    return gone.size() > 5 ? text + ", ..." : text;
}

/// Sets up the playback of a model that has just been loaded.
void Pictures::take_motion(bool keeps_looks) {
    if (!keeps_looks) {
        ui_.player.is_playing = model_->request.motion.autoplay;
        ui_.player.is_turning = false;
        return;
    }
    for (PictureView& view : views_) try {
            clips_of(view.look, *model_);
        } catch (const Error&) {  // the file has lost the clip
            choose_clip(view.look, {});
        }
}

void Pictures::lay_out(int window_width, int window_height, int left) {
    left = std::min(left, std::max(0, window_width - 1));
    const int width = std::max(1, window_width - left), height = std::max(1, window_height);
    if (window_width == 0 || window_height == 0) return;  // minimized: as it was
    views_[0].area = views_[1].area = {left, 0, width, height};
    if (ui_.split != Split::beside) return;
    views_[0].area.width = std::max(1, width / 2);
    views_[1].area = {left + views_[0].area.width, 0, std::max(1, width - views_[0].area.width), height};
}

void Pictures::activate_at(double x, double y) {
    if (ui_.split == Split::none) return;
    const bool is_right = ui_.split == Split::beside ? views_[1].area.holds(x, y)
                                                     : x > views_[0].area.x + ui_.wipe * views_[0].area.width;
    ui_.active = is_right ? 1 : 0;
}

void Pictures::begin_split() {
    const std::shared_ptr<const Model>& other = views_[1].requested_model();
    if (!(other && model_ && other->file == model_->file)) views_[1].look = views_[0].look;
}

bool Pictures::change_look(Command command) {
    PictureView& view = active();
    const Model& model = *model_;
    const int width = view.area.width, height = view.area.height;
    try {
        if (apply(command, ui_.player, view.look, model, width, height)) {
            if (ui_.announces) ui_.say(effect_of(command, ui_.player, view.look, model));
            return true;
        }
        if (command == Command::follow_camera) {
            ui_.say(toggle_follows_camera(view.look, model, width, height, ui_.light));
            return true;
        }
        if (!apply(command, view.look, model, width, height)) return false;
        const std::string effect = ui_.announces ? effect_of(command, view.look, model) : std::string();
        if (!effect.empty()) ui_.say(effect);
    } catch (const Error& error) {
        ui_.report(error);
    }
    return true;
}

void Pictures::read_changed_shaders() {
    try {
        const RenderSettings seen = active().look.request.settings;
        const std::optional<ShaderFiles::Texts> texts = shader_files_.changed(seen);
        if (!texts) return;
        for (PictureView& view : views_) {
            RenderSettings& s = view.look.request.settings;
            if (s.lighting_name == seen.lighting_name) s.lighting_text = texts->lighting;
            if (s.vertex_name == seen.vertex_name) s.vertex_text = texts->vertex;
        }
        ui_.say("read " + one_line(seen.lighting_name.empty() ? seen.vertex_name : seen.lighting_name, 100) + " again");
    } catch (const Error& error) {
        ui_.report(error);
    }
}

/// Two looks of one view: all but the camera and the moment is a look's own.
void Pictures::follow_leader(Look& look) const {
    const Look& leader = active().look;
    look.eye = leader.eye, look.world_up = leader.world_up, look.request.view = leader.request.view;
    look.request.motion = leader.request.motion, look.time_s = leader.time_s, look.keys = leader.keys;
}

bool Pictures::request(std::size_t i, Demand demand, bool has_gpu) {
    if (!model_) return false;
    PictureView& view = views_[i];
    if (ui_.split == Split::wipe) follow_leader(view.look);
    demand.wants_depth = ui_.normals || ui_.tangents || ui_.bitangents || ui_.seams || ui_.grid;
    demand.is_by_gl = gl_.draws(view.look, has_gpu);
    if (view.has_requested(demand, model_)) return false;
    view.open(wake_, threads_, max_memory_);
    try {
        view.place_camera(model_);
    } catch (const Error& error) {
        ui_.report(error);
        return false;
    }
    PaintJob job = view.new_job(demand, model_);
    if (demand.is_by_gl) job.gl = gl_painter(i);  // a fault requests the picture again
    view.paint(std::move(job));
    return true;
}

std::shared_ptr<GlPainter> Pictures::gl_painter(std::size_t i) {
    try {
        return gl_.get(i);
    } catch (const Error& error) {
        handle_gl_fault(error);
        return nullptr;
    }
}

/// A context that is lost is made again. Where that does not help, pictures are made by sessions from now on, those that were
/// GlView's by soft. Engine gl can be chosen again: it has a context of its own.
void Pictures::handle_gl_fault(const Error& error) {
    if (gl_.restart()) {
        for (PictureView& view : views_) view.forget_request();
        return ui_.say("OpenGL is started again: " + one_line(error.reason(), 200));
    }
    for (PictureView& view : views_)
        if (view.look.request.engine == "gl" || view.look.request.engine == "auto") view.look.request.engine = "soft";
    ui_.report(
        Error(ErrorCode::failed, "OpenGL fails in the window: " + error.reason(), {}, "engine soft draws from now on"));
}

void Pictures::poll() {
    for (PictureView& view : views_)
        if (view.is_open()) poll(view);
}

void Pictures::poll(PictureView& view) {
    if (view.take_picture()) {
        const Painting& painting = *view.displayed();
        gl_pictures_ += painting.picture != nullptr;
        note_warnings(painting);
        ui_.redraw(painting.is_final ? settling_frames : 1);  // what was said of its progress is gone
    }
    const auto fault = view.take_fault();
    if (!fault) return;
    if (fault->is_of_gl) return handle_gl_fault(fault->error);
    ui_.report(fault->error);
    if (fault->number != view.number()) return;
    ui_.player.is_playing = ui_.player.is_turning = false;
    view.go_back(model_);
}

/// Shows the first of them that was not shown before.
void Pictures::note_warnings(const Painting& painting) {
    for (const std::string& warning : painting.warnings)
        if (ui_.announces && std::ranges::find(warned_, warning) == warned_.end()) {
            warned_.push_back(warning);
            return ui_.say(warning);
        }
}

void Pictures::cancel() {
    for (PictureView& view : views_) view.cancel();
}

void Pictures::cancel_preparation() {
    for (PictureView& view : views_)
        if (!view.preparation().empty()) view.cancel();
}

bool Pictures::is_painting() const { return std::ranges::any_of(views_, &PictureView::is_painting); }

bool Pictures::is_gl_drawing() const {
    return (views_[0].is_painting() && gl_.has(0)) || (views_[1].is_painting() && gl_.has(1));
}

bool Pictures::is_moment_painting() const {
    return std::any_of(views_, views_ + count(), [](const PictureView& view) { return view.is_painting(); });
}

double Pictures::next_moment_s() const {
    if (is_moment_painting()) return 0.1;  // its end wakes the window
    return std::clamp(shortest_s - seconds(Clock::now() - last_moment_), 0.0, shortest_s);
}

void Pictures::play() {
    Player& player = ui_.player;
    if (!plays()) return player.stop_clock();
    const auto now = Clock::now();
    if (is_moment_painting() || seconds(now - last_moment_) < 0.5 * shortest_s) return;
    last_moment_ = now;
    const double elapsed_s = player.elapsed(seconds(now.time_since_epoch()));
    bool goes_on = false;
    for (PictureView& view : all().first(count()))
        goes_on |= advance(view.look, *model_, player, view.area.width, view.area.height, elapsed_s);
    player.is_playing &= goes_on;
    ++moments_;
}

}  // namespace rakelight::viewer
