// SPDX-License-Identifier: Apache-2.0
// The threads of a context: oneTBB's (arena_tbb.cpp); or, where RAKELIGHT_THREADS is off, the calling one alone
// (arena_serial.cpp).
#pragma once
#include <cstddef>
#include <memory>

#include <rakelight/base/context.h>

namespace rakelight {

/// The threads that a context gets. @param requested  0: as many as there are for this process
int usable_threads(int requested);

/// More than one thread.
struct Context::Arena {
    explicit Arena(int threads);
    Arena(const Arena&) = delete;
    Arena& operator=(const Arena&) = delete;
    ~Arena();
    /// As Context::parallel_for().
    void run(const Context& context, std::size_t count, void (*call)(const void*, std::size_t), const void* body);

private:
    struct Threads;
    std::unique_ptr<Threads> threads_;
};

}  // namespace rakelight
