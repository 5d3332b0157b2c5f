// SPDX-License-Identifier: Apache-2.0
// The run context that goes through every long function: threads, cancel, progress, memory budget, report.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include <rakelight/error.h>
#include <rakelight/report.h>

namespace rakelight {

/// How much memory the data of untrusted files may ask for: 2 GiB, or 64 bytes for each byte read where that is more, or
/// what the user allows. Thread-safe.
class MemoryBudget {
public:
    explicit MemoryBudget(std::uint64_t max_bytes = 0) : max_bytes_(max_bytes) {}
    /// Tells how many bytes were read from files; raises the allowance.
    void note_read(std::uint64_t bytes) noexcept { read_bytes_ += bytes; }
    /// To be called before memory is asked for whose size a file decides.
    /// @throws Error bad_file "WHAT needs N bytes, more than the limit of M"; advice: --max-memory. Nothing is charged then.
    void charge(std::uint64_t bytes, std::string_view what);
    /// Checks a size without keeping it: for buffers that live only for a moment.
    void check(std::uint64_t bytes, std::string_view what) const;
    /// Gives back what was charged for something that is gone.
    void release(std::uint64_t bytes) noexcept { *charged_ -= bytes; }
    std::uint64_t charged() const noexcept { return *charged_; }
    /// Whether all charges and checks so far would have been granted in any order. If not, what several threads asked for
    /// depended on chance and must be asked for again one after another.
    bool grants_in_any_order() const noexcept;
    /// The limit in force now [bytes].
    std::uint64_t limit() const noexcept;

private:
    friend class MemoryCharge;
    void require(std::uint64_t charged, std::uint64_t bytes, std::string_view what) const;
    std::uint64_t max_bytes_;  // 0: the default rule
    std::atomic<std::uint64_t> read_bytes_{0};
    std::shared_ptr<std::atomic<std::uint64_t>> charged_ = std::make_shared<std::atomic<std::uint64_t>>(0);
    mutable std::atomic<std::uint64_t> largest_check_{0};
    mutable std::atomic<bool> has_refused_{false};
};

/// Bytes that stay charged while this lives; it may outlive the budget. For what is kept from call to call.
class MemoryCharge {
public:
    MemoryCharge() = default;
    /// @throws Error bad_file, as MemoryBudget::charge()
    MemoryCharge(MemoryBudget& budget, std::uint64_t bytes, std::string_view what);
    MemoryCharge(MemoryCharge&& from) noexcept;
    MemoryCharge& operator=(MemoryCharge&& from) noexcept;
    ~MemoryCharge();
    std::uint64_t bytes() const noexcept { return bytes_; }

private:
    std::shared_ptr<std::atomic<std::uint64_t>> charged_;  ///< of the budget
    std::uint64_t bytes_ = 0;
};

struct ContextOptions {
    int threads = 0;               ///< worker threads, the calling one included; 0: as many as the machine has. 1..1024
    std::uint64_t max_memory = 0;  ///< [bytes] limit for data that files ask for; 0: the default rule of MemoryBudget
    /// Called now and then with a stage ("load", "render") and how far it is, 0..1. From any thread, one call at a time.
    std::function<void(std::string_view stage, double fraction)> progress;
};

/// One per run; not copyable; every long function takes it by reference. Results never depend on the number of threads.
class Context {
public:
    explicit Context(ContextOptions options = {});
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    int threads() const noexcept;  ///< >= 1
    Report& report() noexcept { return report_; }
    MemoryBudget& memory() noexcept { return memory_; }

    void progress(std::string_view stage, double fraction);
    /// What is reported from now on, 0..1, stands for this part of its stage. For work that is done in several goes.
    void set_progress_part(double from, double to);
    void cancel() noexcept { cancelled_ = true; }
    bool cancelled() const noexcept { return cancelled_; }
    void throw_if_cancelled() const;  ///< @throws Error failed "cancelled"

    /// Calls body(i) for every i in 0..count-1, on the context's threads, in any order, each once; returns when all are
    /// done. The first exception of a body is thrown again here. Bodies must not depend on one another; calls may nest.
    /// `body` is any callable; no copy of it is made.
    template <class Body>
    void parallel_for(std::size_t count, const Body& body) {
        run_parallel(count, [](const void* b, std::size_t i) { (*static_cast<const Body*>(b))(i); }, &body);
    }

private:
    void run_parallel(std::size_t count, void (*call)(const void*, std::size_t), const void* body);
    struct Arena;
    ContextOptions options_;
    Report report_;
    MemoryBudget memory_;
    std::atomic<bool> cancelled_{false};
    std::mutex progress_mutex_;
    double progress_from_ = 0, progress_to_ = 1;
    std::unique_ptr<Arena> arena_;
};

}  // namespace rakelight
