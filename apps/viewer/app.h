// SPDX-License-Identifier: Apache-2.0
// The viewer: events change looks, painters make pictures of looks, the window shows the newest ones. The window's thread only
// handles events and shows what is finished.
#pragma once
#include <chrono>
#include <memory>
#include <optional>

#include <rakelight/render/gl_view.h>

#include "document/materials.h"
#include "document/settings_file.h"
#include "panels/panels.h"
#include "view/analysis.h"
#include "view/exports.h"
#include "view/gizmo.h"
#include "view/model_files.h"
#include "view/painter.h"
#include "view/shader_files.h"
#include "window/input.h"
#include "window/window.h"
#include "window/window_times.h"

namespace rakelight::viewer {

class App {
public:
    explicit App(Start start);
    ~App();
    /// Until the window is closed. @return the exit code: 1 where a file that was requested could not be written
    int run();

private:
    using Clock = std::chrono::steady_clock;
    /// [px] of the window, y down.
    struct Rectangle {
        int x = 0, y = 0, width = 1, height = 1;
        bool holds(double px, double py) const { return px >= x && py >= y && px < x + width && py < y + height; }
    };
    /// A picture of the window: what it is to show, and what it shows.
    struct View {
        Look look, submitted, good;     ///< good: of the last picture without an error
        std::shared_ptr<GlPainter> gl;  ///< null: it was not needed yet; ends in the window's thread
        std::unique_ptr<Painter> painter;
        std::unique_ptr<GlView> screen;                        ///< shows pictures that are not on the GPU
        std::shared_ptr<const Painting> displayed, on_screen;  ///< the second: what `screen` holds
        MarkLines mark_lines;
        Marks submitted_marks;
        std::shared_ptr<const Model> submitted_model, good_model;
        Rectangle area, submitted_area;
        Camera camera;  ///< of what was submitted
        bool is_submitted_moving = false, is_submitted_with_depth = false, is_painting = false;
        std::uint64_t number = 0;
    };

    // app.cpp: the loop
    void loop();
    void poll();
    void poll_view(View& view);
    void step();
    void finish_writing();
    void note_warnings(const Painting& painting);
    void lay_out();
    bool take_camera(View& view);
    void submit(View& view);
    bool is_drawn_by_gl(const Look& look) const;
    std::shared_ptr<GlPainter> gl_of(View& view);
    void handle_gl_fault(const Error& error);
    Marks marks(const View& view) const;
    bool is_busy() const;
    std::vector<const Background*> works() const;
    bool has_background_work() const;
    View& active() { return views_[ui_.active]; }
    std::size_t view_count() const { return ui_.split == Split::none ? 1 : 2; }

    // app_input.cpp: what the user does
    void handle(const Event& event);
    void press(Button button, const Event& event);
    void move(const Event& event);
    void zoom(const Event& event);
    void command(Command command);
    void leave();
    bool is_stepping() const;
    void step_walk();
    void click(const Event& event);
    void activate_at(double x, double y);

    // app_drop.cpp: what is dropped on the window
    void drop(const Event& event);
    void give_picture(const Event& event, const std::string& file);

    // app_motion.cpp: what plays
    bool plays() const;
    bool is_view_painting() const;
    double wait_s() const;
    void play();
    void take_motion(bool keeps);

    // app_lights.cpp: lights in the picture
    GizmoView gizmo_view(const View& view) const;
    std::optional<Light> selected_light(const View& view) const;
    bool take_light(double x, double y);
    void move_light(double x, double y);
    void hover_light(double x, double y, bool is_over_panel);
    void follow_camera();

    // app_work.cpp: what runs in the background
    void take_model(const ModelFiles::Arrival& arrival);
    Shown shown();
    void watch_file();
    void watch_shaders();
    std::string carry_to(const Model& model);
    void cancel_work();
    void copy_command_line();

    // app_draw.cpp: what is shown
    void draw();
    void draw_picture(View& view);
    void show_codes(View& view);
    void draw_wipe();
    void draw_wipe_on_gpu();
    void draw_wipe_of_codes();
    PixelBox box_of(const View& view) const;
    void draw_lines(View& view);
    void draw_split();
    void draw_panels_over();

    Start start_;
    std::unique_ptr<GlfwWindow> window_;  ///< before all whose threads wake it
    View views_[2];
    Remembered remembered_;
    UiState ui_;
    ModelFiles files_;
    Exports exports_;
    Analysis analysis_;
    bool has_gl_failed_ = false;
    int gl_faults_ = 0;
    std::vector<std::string> warned_;                  ///< of this model
    std::vector<std::shared_ptr<GlPainter>> lost_gl_;  ///< painters may hold them still; they end in this thread
    std::uint64_t gl_pictures_ = 0;                    ///< shown
    std::uint64_t moments_ = 0;                        ///< that were played
    ShaderFiles shader_files_;
    std::shared_ptr<const Model> model_;

    HeldKeys held_;
    Drag drag_ = Drag::none;
    double last_x_ = 0, last_y_ = 0, press_x_ = 0, press_y_ = 0, last_click_x_ = 0, last_click_y_ = 0;
    int press_modifiers_ = 0;
    struct LightDrag {
        Handle handle = Handle::none;
        Light start;
        dvec2 from;
    };
    LightDrag light_drag_;
    Handle hovered_ = Handle::none;
    Clock::time_point last_click_{}, last_motion_{}, last_step_{}, last_watch_{}, last_moment_{};
    bool is_quitting_ = false, is_walk_step_ = false;
    std::vector<Command> from_panels_;

    /// What is on the screen of a wipe.
    struct Wipe {
        std::shared_ptr<const Painting> a, b;
        int line = 0, width = 0, height = 0;
        bool operator==(const Wipe&) const = default;
    };
    Wipe wipe_;
    std::vector<std::uint32_t> wiped_;

    WindowTimes times_;
};

}  // namespace rakelight::viewer
