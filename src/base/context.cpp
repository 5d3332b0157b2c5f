// SPDX-License-Identifier: Apache-2.0
#include <rakelight/base/context.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/arena.h"

namespace rakelight {

struct Context::Files {
    std::mutex mutex;
    std::set<std::string, std::less<>> known;
    std::vector<std::string> in_order;
};

Context::Context(ContextOptions options)
    : options_(std::move(options)), memory_(options_.max_memory), files_(std::make_unique<Files>()) {
    if (options_.threads < 0 || options_.threads > 1024)
        throw Error(ErrorCode::usage, "threads must be 1 to 1024, or 0 for as many as the machine has");
    options_.threads = usable_threads(options_.threads);
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
    arena_->run(*this, count, call, body);
}

}  // namespace rakelight
