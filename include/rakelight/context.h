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

/// What a run may take, and who is told.
struct ContextOptions {
    int threads = 0;               ///< worker threads, the calling one included; 0: as many as the machine has. 1..1024
    std::uint64_t max_memory = 0;  ///< [bytes] limit for data that files ask for; 0: the default rule of MemoryBudget
    /// Called now and then with a stage ("load", "render") and how far it is, 0..1. From any thread, one call at a time.
    std::function<void(std::string_view stage, double fraction)> progress{};
    const Context* parent = nullptr;  ///< cancelling it cancels this one too; must outlive it
    /// Path of the program rakelight-import, which reads FBX, DAE, STL and other rare formats. Empty: that of the parent; else
    /// the environment's RAKELIGHT_IMPORT; else it is looked for beside the running program and where the library was installed.
    std::string import_helper{};
};

/// One per run; not copyable; every long function takes it by reference. Results never depend on the number of threads.
class RL_API Context {
public:
    explicit Context(ContextOptions options = {});  ///< @throws Error usage: threads out of range
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    int threads() const noexcept;  ///< >= 1
    /// What was changed, guessed or left out so far.
    Report& report() noexcept { return report_; }
    /// What files may ask for.
    MemoryBudget& memory() noexcept { return memory_; }

    /// Tells ContextOptions::progress. @param fraction  0..1 of the stage
    void progress(std::string_view stage, double fraction);
    /// What is reported from now on, 0..1, stands for this part of its stage. For work that is done in several goes.
    void set_progress_part(double from, double to);
    /// Ends each loop at its next item; from any thread.
    void cancel() noexcept { cancelled_ = true; }
    /// Whether it or its parent was cancelled.
    bool cancelled() const noexcept { return cancelled_ || (options_.parent && options_.parent->cancelled()); }
    void throw_if_cancelled() const;  ///< @throws Error failed "cancelled"
    /// Takes cancel() back, so that the next run can use this context. Only while nothing runs on it.
    void reset_cancel() noexcept { cancelled_ = false; }
    /// ContextOptions::import_helper, or that of the parent.
    const std::string& import_helper() const noexcept;

    /// Loaders tell of each file that they open. Textures are opened when they are decoded: EncodedImage::path names them.
    void note_file(const std::string& path);
    /// Those that were told of, each once, in their order; such as could not be read are among them.
    std::vector<std::string> files() const;

    /// Calls body(i) for every i in 0..count-1, on the context's threads, in any order, each once; returns when all are
    /// done. The first exception of a body is thrown again here. Bodies must not depend on one another; calls may nest.
    /// `body` is any callable; no copy of it is made.
    /// @throws Error failed "cancelled": what had not begun when the context was cancelled was not called.
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
