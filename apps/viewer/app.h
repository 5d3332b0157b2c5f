// SPDX-License-Identifier: Apache-2.0
// The viewer: events change looks, painters make pictures of looks, the window shows the newest ones. The window's thread only
// handles events and shows what is finished.
#pragma once
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "background/analysis.h"
#include "background/exports.h"
#include "background/model_files.h"
#include "document/settings_file.h"
#include "panels/panels.h"
#include "view/pictures.h"
#include "window/navigation.h"
#include "window/screen.h"
#include "window/window.h"
#include "window/window_times.h"

namespace rakelight::viewer {

class App {
public:
    explicit App(const Start& start);
    /// Until the window is closed. @return the exit code: 1 where a file that was requested could not be written
    int run();

private:
    using Clock = std::chrono::steady_clock;

    void open_window(const Start& start);
    void loop();
    void step();
    double wait_s() const;
    void poll();
    void show(const ModelFiles::Arrival& arrival);
    void request_pictures();
    void finish_writing();

    void handle(const Event& event);
    void click(const Click& click);
    void drop(const Event& event);
    void execute(Command command);
    void adapt_window(Command command);
    void export_as(Command command);
    void leave();

    void draw();
    void draw_panels_over();
    Marks marks(std::size_t picture) const;
    Shown shown() const;

    std::vector<const Background*> works() const;
    std::vector<std::string> work_texts() const;
    bool has_background_work() const;

    bool wants_stats_, is_quitting_ = false;
    Remembered remembered_;
    UiState ui_;
    std::unique_ptr<GlfwWindow> window_;  ///< opens while a model is loaded; ends after all whose threads wake it
    ModelFiles files_;
    Exports exports_;
    Analysis analysis_;
    Pictures pictures_;
    Navigation navigation_;
    std::unique_ptr<Screen> screen_;
    WindowTimes times_;
    Clock::time_point last_watch_{};
    std::vector<Command> from_panels_;  ///< for the next step
};

}  // namespace rakelight::viewer
