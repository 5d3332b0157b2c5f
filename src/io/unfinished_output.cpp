// SPDX-License-Identifier: Apache-2.0
#include "io/unfinished_output.h"

#include <rakelight/unfinished_outputs.h>

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <iterator>

namespace rakelight {
namespace {

// A lock would stop a signal handler that comes while it is held. Whoever takes a name out of its place owns it: the
// handler keeps what it took, so that no name is freed while it is read.
std::atomic<char*> unfinished[256];
static_assert(std::atomic<char*>::is_always_lock_free, "a signal handler may use it");

}  // namespace

void remove_unfinished_outputs() noexcept {
    const char* folders[std::size(unfinished)];  // empty only when the files in them are gone
    std::size_t count = 0;
    for (std::atomic<char*>& place : unfinished)
        if (const char* path = place.exchange(nullptr); path && ::unlink(path) != 0) folders[count++] = path;
    while (count > 0) ::rmdir(folders[--count]);
}

namespace io {

void UnfinishedOutput::watch(const std::string& path) {
    forget();
    path_ = ::strdup(path.c_str());
    for (std::atomic<char*>& place : unfinished)
        if (char* nobody = nullptr; path_ && place.compare_exchange_strong(nobody, path_)) return;
    std::free(path_);
    path_ = nullptr;
}

void UnfinishedOutput::forget() noexcept {
    for (std::atomic<char*>& place : unfinished)
        if (char* mine = path_; path_ && place.compare_exchange_strong(mine, nullptr)) {
            std::free(path_);
            break;
        }
    path_ = nullptr;
}

}  // namespace io
}  // namespace rakelight
