// SPDX-License-Identifier: Apache-2.0
// One piece of work beside the window's thread: loading, inspecting, smoothing, saving.
#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <rakelight/context.h>

namespace rakelight::viewer {

/// How far something is, for the window to show. Thread-safe.
class Progress {
public:
    void set(std::string_view stage, double fraction);
    /// Empty stage: nothing runs.
    void get(std::string& stage, double& fraction) const;

private:
    mutable std::mutex mutex_;
    std::string stage_;
    double fraction_ = 0;
};

/// Runs one work at a time in a thread. A new one cancels the one before, whose end nobody waits for.
class Background {
public:
    /// @param wake  called from the thread when there is something new to see
    /// @param threads, max_memory  as ContextOptions
    Background(std::function<void()> wake, int threads, std::uint64_t max_memory);
    ~Background();
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    /// Work that hands back what is to be done in the window's thread; what it throws is handed to `failed`, there too.
    using Finish = std::function<void()>;
    using Work = std::function<Finish(Context&)>;
    void start(const std::string& title, Work work, std::function<void(const Error&)> failed);
    /// In the window's thread: finishes what is done.
    void poll();
    void cancel();
    bool is_running() const { return current_ != nullptr; }
    const Progress& progress() const { return progress_; }

private:
    struct Run;
    void run(Run& run);

    std::function<void()> wake_;
    int threads_;
    std::uint64_t max_memory_;
    Progress progress_;
    Run* current_ = nullptr;                  ///< the newest of runs_; null: its end was polled
    std::vector<std::unique_ptr<Run>> runs_;  ///< those before it were cancelled
};

}  // namespace rakelight::viewer
