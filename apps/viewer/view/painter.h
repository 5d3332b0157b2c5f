// SPDX-License-Identifier: Apache-2.0
// Makes pictures of looks in a thread of its own, by a session or on the GPU: coarse ones while something moves, then whole, then
// with the samples that are wanted.
#pragma once
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include <rakelight/render/session.h>

#include "../background/background.h"
#include "../document/document.h"
#include "gl_painter.h"
#include "marks.h"
#include "pace.h"

namespace rakelight::viewer {

/// A picture to be painted.
struct PaintJob {
    std::shared_ptr<const Model> model;
    Look look;
    int width = 0, height = 0;  ///< [px] of the whole picture, at least 1
    bool is_moving = false;     ///< a coarse picture is enough
    bool is_playing = false;    ///< of a moment: drawn to its end, as fine as there is time for
    bool wants_depth = false;   ///< for lines that surfaces hide
    std::uint64_t number = 0;   ///< grows with every change
    /// By which it is drawn where that can do it, with lines; null: by a session. All jobs of a painter have the same or none.
    std::shared_ptr<GlPainter> gl;
    Marks marks;
};

/// A finished picture.
struct Painting {
    std::uint64_t number = 0;  ///< of its job
    std::shared_ptr<const Model> model;
    int width = 0, height = 0;           ///< [px] of the picture
    std::shared_ptr<GlPicture> picture;  ///< with its lines; null: it is in `codes`
    std::vector<std::uint32_t> codes;    ///< sRGB, R in the low byte
    std::vector<float> depth;            ///< [m] along the view; empty: not requested
    Camera camera;
    PictureRequest request;  ///< at the job's size
    std::shared_ptr<const PreparedScene> prepared;
    RenderStats stats;
    std::vector<std::string> warnings;  ///< a line each; of a scene they come with its first picture
    double ms = 0;
    double pixels_ms = 0;   ///< of `ms` what its pixels took; 0: not known
    bool is_whole = false;  ///< full size
    bool is_final = false;  ///< and with all samples
};

class Painter {
public:
    Painter(std::function<void()> wake, int threads, std::uint64_t max_memory);
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    /// Replaces the job before, whose refinement is stopped.
    void paint(PaintJob job);
    /// The newest picture since the last call; null: there is none.
    std::shared_ptr<const Painting> take();
    struct Fault {
        std::uint64_t number = 0;  ///< of the job that it ended
        Error error;
        bool is_of_gl = false;  ///< PaintJob::gl does not continue
    };
    /// The newest since the last call.
    std::optional<Fault> take_fault();
    /// Breaks off what runs; its job ends with the error "cancelled".
    void cancel();
    const Progress& progress() const { return progress_; }

    /// The surface at a pixel of a painting, from the scene that was painted. Found in the painter's thread.
    struct Hit {
        dvec3 position{};
        std::uint32_t object = no_index, material = no_index;
    };
    void look_at_pixel(int x, int y, std::function<void(std::optional<Hit>)> done);
    /// In the window's thread: hands over what look_at_pixel() found.
    void poll();

private:
    struct Studio;
    struct Probe {
        int x, y;
        std::function<void(std::optional<Hit>)> done;
    };
    void run();
    void work(const PaintJob& job);
    bool paint_pass(const PaintJob& job, double scale, int samples, bool is_final);
    enum class Outcome { drawn, cannot, outdated };
    Outcome draw_by_gl(const PaintJob& job, const PictureRequest& request, double scale, Painting& to,
                       Context& context);
    bool take_up_by_gl(const PaintJob& job, const std::shared_ptr<const PreparedScene>& scene, Context& context);
    void draw_by_session(const PaintJob& job, const PictureRequest& request, Painting& to, Context& context);
    void answer(const Probe& probe, const PaintJob& job);
    bool is_outdated(const PaintJob& job);
    std::shared_ptr<Context> new_context(bool may_break_off);

    std::function<void()> wake_;
    int threads_;
    std::uint64_t max_memory_;
    Progress progress_;
    Pace pace_;
    std::unique_ptr<Studio> studio_;

    std::mutex mutex_;
    std::condition_variable news_;
    bool is_ending_ = false;
    std::optional<PaintJob> next_;
    PaintJob last_;  ///< of the thread alone, as the next four
    std::shared_ptr<GlPainter> gl_;
    std::shared_ptr<const Model> gl_model_;  ///< of the scene that it draws
    MarkLines mark_lines_;
    bool is_in_gl_ = false;
    std::vector<Probe> probes_;
    std::vector<std::function<void()>> answers_;
    std::shared_ptr<const Painting> painting_;
    std::optional<Fault> fault_;
    std::shared_ptr<Context> context_;  ///< of what runs
    bool may_break_off_ = false;        ///< what runs is a refinement
    std::thread thread_;                ///< last: it uses all above
};

}  // namespace rakelight::viewer
