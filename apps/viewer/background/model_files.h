// SPDX-License-Identifier: Apache-2.0
// The list of files, and the model of the file that is shown. A file is loaded in the background, and again when it changes.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "../../common/watched_files.h"
#include "../document/ui_state.h"
#include "background.h"
#include "load_model.h"

namespace rakelight::viewer {

class ModelFiles {
public:
    /// @param start  has the list; messages go to `ui`
    ModelFiles(Start start, std::function<void()> wake, UiState& ui);

    /// Begins to load the current file. @param keeps_look  it is the file that is shown
    void load(bool keeps_look);
    /// Goes on in the list, around its ends.
    void step(int by);
    /// Opens the first of them; what is shown stays until it is loaded, and if it cannot be. @param adds  to the list
    void open_dropped(const std::vector<std::string>& models, bool adds);
    /// Files that belong to the look: a change of them loads the model again, too.
    void watch(const std::vector<std::string>& files) { watched_.add(files); }
    /// Loads the model again if a file of it has changed and then been left alone for a while. To be called now and then.
    void reload_changed();
    void cancel() { loader_.cancel(); }

    struct Arrival {
        bool keeps_look = false;  ///< the same file as before, read again
    };
    /// Takes what is loaded. @return there is another model() now
    std::optional<Arrival> poll();

    const std::shared_ptr<const Model>& model() const { return model_; }  ///< null: nothing is loaded yet
    std::size_t number() const { return file_; }                          ///< in the list, from 0
    std::size_t count() const { return start_.files.size(); }
    const Background& loader() const { return loader_; }

private:
    struct FileList {
        std::vector<std::string> files;
        std::size_t number = 0;
    };
    void watch_from_now();
    void take_files_back();

    Start start_;
    UiState& ui_;
    std::size_t file_ = 0;
    std::shared_ptr<const Model> model_;
    std::optional<FileList> before_drop_;  ///< while what was dropped is loaded
    std::optional<Arrival> arrival_;
    apps::WatchedFiles watched_;
    Background loader_;  ///< last: its work ends before what it uses
};

}  // namespace rakelight::viewer
