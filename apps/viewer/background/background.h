// SPDX-License-Identifier: Apache-2.0
// Work beside the window's thread: loading, inspecting, smoothing, saving.
#pragma once
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <rakelight/base/context.h>

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

/// "load 40 %"; empty: nothing runs, or the stage that is left out.
std::string to_text(const Progress& progress, std::string_view left_out = {});

/// Runs one work at a time in a thread.
class Background {
public:
    /// @param wake  called from the thread when there is something new to see
    /// @param threads, max_memory, parent  as ContextOptions
    Background(std::function<void()> wake, int threads, std::uint64_t max_memory, const Context* parent = nullptr);
    ~Background();
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    /// Work that returns a function for the window's thread; what it throws is passed to `failed`, there too.
    using Finish = std::function<void()>;
    using Work = std::function<Finish(Context&)>;
    using Failed = std::function<void(const Error&)>;
    /// Replaces the work before, which is cancelled without waiting for its end.
    void start(const std::string& title, Work work, Failed failed);
    /// Begins when what was given before has ended.
    void queue(const std::string& title, Work work, Failed failed);
    /// In the window's thread: finishes what is done, and begins what comes next.
    void poll();
    /// The running work ends with the error "cancelled"; waiting work never begins. @return how many waited
    std::size_t cancel();
    /// Cancels, and waits until nothing runs: `wake` is called no more.
    void end();
    bool is_running() const { return current_ || !waiting_.empty(); }
    std::size_t waiting() const { return waiting_.size(); }
    const Progress& progress() const { return progress_; }

private:
    struct Run;
    struct Job {
        std::string title;
        Work work;
        Failed failed;
    };
    void begin(Job job);
    void begin_next();
    void run(Run& run);

    std::function<void()> wake_;
    int threads_;
    std::uint64_t max_memory_;
    const Context* parent_;
    Progress progress_;
    Run* current_ = nullptr;                  ///< the newest of runs_; null: its end was polled
    std::vector<std::unique_ptr<Run>> runs_;  ///< those before it were cancelled
    std::deque<Job> waiting_;
};

}  // namespace rakelight::viewer
