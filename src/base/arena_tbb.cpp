// SPDX-License-Identifier: Apache-2.0
#include "base/arena.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>
#include <vector>
#if defined(__SANITIZE_THREAD__)
#include <exception>
#include <thread>
#endif

namespace rakelight {
namespace {

#if defined(__SANITIZE_THREAD__)
/// The thread sanitizer does not see the synchronization inside oneTBB, which is built without it, and reports false
/// races. In sanitizer builds loops run on plain threads.
void run_on_plain_threads(const Context& context, std::size_t count, void (*call)(const void*, std::size_t),
                          const void* body) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr error;
    std::mutex error_mutex;
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++) {
                context.throw_if_cancelled();
                call(body, i);
            }
        } catch (...) {
            const std::lock_guard lock(error_mutex);
            if (!error) error = std::current_exception();
            next = count;
        }
    };
    std::vector<std::thread> others;
    for (int t = 1; t < context.threads(); ++t) others.emplace_back(work);
    work();
    for (std::thread& t : others) t.join();
    if (error) std::rethrow_exception(error);
}
#endif

/// Arenas that no context uses at the moment. oneTBB 2021 keeps 7 KiB of each destroyed arena, so the memory of a program
/// that makes a context for each call would grow without limit.
class SpareArenas {
public:
    std::unique_ptr<tbb::task_arena> take(int threads) {
        const std::lock_guard lock(mutex_);
        std::vector<std::unique_ptr<tbb::task_arena>>& of = by_threads_[threads];
        if (of.empty()) return std::make_unique<tbb::task_arena>(threads);
        std::unique_ptr<tbb::task_arena> arena = std::move(of.back());
        of.pop_back();
        return arena;
    }
    void give(int threads, std::unique_ptr<tbb::task_arena> arena) noexcept {
        try {
            const std::lock_guard lock(mutex_);
            by_threads_[threads].push_back(std::move(arena));
        } catch (...) {  // no memory for the list: the arena ends
        }
    }
    /// Never destroyed, because contexts may outlive static objects.
    static SpareArenas& all() {
        static SpareArenas& arenas = *new SpareArenas;
        return arenas;
    }

private:
    std::mutex mutex_;
    std::map<int, std::vector<std::unique_ptr<tbb::task_arena>>> by_threads_;
};

}  // namespace

struct Context::Arena::Threads {
    // Without the control oneTBB writes a warning to standard error when more threads are requested than there are
    // cores.
    explicit Threads(int of)
        : count(of),
          control(tbb::global_control::max_allowed_parallelism,
                  std::size_t(std::max(count, tbb::this_task_arena::max_concurrency()))),
          arena(SpareArenas::all().take(count)) {}
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
    ~Threads() { SpareArenas::all().give(count, std::move(arena)); }
    int count;
    tbb::global_control control;
    std::unique_ptr<tbb::task_arena> arena;
};

int usable_threads(int requested) { return requested == 0 ? tbb::this_task_arena::max_concurrency() : requested; }

Context::Arena::Arena(int threads) : threads_(std::make_unique<Threads>(threads)) {}
Context::Arena::~Arena() = default;

void Context::Arena::run(const Context& context, std::size_t count, void (*call)(const void*, std::size_t),
                         const void* body) {
#if defined(__SANITIZE_THREAD__)
    run_on_plain_threads(context, count, call, body);
#else
    threads_->arena->execute([=, &context] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1),
                          [=, &context](const tbb::blocked_range<std::size_t>& range) {
                              for (std::size_t i = range.begin(); i != range.end(); ++i) {
                                  context.throw_if_cancelled();
                                  call(body, i);
                              }
                          });
    });
#endif
}

}  // namespace rakelight
