// SPDX-License-Identifier: Apache-2.0
// The files that the user has written: pictures, scenes, models. They are written in the background, one after another, so that
// nothing that was requested is lost and no name is taken twice.
#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "../document/ui_state.h"
#include "background.h"
#include "load_model.h"

namespace rakelight::viewer {

/// A picture as it is shown when its file is requested.
struct Shown {
    std::shared_ptr<const Model> model;
    Look look;
    int width = 1, height = 1;  ///< [px]
};

class Exports {
public:
    /// @param start  limits of the work; messages go to `ui`
    Exports(const Start& start, std::function<void()> wake, UiState& ui);

    void write_picture(const Shown& shown, bool is_transparent);
    /// As a world file.
    void save_scene(const Shown& shown);
    /// The model's file with smooth normals across its seams.
    void save_seamless(const Shown& shown);
    /// A turntable.
    void record(const Shown& shown);

    /// The command line that makes the picture; what it lacks is said. @return none: it cannot be said, which is reported
    std::optional<std::string> command_line(const Shown& shown);

    void poll() { writer_.poll(); }
    /// Also what has not begun; the message of what runs says how much that is.
    void cancel() { not_begun_ += writer_.cancel(); }
    /// The program ends: what is not written by now is lost.
    void give_up();
    /// A file that was requested could not be written.
    bool has_lost_file() const { return has_lost_file_; }
    const Background& writer() const { return writer_; }

private:
    void write(const std::string& title, std::function<std::string(Context&)> work);
    std::string with_not_begun(const std::string& text);
    std::string shown_half() const;

    UiState& ui_;
    std::size_t not_begun_ = 0;  ///< files that were to be written when all was cancelled
    std::atomic<bool> has_lost_file_{false};
    Background writer_;  ///< last: its work ends before what it uses
};

}  // namespace rakelight::viewer
