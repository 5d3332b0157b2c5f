// SPDX-License-Identifier: Apache-2.0
#include "painter.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <rakelight/base/current_error.h>
#include <rakelight/render/render.h>
#include <rakelight/render/shot.h>

#include "studio.h"

namespace rakelight::viewer {
namespace {

constexpr std::chrono::milliseconds rest_before_release(1500);

/// Gives back to the system what the allocator keeps in its arenas, each thread's own: after a model or a large picture
/// went, that is several times what is in use.
void release_free_memory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

double ms_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

constexpr double upload_slice_ms = 20;                     // after which newer jobs are looked for
constexpr double motion_ms = 40, motion_of_paths_ms = 25;  // of a picture in motion; a pass takes time to break off
constexpr double told_after_ms = 200;                      // shorter uploads are not told of

int scaled(int size, double scale) { return std::max(1, int(std::lround(size * scale))); }

/// Engines that do not tell their stages apart are taken to work for pixels alone.
void note_pace(Pace& pace, const Painting& painting, int samples) {
    const StageTimes& times = painting.stats.times;
    const double pixels_ms = times.tiles > 0          ? 1e3 * times.tiles
                             : painting.pixels_ms > 0 ? painting.pixels_ms
                                                      : painting.ms;
    pace.measured(1e3 * times.front_end, pixels_ms, double(painting.width) * double(painting.height) * samples);
}

/// Keeps a picture, and shows each of its passes.
class PassSink final : public Sink {
public:
    using Show = std::function<void(const Frame& frame, int samples)>;
    explicit PassSink(Show show) : show_(std::move(show)) {}
    void begin(int width, int height, Window window, std::uint32_t channels) override {
        frame_.begin(width, height, window, channels);
    }
    void tile(const Tile& tile) override {
        frame_.tile(tile);
        if (!tile.samples.empty()) samples_ = tile.samples[0];
    }
    void end_pass(int pass) override {
        frame_.end_pass(pass);
        if (samples_ > 0) show_(frame_, samples_);
    }
    Frame& frame() { return frame_; }

private:
    Show show_;
    Frame frame_;
    std::atomic<int> samples_{0};  ///< 0: the engine does not say
};

std::vector<std::string> warnings_of(Context& context) {
    std::vector<std::string> warnings;
    for (const ReportEntry& entry : context.report().entries())
        if (entry.remark != Remark::note) warnings.push_back(one_line(entry.message, 300));
    return warnings;
}

/// Widths are pixels of the picture: those of a coarse one stand for more on the screen.
void scale_marks(RenderSettings& s, double scale) {
    s.line_width = std::max(0.5f, s.line_width * float(scale));
    s.point_size = std::max(1.0f, s.point_size * float(scale));
}

}  // namespace

struct Painter::Studio : viewer::Studio {};

Painter::Painter(std::function<void()> wake, int threads, std::uint64_t max_memory)
    : wake_(std::move(wake)), threads_(threads), max_memory_(max_memory), studio_(std::make_unique<Studio>()) {
    thread_ = std::thread([this] { run(); });
}

Painter::~Painter() {
    {
        const std::scoped_lock lock(mutex_);
        is_ending_ = true;
        if (context_) context_->cancel();
    }
    news_.notify_all();
    thread_.join();
}

void Painter::paint(PaintJob job) {
    {
        const std::scoped_lock lock(mutex_);
        if (context_ && may_break_off_) context_->cancel();
        next_ = std::move(job);
    }
    news_.notify_all();
}

std::shared_ptr<const Painting> Painter::take() {
    const std::scoped_lock lock(mutex_);
    return std::move(painting_);
}

std::optional<Painter::Fault> Painter::take_fault() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(fault_, std::nullopt);
}

void Painter::cancel() {
    const std::scoped_lock lock(mutex_);
    if (!context_) return;
    may_break_off_ = false;  // so that it is told
    context_->cancel();
}

void Painter::look_at_pixel(int x, int y, std::function<void(std::optional<Hit>)> done) {
    {
        const std::scoped_lock lock(mutex_);
        probes_.push_back({x, y, std::move(done)});
    }
    news_.notify_all();
}

void Painter::poll() {
    std::vector<std::function<void()>> answers;
    {
        const std::scoped_lock lock(mutex_);
        answers.swap(answers_);
    }
    for (const auto& answer : answers) answer();
}

bool Painter::is_outdated(const PaintJob& job) {
    const std::scoped_lock lock(mutex_);
    return is_ending_ || (next_ && next_->number != job.number);
}

std::shared_ptr<Context> Painter::new_context(bool may_break_off) {
    const auto report = [this](std::string_view stage, double fraction) { progress_.set(stage, fraction); };
    auto context =
        std::make_shared<Context>(ContextOptions{.threads = threads_, .max_memory = max_memory_, .progress = report});
    const std::scoped_lock lock(mutex_);
    context_ = context;
    may_break_off_ = may_break_off;
    if (is_ending_) context->cancel();
    return context;
}

void Painter::run() {
    bool has_worked = false;  // since free memory was released
    for (;;) {
        std::optional<PaintJob> job;
        std::vector<Probe> probes;
        {
            std::unique_lock lock(mutex_);
            const auto has_news = [this] { return is_ending_ || next_ || !probes_.empty(); };
            if (!news_.wait_for(lock, rest_before_release, has_news)) {
                lock.unlock();
                if (std::exchange(has_worked, false)) release_free_memory();
                lock.lock();
                news_.wait(lock, has_news);
            }
            if (is_ending_) break;
            job.swap(next_);
            probes.swap(probes_);
        }
        const bool is_new = job && job->model != last_.model;
        if (job) last_ = *job;
        for (const Probe& probe : probes) answer(probe, last_);
        if (job) work(*job);
        has_worked = true;
        progress_.set({}, 0);
        {
            const std::scoped_lock lock(mutex_);
            context_.reset();
        }
        wake_();
        if (is_new) release_free_memory();
    }
    if (gl_) gl_->end();
}

/// The passes of a job; what is outdated is left.
void Painter::work(const PaintJob& job) {
    const bool in_passes = comes_in_passes(job.look.request);
    const double coarse =
        pace_.scale(double(job.width) * double(job.height), in_passes ? motion_of_paths_ms : motion_ms);
    const int samples = job.look.request.settings.samples;
    if (job.is_playing) {
        const bool is_fast = pace_.allows(double(job.width) * double(job.height), samples, motion_ms);
        paint_pass(job, coarse, is_fast && !in_passes ? samples : 1, false);
        return;
    }
    const bool is_coarse_first = job.is_moving || coarse < 0.6;
    if (is_coarse_first && !paint_pass(job, coarse, 1, false)) return;
    if (job.is_moving || is_outdated(job)) return;
    if (samples > 1 && !in_passes && (!paint_pass(job, 1, 1, false) || is_outdated(job))) return;
    paint_pass(job, 1, samples, true);
}

bool Painter::paint_pass(const PaintJob& job, double scale, int samples, bool is_final) {
    // A picture in motion is always drawn to its end. Otherwise nothing would be shown while new jobs come.
    const bool is_refinement = !job.is_moving && scale == 1;
    const std::shared_ptr<Context> context = new_context(is_refinement);
    const auto begin = std::chrono::steady_clock::now();
    try {
        auto painting = std::make_shared<Painting>();
        painting->request = request_of(job.look, job.width, job.height);
        painting->camera = camera_of(job.look, *job.model, job.width, job.height);
        PictureRequest request = painting->request;
        is_in_gl_ = false;
        request.settings.width = scaled(job.width, scale);
        request.settings.height = scaled(job.height, scale);
        request.settings.samples = job.look.channel ? 1 : samples;
        request.settings.channels = job.look.channel;
        if (scale < 1) scale_marks(request.settings, scale);
        painting->width = request.settings.width, painting->height = request.settings.height;
        const Outcome by_gl = draw_by_gl(job, request, scale, *painting, *context);
        if (by_gl == Outcome::outdated) return false;
        if (by_gl == Outcome::cannot) draw_by_session(job, request, *painting, *context);
        painting->model = job.model;
        painting->number = job.number;
        painting->is_whole = scale == 1, painting->is_final = is_final;
        painting->ms = ms_since(begin);
        painting->warnings = warnings_of(*context);
        if (samples == 1 || job.is_playing) note_pace(pace_, *painting, samples);
        const std::scoped_lock lock(mutex_);
        painting_ = std::move(painting);
    } catch (...) {
        const Error error = current_error();
        const std::scoped_lock lock(mutex_);
        const bool is_broken_off = context->cancelled() && may_break_off_;
        const bool is_of_gl = is_in_gl_ && error.code() == ErrorCode::failed && !context->cancelled();
        if (!is_broken_off && !is_ending_) fault_ = {job.number, error, is_of_gl};
        return false;
    }
    wake_();
    return true;
}

void Painter::draw_by_session(const PaintJob& job, const PictureRequest& request, Painting& to, Context& context) {
    is_in_gl_ = false;
    const Shot shot = studio_->plan(job.model, job.look, request, to.camera, context);
    const std::uint32_t wished = job.wants_depth ? std::uint32_t(channel_depth) : 0u;
    const auto begin = std::chrono::steady_clock::now();
    PassSink sink([&](const Frame& frame, int samples) {
        if (job.look.channel || samples >= request.settings.samples) return;
        auto painting = std::make_shared<Painting>(to);
        painting->model = job.model, painting->number = job.number, painting->prepared = studio_->prepared();
        painting->is_whole = true, painting->stats.rays.samples = samples, painting->ms = ms_since(begin);
        painting->codes = to_srgb8(frame, request.tone, shot.behind), painting->depth = frame.depth;
        {
            const std::scoped_lock lock(mutex_);
            if (next_) return;
            painting_ = std::move(painting);
        }
        wake_();
    });
    to.stats = studio_->draw(shot, wished, sink, context);
    Frame& frame = sink.frame();
    to.prepared = studio_->prepared();
    to.codes = job.look.channel
                   ? channel_codes(frame, job.look.channel, channel_range_of(job.model->box.bounds(), to.camera))
                   : to_srgb8(frame, request.tone, shot.behind);
    to.depth = std::move(frame.depth);
}

/// Draws with GlView. What that cannot do is left to a session, which reports what it cannot do either.
Painter::Outcome Painter::draw_by_gl(const PaintJob& job, const PictureRequest& request, double scale, Painting& to,
                                     Context& context) {
    if (!job.gl || job.look.channel) return Outcome::cannot;
    PictureRequest to_prepare = request;
    to_prepare.engine = "soft";  // scenes are prepared alike for every engine
    const Shot shot = studio_->plan(job.model, job.look, to_prepare, to.camera, context);
    studio_->prepare(shot, context);
    const std::shared_ptr<const PreparedScene> scene = studio_->prepared();
    is_in_gl_ = true;
    if (gl_ && gl_ != job.gl) gl_->end();
    gl_ = job.gl;
    if (!take_up_by_gl(job, scene, context)) return Outcome::outdated;
    context.progress("render", 0);
    to.prepared = gl_->scene();
    std::vector<Line> lines =
        mark_lines_.lines(job.marks, job.look, *job.model, to.prepared, to.camera, job.width, job.height);
    for (Line& line : lines) line.width_px *= float(scale);
    try {
        GlPainter::Drawn drawn = gl_->draw(shot, request.tone, lines, context);
        to.picture = std::move(drawn.picture);
        to.stats = std::move(drawn.stats);
        to.pixels_ms = drawn.ms;
    } catch (const Error& error) {
        if (error.code() == ErrorCode::usage) return Outcome::cannot;
        throw;
    }
    return Outcome::drawn;
}

/// False: another job waits, and nothing can be drawn of this one. Its scene stays on its way.
bool Painter::take_up_by_gl(const PaintJob& job, const std::shared_ptr<const PreparedScene>& scene, Context& context) {
    const auto begin = std::chrono::steady_clock::now();
    Context not_broken_off({.threads = threads_, .max_memory = max_memory_});  // jobs are, their scenes are not
    while (!gl_->upload(scene, upload_slice_ms, not_broken_off)) {
        if (job.is_playing && gl_model_ == job.model) {  // the pose is what is to be seen
            context.throw_if_cancelled();
            continue;
        }
        if (is_outdated(job)) return false;
        const bool can_show_motion = job.is_moving && gl_->scene() && gl_model_ == job.model;
        if (can_show_motion) return true;  // the scene before, seen from where the camera is now
        context.throw_if_cancelled();
        if (ms_since(begin) > told_after_ms) context.progress("upload", 0);
    }
    gl_model_ = job.model;
    return true;
}

void Painter::answer(const Probe& probe, const PaintJob& job) {
    std::optional<Hit> hit;
    if (job.model) try {
            PictureRequest request = request_of(job.look, job.width, job.height);
            request.engine = "soft";
            request.settings.window = {std::clamp(probe.x, 0, job.width - 1), std::clamp(probe.y, 0, job.height - 1), 1,
                                       1};
            request.settings.channels = channel_position | channel_object | channel_material;
            request.settings.samples = 1;
            Frame frame;
            const Camera camera = camera_of(job.look, *job.model, job.width, job.height);
            const std::shared_ptr<Context> context = new_context(false);
            studio_->draw(studio_->plan(job.model, job.look, request, camera, *context), 0, frame, *context);
            if (frame.object.at(0) != no_index) {
                const vec3 p = frame.position.at(0);
                hit = Hit{{p.x, p.y, p.z}, frame.object[0], frame.material.at(0)};
            }
        } catch (...) {
            hit.reset();  // the picture says what is wrong
        }
    const std::scoped_lock lock(mutex_);
    answers_.push_back([done = probe.done, hit] { done(hit); });
}

}  // namespace rakelight::viewer
