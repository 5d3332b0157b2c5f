// SPDX-License-Identifier: Apache-2.0
// The run context that goes through every long function: threads, cancel, progress, memory budget, report.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/error.h>
#include <rakelight/export.h>
#include <rakelight/memory_budget.h>
#include <rakelight/report.h>

namespace rakelight {

class Context;

/// Resources of a run, and its progress callback.
struct ContextOptions {
    int threads = 0;               ///< worker threads including the calling one, 1..1024; 0: one per processor
    std::uint64_t max_memory = 0;  ///< [bytes] limit for data of files; 0: the default of MemoryBudget
    /// Called with a stage ("load", "render") and its progress 0..1. From any thread, one call at a time.
    std::function<void(std::string_view stage, double fraction)> progress{};
    const Context* parent = nullptr;  ///< its cancellation also cancels this context; must outlive it
    /// Path of the program rakelight-import, which reads FBX, DAE, STL and other formats. Empty: the parent's path,
    /// else the environment variable RAKELIGHT_IMPORT, else next to the running program, else where the library is
    /// installed.
    std::string import_helper{};
};

/// The context of one run, passed by reference to every long function. Results never depend on the number of threads.
class RL_API Context {
public:
    explicit Context(ContextOptions options = {});  ///< @throws Error usage: threads out of range
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    int threads() const noexcept;  ///< >= 1
    /// The remarks so far.
    Report& report() noexcept { return report_; }
    /// The memory budget for data of files.
    MemoryBudget& memory() noexcept { return memory_; }

    /// Calls ContextOptions::progress.
    /// @param fraction 0..1 of the stage
    void progress(std::string_view stage, double fraction);
    /// Maps progress 0..1 to this part of the stage, for work done in several rounds.
    void set_progress_range(double from, double to);
    /// Requests cancellation: each loop ends at its next item. From any thread.
    void cancel() noexcept { cancelled_ = true; }
    /// Whether it or its parent was cancelled.
    bool cancelled() const noexcept { return cancelled_ || (options_.parent && options_.parent->cancelled()); }
    void throw_if_cancelled() const;  ///< @throws Error failed "cancelled"
    /// Clears cancel() for the next run. Only while nothing runs on this context.
    void reset_cancel() noexcept { cancelled_ = false; }
    /// ContextOptions::import_helper, or the parent's.
    const std::string& import_helper() const noexcept;

    /// Records a file that a loader opens. Textures are opened when they are decoded: see EncodedImage::path.
    void note_file(const std::string& path);
    /// The recorded files in order, each once, including unreadable ones.
    std::vector<std::string> files() const;

    /// Calls body(i) for every i in 0..count-1, on the context's threads, in any order, each once; returns when all are
    /// done. The first exception of a body is rethrown here. Bodies must be independent; calls may nest. `body` is any
    /// callable and is not copied.
    /// @throws Error failed "cancelled": bodies that had not started were not called.
    template <class Body>
    void parallel_for(std::size_t count, const Body& body) {
        run_parallel(
            count, [](const void* b, std::size_t i) { (*static_cast<const Body*>(b))(i); }, &body);
    }

private:
    void run_parallel(std::size_t count, void (*call)(const void*, std::size_t), const void* body);
    struct Arena;
    struct Files;
    ContextOptions options_;
    Report report_;
    MemoryBudget memory_;
    std::atomic<bool> cancelled_{false};
    std::mutex progress_mutex_;
    double progress_from_ = 0, progress_to_ = 1;
    std::unique_ptr<Arena> arena_;
    std::unique_ptr<Files> files_;
};

}  // namespace rakelight
