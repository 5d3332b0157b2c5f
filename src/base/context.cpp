// SPDX-License-Identifier: Apache-2.0
#include <rakelight/base/context.h>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
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

struct Context::Arena {
    // Without the control oneTBB writes a warning to standard error when more threads are requested than there are
    // cores.
    explicit Arena(int count)
        : threads(count),
          control(tbb::global_control::max_allowed_parallelism,
                  std::size_t(std::max(threads, tbb::this_task_arena::max_concurrency()))),
          arena(SpareArenas::all().take(threads)) {}
    Arena(const Arena&) = delete;
    Arena& operator=(const Arena&) = delete;
    ~Arena() { SpareArenas::all().give(threads, std::move(arena)); }
    int threads;
    tbb::global_control control;
    std::unique_ptr<tbb::task_arena> arena;
};

struct Context::Files {
    std::mutex mutex;
    std::set<std::string, std::less<>> known;
    std::vector<std::string> in_order;
};

Context::Context(ContextOptions options)
    : options_(std::move(options)), memory_(options_.max_memory), files_(std::make_unique<Files>()) {
    if (options_.threads < 0 || options_.threads > 1024)
        throw Error(ErrorCode::usage, "threads must be 1 to 1024, or 0 for as many as the machine has");
    if (options_.threads == 0) options_.threads = tbb::this_task_arena::max_concurrency();
}

Context::~Context() = default;

int Context::threads() const noexcept { return options_.threads; }

void Context::progress(std::string_view stage, double fraction) {
    if (!options_.progress) return;
    const std::lock_guard lock(progress_mutex_);
    options_.progress(stage, progress_from_ + (progress_to_ - progress_from_) * fraction);
}

void Context::set_progress_range(double from, double to) {
    const std::lock_guard lock(progress_mutex_);
    progress_from_ = from;
    progress_to_ = to;
}

void Context::note_file(const std::string& path) {
    const std::lock_guard lock(files_->mutex);
    if (files_->known.insert(path).second) files_->in_order.push_back(path);
}

std::vector<std::string> Context::files() const {
    const std::lock_guard lock(files_->mutex);
    return files_->in_order;
}

const std::string& Context::import_helper() const noexcept {
    return options_.import_helper.empty() && options_.parent ? options_.parent->import_helper()
                                                             : options_.import_helper;
}

void Context::throw_if_cancelled() const {
    if (cancelled()) throw Error(ErrorCode::failed, "cancelled");
}

void Context::run_parallel(std::size_t count, void (*call)(const void*, std::size_t), const void* body) {
    if (options_.threads == 1 || count <= 1) {
        for (std::size_t i = 0; i < count; ++i) {
            throw_if_cancelled();
            call(body, i);
        }
        return;
    }
    {
        const std::lock_guard lock(progress_mutex_);
        if (!arena_) arena_ = std::make_unique<Arena>(options_.threads);
    }
#if defined(__SANITIZE_THREAD__)
    run_on_plain_threads(*this, count, call, body);
#else
    arena_->arena->execute([=, this] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1),
                          [=, this](const tbb::blocked_range<std::size_t>& range) {
                              for (std::size_t i = range.begin(); i != range.end(); ++i) {
                                  throw_if_cancelled();
                                  call(body, i);
                              }
                          });
    });
#endif
}

}  // namespace rakelight
