// SPDX-License-Identifier: Apache-2.0
// The one or two pictures of the window: the model that they show, their looks, and what plays in them.
#pragma once
#include <chrono>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "../background/load_model.h"
#include "../document/ui_state.h"
#include "gl_painters.h"
#include "picture_view.h"
#include "shader_files.h"

namespace rakelight::viewer {

class Pictures {
public:
    using Clock = std::chrono::steady_clock;
    /// @param start  limits of the painters @param wake  called from their threads @param make_context  for OpenGL in them
    /// @param ui  which picture is active; gets messages
    Pictures(const Start& start, std::function<void()> wake, GlPainters::MakeContext make_context, UiState& ui);

    const std::shared_ptr<const Model>& model() const { return model_; }  ///< null: nothing is shown yet
    /// Shows another model, and says what is to be known of it. @param keeps_looks  it is the same file, read again
    void show(const std::shared_ptr<const Model>& model, bool keeps_looks);

    PictureView& operator[](std::size_t i) { return views_[i]; }
    const PictureView& operator[](std::size_t i) const { return views_[i]; }
    PictureView& active() { return views_[ui_.active]; }  ///< that keys and panels change
    const PictureView& active() const { return views_[ui_.active]; }
    std::span<PictureView> all() { return views_; }
    std::span<const PictureView> all() const { return views_; }
    std::size_t count() const { return ui_.split == Split::none ? 1 : 2; }  ///< that are shown

    /// Divides the window. @param left  [px] that the panels take
    void lay_out(int window_width, int window_height, int left);
    /// The picture at a pixel of the window becomes the active one.
    void activate_at(double x, double y);
    /// The second picture begins with the look of the first, unless it has one of this file.
    void begin_split();
    /// Applies a command to the active look and to what plays, and reports its effect. @return false: it is not about
    /// them
    bool change_look(Command command);
    /// Reads the files of shaders again if they have changed. To be called now and then.
    void read_changed_shaders();

    /// Has a picture made if another one is wanted than the last time. @return it is requested
    bool request(std::size_t i, Demand demand, bool has_gpu);
    /// Takes what the painters have finished, and what went wrong.
    void poll();
    void cancel();
    /// Breaks off what runs before pictures can be drawn.
    void cancel_preparation();
    bool is_painting() const;
    bool is_gl_drawing() const;
    std::uint64_t gl_pictures() const { return gl_pictures_; }  ///< that GlView has drawn

    bool plays() const { return model_ && ui_.player.moves(); }
    /// Continues to the present moment, unless pictures of the one before are still to come. What there is no time for is left out.
    void play();
    /// [s] How long the window may sleep while something plays.
    double next_moment_s() const;
    std::uint64_t moments() const { return moments_; }  ///< that were played

private:
    std::string carry_edits_to(const Model& model);
    void take_motion(bool keeps_looks);
    void follow_leader(Look& look) const;
    std::shared_ptr<GlPainter> gl_painter(std::size_t i);
    void handle_gl_fault(const Error& error);
    void poll(PictureView& view);
    void note_warnings(const Painting& painting);
    bool is_moment_painting() const;

    UiState& ui_;
    std::function<void()> wake_;
    int threads_;
    std::uint64_t max_memory_;
    std::shared_ptr<const Model> model_;
    GlPainters gl_;  ///< before the views, whose threads use them
    PictureView views_[2];
    std::vector<std::string> warned_;  ///< of this model
    ShaderFiles shader_files_;
    Clock::time_point last_moment_{};
    std::uint64_t moments_ = 0, gl_pictures_ = 0;
};

}  // namespace rakelight::viewer
