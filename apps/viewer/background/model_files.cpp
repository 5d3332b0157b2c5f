// SPDX-License-Identifier: Apache-2.0
#include "model_files.h"

#include <cstdio>

namespace rakelight::viewer {

ModelFiles::ModelFiles(Start start, std::function<void()> wake, UiState& ui)
    : start_(std::move(start)),
      ui_(ui),
      loader_(std::move(wake), start_.threads, start_.max_memory, start_.everything) {}

/// The file that is shown or could not be, so that a later change is seen.
void ModelFiles::watch_from_now() {
    const std::string file = file_ < start_.files.size() ? start_.files[file_] : std::string();
    watched_.begin(file);
    if (model_ && model_->file == file) watched_.take(model_->files);
}

void ModelFiles::load(bool keeps_look) {
    if (file_ >= start_.files.size()) return;
    const std::string file = start_.files[file_];
    watch_from_now();
    ui_.message.clear();
    const auto work = [this, file, start = start_, keeps_look](Context& context) -> Background::Finish {
        const auto model = load_model(file, start, context);
        return [this, model, keeps_look] {
            arrival_ = Arrival{keeps_look && model_ && model_->file == model->file};
            model_ = model;
            watched_.take(model->files);
            before_drop_.reset();
        };
    };
    loader_.start("load", work, [this](const Error& error) {
        std::fprintf(stderr, "rakelight: error: %s\n", error.what());
        take_files_back();
        ui_.report(error);
    });
}

std::optional<ModelFiles::Arrival> ModelFiles::poll() {
    loader_.poll();
    return std::exchange(arrival_, {});
}

void ModelFiles::step(int by) {
    const int count = int(start_.files.size());
    if (count == 0) return;
    file_ = std::size_t((int(file_) + by + count) % count);
    load(false);
}

void ModelFiles::reload_changed() {
    if (file_ < start_.files.size() && !loader_.is_running() && watched_.has_changed()) load(true);
}

void ModelFiles::open_dropped(const std::vector<std::string>& models, bool adds) {
    if (!before_drop_) before_drop_ = FileList{start_.files, file_};
    if (!adds) start_.files.clear();
    file_ = start_.files.size();
    start_.files.insert(start_.files.end(), models.begin(), models.end());
    load(false);
}

/// After a drop that could not be loaded.
void ModelFiles::take_files_back() {
    if (!before_drop_) return;
    start_.files = std::move(before_drop_->files), file_ = before_drop_->number;
    before_drop_.reset();
    const bool is_shown = model_ && file_ < start_.files.size() && model_->file == start_.files[file_];
    is_shown ? watch_from_now() : load(false);  // the drop had broken off its loading
}

}  // namespace rakelight::viewer
