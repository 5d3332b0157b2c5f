// SPDX-License-Identifier: Apache-2.0
#include "background.h"

#include <rakelight/tools/current_error.h>

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

Background::Background(std::function<void()> wake, int threads, std::uint64_t max_memory)
    : wake_(std::move(wake)), threads_(threads), max_memory_(max_memory) {}

Background::~Background() {
    cancel();
    if (thread_.joinable()) thread_.join();
}

void Background::start(const std::string& title, Work work, std::function<void(const Error&)> failed) {
    cancel();
    if (thread_.joinable()) thread_.join();
    finish_.reset();
    title_ = title;
    progress_.set(title, 0);
    const auto report = [this](std::string_view stage, double fraction) { progress_.set(stage, fraction); };
    context_ = std::make_shared<Context>(
        ContextOptions{.threads = threads_, .max_memory = max_memory_, .progress = report});
    is_running_ = true;
    thread_ = std::thread([this, work = std::move(work), failed = std::move(failed), context = context_] {
        run(work, failed, context);
    });
}

void Background::run(const Work& work, const std::function<void(const Error&)>& failed,
                     const std::shared_ptr<Context>& context) {
    Finish finish;
    try {
        finish = work(*context);
    } catch (...) {
        finish = [failed, error = current_error()] { failed(error); };
    }
    {
        const std::scoped_lock lock(mutex_);
        finish_ = std::move(finish);
    }
    wake_();
}

void Background::poll() {
    std::optional<Finish> finish;
    {
        const std::scoped_lock lock(mutex_);
        finish.swap(finish_);
    }
    if (!finish) return;
    thread_.join();
    is_running_ = false;
    context_.reset();
    progress_.set({}, 0);
    if (*finish) (*finish)();
}

void Background::cancel() {
    if (context_) context_->cancel();
}

}  // namespace rakelight::viewer
