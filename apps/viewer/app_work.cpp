// SPDX-License-Identifier: Apache-2.0
// What runs in the background: loading, saving, recording, explaining, looking for seams.
#include <algorithm>

#include "app.h"
#include "document/materials.h"
#include "document/save.h"

namespace rakelight::viewer {
namespace {

namespace fs = std::filesystem;

}  // namespace

void App::take_model(const ModelFiles::Arrival& arrival) {
    const std::shared_ptr<const Model>& model = files_.model();
    const bool keeps = arrival.keeps_look;
    std::string news = keeps ? carry_to(*model) : std::string();
    model_ = model;
    analysis_.forget_seams();
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

/// Loads the file again when it, or one that it names, has changed and then been left alone for a while.
void App::watch_file() {
    last_watch_ = Clock::now();
    watch_shaders();
    for (const View& view : views_) files_.watch(files_of(view.look));
    files_.reload_changed();
}

Shown App::shown() {
    const View& view = active();
    return {model_, view.look, view.area.width, view.area.height};
}

void App::cancel_work() {
    exports_.cancel();
    files_.cancel();
    analysis_.cancel();
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

}  // namespace rakelight::viewer
