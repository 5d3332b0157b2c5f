// SPDX-License-Identifier: Apache-2.0
// Makes pictures of looks in a thread of its own: coarse ones while something moves, then whole, then with the samples that
// are wanted.
#pragma once
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include <rakelight/session.h>

#include "background.h"
#include "document.h"
#include "pace.h"

namespace rakelight::viewer {

/// What is to be painted.
struct PaintJob {
    std::shared_ptr<const Model> model;
    Look look;
    int width = 0, height = 0;  ///< [px] of the whole picture, at least 1
    bool is_moving = false;     ///< a coarse picture is enough
    bool wants_depth = false;   ///< for lines that surfaces hide
    std::uint64_t number = 0;   ///< grows with every change
};

/// A finished picture.
struct Painting {
    std::uint64_t number = 0;  ///< of its job
    std::shared_ptr<const Model> model;
    int width = 0, height = 0;         ///< [px] of `codes`
    std::vector<std::uint32_t> codes;  ///< sRGB, R in the low byte
    std::vector<float> depth;          ///< [m] along the view; empty: not asked for
    Camera camera;
    PictureRequest request;  ///< at the job's size
    std::shared_ptr<const PreparedScene> prepared;
    RenderStats stats;
    double ms = 0;
    bool is_whole = false;  ///< full size
    bool is_final = false;  ///< and with all samples
};

class Painter {
public:
    Painter(std::function<void()> wake, int threads, std::uint64_t max_memory);
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    /// Takes the place of the job before, whose refinement is broken off.
    void paint(PaintJob job);
    /// The newest picture since the last call; null: there is none.
    std::shared_ptr<const Painting> take();
    /// The newest error since the last call, with the number of the job that it ended.
    std::optional<std::pair<std::uint64_t, Error>> take_error();
    /// Breaks off what runs; its job ends with the error "cancelled".
    void cancel();
    const Progress& progress() const { return progress_; }

    /// What is at a pixel of a painting, from the scene that it was painted of. Runs in the painter's thread.
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
    PaintJob last_;  ///< of the thread alone
    std::vector<Probe> probes_;
    std::vector<std::function<void()>> answers_;
    std::shared_ptr<const Painting> painting_;
    std::optional<std::pair<std::uint64_t, Error>> error_;
    std::shared_ptr<Context> context_;  ///< of what runs
    bool may_break_off_ = false;        ///< what runs is a refinement
    std::thread thread_;                ///< last: it uses all above
};

}  // namespace rakelight::viewer
