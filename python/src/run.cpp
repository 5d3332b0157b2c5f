// SPDX-License-Identifier: Apache-2.0
#include "run.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <thread>

namespace rakelight::python {
namespace {

constexpr auto between_looks = std::chrono::milliseconds(50);  ///< at signals and progress

/// Work on a thread, and when it is done.
class Work {
public:
    explicit Work(const std::function<void()>& work)
        : thread_([this, &work] {
              try {
                  work();
              } catch (...) {
                  error_ = std::current_exception();
              }
              const std::lock_guard lock(mutex_);
              is_done_ = true;
              done_.notify_all();
          }) {}

    bool wait() {
        std::unique_lock lock(mutex_);
        return done_.wait_for(lock, between_looks, [this] { return is_done_; });
    }
    /// @return what it threw
    std::exception_ptr join() {
        thread_.join();
        return error_;
    }

private:
    std::mutex mutex_;
    std::condition_variable done_;
    bool is_done_ = false;
    std::exception_ptr error_;
    std::thread thread_;  // last: it uses the others
};

}  // namespace

Runner::Runner(int threads, std::uint64_t max_memory) {
    ContextOptions options;
    options.threads = threads;
    options.max_memory = max_memory;
    options.progress = [p = progress_](std::string_view stage, double fraction) {
        const std::lock_guard lock(p->mutex);
        p->stage = stage, p->fraction = fraction, p->is_new = true;
    };
    context_ = std::make_unique<Context>(std::move(options));
}

void Runner::tell(const py::object& progress) {
    std::string stage;
    double fraction = 0;
    {
        const std::lock_guard lock(progress_->mutex);
        if (!progress_->is_new) return;
        stage = progress_->stage, fraction = progress_->fraction, progress_->is_new = false;
    }
    progress(stage, fraction);
}

void Runner::run_on_thread(const py::object& progress, const std::function<void()>& work) {
    Work running(work);
    const bool tells = progress && !progress.is_none();
    std::exception_ptr interruption;
    for (bool is_done = false; !is_done;) {
        {
            const py::gil_scoped_release unlocked;
            is_done = running.wait();
        }
        if (interruption) continue;  // it is cancelled: the rest is waiting
        try {
            if (PyErr_CheckSignals() != 0) throw py::error_already_set();
            if (tells) tell(progress);
        } catch (py::error_already_set&) {
            interruption = std::current_exception();
            context_->cancel();
        }
    }
    const std::exception_ptr error = running.join();
    context_->reset_cancel();
    if (interruption) std::rethrow_exception(interruption);
    if (error) std::rethrow_exception(error);
}

}  // namespace rakelight::python
