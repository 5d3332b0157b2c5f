// SPDX-License-Identifier: Apache-2.0
// What runs in the background: loading, saving, recording, explaining, looking for seams.
#include <algorithm>
#include <cstdio>

#include <rakelight/render/render.h>
#include <rakelight/tools/explain.h>
#include <rakelight/tools/smooth_file.h>

#include "app.h"
#include "document/display_path.h"
#include "document/gather.h"
#include "document/materials.h"
#include "document/save.h"
#include "motion/record.h"

namespace rakelight::viewer {
namespace {

namespace fs = std::filesystem;

}  // namespace

/// The file that is shown or could not be, so that a later change is seen.
void App::watch_from_now() {
    const std::string file = file_ < start_.files.size() ? start_.files[file_] : std::string();
    watched_files_.begin(file);
    if (model_ && model_->file == file) watched_files_.take(model_->files);
}

void App::load_current(bool keeps_look) {
    if (file_ >= start_.files.size()) return;
    const std::string file = start_.files[file_];
    watch_from_now();
    ui_.message.clear();
    const auto work = [this, file, start = start_, keeps_look](Context& context) -> Background::Finish {
        const auto model = load_model(file, start, context);
        return [this, model, keeps_look] { take_model(model, keeps_look); };
    };
    loader_.start("load", work, [this](const Error& error) {
        std::fprintf(stderr, "rakelight: error: %s\n", error.what());
        take_files_back();
        ui_.report(error);
    });
}

void App::take_model(const std::shared_ptr<const Model>& model, bool keeps_look) {
    const bool keeps = keeps_look && model_ && model_->file == model->file;
    std::string news = keeps ? carry_to(*model) : std::string();
    model_ = model;
    watched_files_.take(model->files);
    before_drop_.reset();
    seams_.reset();
    warned_.clear();
    ui_.objects_are_of = no_index;
    if (!keeps) {
        for (View& view : views_) view.look = first_look(*model);
        ui_.light = ui_.material = 0, ui_.object = no_index;
        ui_.explained.clear();
    }
    take_motion(keeps);
    window_->set_title(one_line(fs::path(model->file).filename().string(), 100) + " - Rakelight (H: keys)");
    std::size_t warnings = 0;
    for (const ReportEntry& entry : model->remarks) warnings += entry.remark != Remark::note;
    if (warnings > 0)
        news += (news.empty() ? "" : "\n") + std::to_string(warnings) + (warnings == 1 ? " remark" : " remarks") +
                " about the file: see the panel Statistics (F8)";
    if (!news.empty()) ui_.say(news);
    ui_.redraw();
}

/// What is known of objects by their numbers, for the file as it is now. @return what is to be said of it
std::string App::carry_to(const Model& model) {
    std::vector<std::string> gone;
    for (View& view : views_)
        for (const std::string& title : carry_edits(view.look.materials, model_->scene, model.scene))
            if (std::ranges::find(gone, title) == gone.end()) gone.push_back(title);
    ui_.object = same_object(model_->scene, ui_.object, model.scene);
    if (gone.empty()) return {};
    std::string text = "no longer in the file; changes of their materials are dropped: " + gone[0];
    for (std::size_t i = 1; i < std::min<std::size_t>(gone.size(), 5); ++i) text += ", " + gone[i];
    return gone.size() > 5 ? text + ", ..." : text;
}

void App::step_file(int by) {
    const int count = int(start_.files.size());
    if (count == 0) return;
    file_ = std::size_t((int(file_) + by + count) % count);
    load_current(false);
}

/// Loads the file again when it, or one that it names, has changed and then been left alone for a while.
void App::watch_file() {
    last_watch_ = Clock::now();
    watch_shaders();
    for (const View& view : views_) watched_files_.add(files_of(view.look));
    if (file_ < start_.files.size() && !loader_.is_running() && watched_files_.has_changed()) load_current(true);
}

/// Behind all that is to be written before: nothing that was requested is lost, and no name is taken twice.
/// @param work  gives what is to be said when it is done
void App::write_file(const std::string& title, std::function<std::string(Context&)> work) {
    const auto run = [this, work = std::move(work)](Context& context) -> Background::Finish {
        try {
            return [this, text = work(context)] { ui_.say(with_not_begun(text)); };
        } catch (const Error& error) {
            if (context.cancelled()) throw;
            has_lost_file_ = true;
            std::fprintf(stderr, "rakelight: error: %s\n",
                         error.what());  // the window may close before it is read there
            throw;
        }
    };
    writer_.queue(title, run, [this](const Error& error) {
        ui_.report(error);
        ui_.message.fail(with_not_begun(ui_.message.text()));
    });
}

void App::cancel_work() {
    not_begun_ += writer_.cancel();
    for (Background* work : {&loader_, &explainer_, &seam_search_}) work->cancel();
}

/// After a cancel: how much was not even begun.
std::string App::with_not_begun(const std::string& text) {
    const std::size_t count = std::exchange(not_begun_, 0);
    if (count == 0) return text;
    return text + "; " + std::to_string(count) + " more not begun";
}

/// Files are of one picture: which of two.
std::string App::displayed_half() const {
    if (ui_.split == Split::none) return {};
    return ui_.active == 0 ? " (picture A alone)" : " (picture B alone)";
}

void App::screenshot(bool is_transparent) {
    if (!model_) return;
    const View& view = active();
    PictureRequest request = request_of(view.look, view.area.width, view.area.height);
    if (is_transparent) request.settings.background = {0, 0, 0, 0};
    if (view.look.channel) request.settings.channels = view.look.channel, request.channel_files = channel_files_png;
    write_file("screenshot", [model = model_, look = view.look, request, which = displayed_half()](Context& context) {
        PictureRequest named = request;
        named.output = free_name(model->file, "", ".png");
        const PictureResult result = render_picture(with_edits(model->scene, look.materials, context), named, context);
        return "wrote " + short_path(result.channel_files.empty() ? result.output : result.channel_files.back()) +
               which;
    });
}

void App::save_scene() {
    if (!model_) return;
    const View& view = active();
    write_file("save", [model = model_, look = view.look, area = view.area, which = displayed_half()](Context&) {
        const std::string path = free_world_name(model->file), missing = not_saved(look);
        const std::size_t copies = save_with_files(world_of(look, *model, area.width, area.height, path), path);
        const std::string with = copies == 0   ? ""
                                 : copies == 1 ? " with a copy of a file"
                                               : " with copies of " + std::to_string(copies) + " files";
        return "wrote " + short_path(path) + which + with + (missing.empty() ? "" : "; not in it: " + missing);
    });
}

void App::copy_command_line() {
    if (!model_) return;
    const View& view = active();
    try {
        window_->set_clipboard(command_line_of(view.look, *model_, view.area.width, view.area.height));
        const std::string missing = not_on_command_line(view.look, *model_);
        ui_.say(missing.empty()
                    ? "copied the command line"
                    : "copied the command line, but for " + missing + ": save the scene to keep these (Ctrl+S)");
    } catch (const Error& error) {
        ui_.report(error);
    }
}

void App::save_seamless() {
    if (!model_) return;
    SmoothFileOptions options{.load = active().look.request.load};
    options.attributes.crease_angle_rad = active().look.request.prepare.crease_angle_rad;
    options.attributes.creases = active().look.request.prepare.creases;
    options.attributes.weight = active().look.request.prepare.weight;
    options.border_distance = active().look.request.prepare.border_distance;
    write_file("save seamless", [file = model_->file, options](Context& context) {
        return with_short_paths(summary(smooth_file(file, free_seamless_name(file), options, context)));
    });
}

void App::record() {
    if (!model_) return;
    const View& view = active();
    write_file(
        "record", [model = model_, look = view.look, area = view.area, count = ui_.record_frames](Context& context) {
            const std::string folder = free_name(model->file, "-turn", "");
            const Turn turn = record_turn(model, look, area.width, area.height, count, folder, context);
            return to_text(turn, short_path(folder)) + (look.channel ? ", in colors: channels are not recorded" : "");
        });
}

/// Of the scene as it is shown, with its changed materials.
void App::explain_at(int x, int y) {
    const View& view = active();
    const PictureRequest request = request_of(view.look, view.area.width, view.area.height);
    const auto work = [this, model = model_, edits = view.look.materials, request, x,
                       y](Context& context) -> Background::Finish {
        const Scene scene = with_edits(model->scene, edits, context);
        std::string text = to_text(*explain(scene, request, x, y, context));
        if (request.engine == "trace")
            text = "as engine soft draws it, without reflected or refracted rays:\n\n" + text;
        return [this, file = model->file, text = std::move(text)] {
            ui_.explained = with_short_paths(text, file);
            ui_.open[std::size_t(Panel::pixel)] = true, ui_.are_panels_hidden = false;
            ui_.redraw();
        };
    };
    explainer_.start("explain", work, [this](const Error& error) { ui_.report(error); });
}

/// Seams are looked for again whenever normals change.
void App::look_for_seams() {
    if (!ui_.seams || !model_) return;
    const PrepareOptions& prepare = active().look.request.prepare;
    const bool is_known = seams_model_ == model_ && seams_prepare_ == prepare;
    if (is_known || (seam_search_.is_running() && drag_ == Drag::none)) return;
    seams_model_ = model_, seams_prepare_ = prepare;
    const InspectOptions options{
        .surfaces = false, .seam_lines = true, .prepare = seam_options(model_->scene, prepare)};
    const auto work = [this, model = model_, options](Context& context) -> Background::Finish {
        Inspection result = inspect(model->scene, options, context);
        const auto seams = std::make_shared<const Seams>(worst_seams(std::move(result.seam_lines)));
        return [this, seams] {
            seams_ = seams;
            ui_.redraw(1);
        };
    };
    seam_search_.start("seams", work, [this](const Error& error) {
        seams_.reset();  // those of other normals
        ui_.report(error);
    });
}

}  // namespace rakelight::viewer
