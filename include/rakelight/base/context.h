// SPDX-License-Identifier: Apache-2.0
// The context of a run, passed to every long function: threads, cancellation, progress, memory budget, report.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <rakelight/base/error.h>
#include <rakelight/base/export.h>
#include <rakelight/base/memory_budget.h>
#include <rakelight/base/report.h>

namespace rakelight {

class Context;

/// Resources of a run, and its progress callback.
struct ContextOptions {
    int threads = 0;               ///< worker threads including the calling one, 1..1024; 0: one per processor
    std::uint64_t max_memory = 0;  ///< [bytes] limit for data of files; 0: the default of MemoryBudget
    /// Called with a stage ("load", "render") and its progress 0..1. From any thread, one call at a time.
    std::function<void(std::string_view stage, double fraction)> progress{};
    /// Canceling the parent also cancels this context. The parent must outlive this context.
    const Context* parent = nullptr;
    /// Path of the program rakelight-import, which reads FBX, DAE and other formats. If the path is empty, these
    /// places are tried in order: the path of the parent, the environment variable RAKELIGHT_IMPORT, the folder of the
    /// running program, the folder where the library is installed.
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
    /// For work in several rounds: later calls of progress() with 0..1 are mapped to the range from..to of the stage.
    void set_progress_range(double from, double to);
    /// Requests cancellation: each loop ends at its next item. From any thread.
    void cancel() noexcept { cancelled_ = true; }
    /// Whether this context or its parent was cancelled.
    bool cancelled() const noexcept { return cancelled_ || (options_.parent && options_.parent->cancelled()); }
    void throw_if_cancelled() const;  ///< @throws Error failed "cancelled"
    /// Clears the cancellation for the next run. Call it only while nothing runs on this context.
    void reset_cancel() noexcept { cancelled_ = false; }
    /// ContextOptions::import_helper of this context or, if empty, of its parent.
    const std::string& import_helper() const noexcept;

    /// Records a file that a loader opens. Textures are not recorded, because they are opened later:
    /// EncodedImage::path.
    void note_file(const std::string& path);
    /// The recorded files in order, each once, including unreadable ones.
    std::vector<std::string> files() const;

    /// Calls body(i) once for every i in 0..count-1, on the context's threads, in any order. Returns when all calls
    /// have ended. If calls throw, the first exception is rethrown here. The calls must not depend on each other. A
    /// body may call parallel_for(). `body` is any callable and is not copied.
    /// @throws Error failed "cancelled": some bodies were not called
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
