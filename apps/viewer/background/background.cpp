// SPDX-License-Identifier: Apache-2.0
#include "background.h"

#include <atomic>
#include <thread>

#include <rakelight/base/current_error.h>

namespace rakelight::viewer {

void Progress::set(std::string_view stage, double fraction) {
    const std::scoped_lock lock(mutex_);
    stage_ = stage;
    fraction_ = fraction;
}

void Progress::get(std::string& stage, double& fraction) const {
    const std::scoped_lock lock(mutex_);
    stage = stage_;
    fraction = fraction_;
}

std::string to_text(const Progress& progress, std::string_view left_out) {
    std::string stage;
    double fraction = 0;
    progress.get(stage, fraction);
    return stage.empty() || stage == left_out ? std::string()
                                              : stage + " " + std::to_string(int(100 * fraction)) + " %";
}

struct Background::Run {
    Work work;
    Failed failed;
    std::unique_ptr<Context> context;
    Finish finish{};
    std::atomic<bool> is_done{false};  ///< set last: `finish` is there
    std::thread thread{};
};

Background::Background(std::function<void()> wake, int threads, std::uint64_t max_memory, const Context* parent)
    : wake_(std::move(wake)), threads_(threads), max_memory_(max_memory), parent_(parent) {}

Background::~Background() { end(); }

void Background::end() {
    for (const auto& run : runs_) run->context->cancel();
    for (const auto& run : runs_) run->thread.join();
    runs_.clear();
    waiting_.clear();
    current_ = nullptr;
}

void Background::start(const std::string& title, Work work, Failed failed) {
    cancel();
    begin({title, std::move(work), std::move(failed)});
}

void Background::queue(const std::string& title, Work work, Failed failed) {
    waiting_.push_back({title, std::move(work), std::move(failed)});
    begin_next();
}

void Background::begin_next() {
    if (current_ || waiting_.empty()) return;
    Job next = std::move(waiting_.front());
    waiting_.pop_front();
    begin(std::move(next));
}

void Background::begin(Job job) {
    progress_.set(job.title, 0);
    const auto report = [this](std::string_view stage, double fraction) { progress_.set(stage, fraction); };
    auto context = std::make_unique<Context>(
        ContextOptions{.threads = threads_, .max_memory = max_memory_, .progress = report, .parent = parent_});
    current_ = runs_.emplace_back(new Run{std::move(job.work), std::move(job.failed), std::move(context)}).get();
    current_->thread = std::thread([this, run = current_] { this->run(*run); });
}

void Background::run(Run& run) {
    try {
        run.finish = run.work(*run.context);
    } catch (...) {
        run.finish = [failed = run.failed, error = current_error()] { failed(error); };
    }
    run.is_done = true;
    wake_();
}

void Background::poll() {
    Finish finish;
    const auto end = [&](const std::unique_ptr<Run>& run) {
        if (!run->is_done) return false;
        run->thread.join();
        if (run.get() != current_) return true;  // another work took its place
        finish = std::move(run->finish);
        current_ = nullptr;
        return true;
    };
    std::erase_if(runs_, end);
    if (!finish) return;
    progress_.set({}, 0);
    finish();
    begin_next();
}

std::size_t Background::cancel() {
    const std::size_t waited = waiting_.size();
    waiting_.clear();
    if (current_) current_->context->cancel();
    return waited;
}

}  // namespace rakelight::viewer
