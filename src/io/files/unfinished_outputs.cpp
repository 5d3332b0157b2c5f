// SPDX-License-Identifier: Apache-2.0
#include "io/files/unfinished_outputs.h"

#include <rakelight_internal/io/unfinished_outputs.h>

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <iterator>

namespace rakelight {
namespace {

// A lock would stop a signal handler that comes while it is held. Whoever takes a name out of its place owns it: the
// handler keeps what it took until it is done with it, so that no name is freed while it is read.
using Table = std::atomic<char*>[256];
Table unfinished, removed;  // removed: what the handler is done with, which the owner frees
static_assert(std::atomic<char*>::is_always_lock_free, "a signal handler may use it");

/// @return false: there is no room
bool put(char* path, Table& table) noexcept {
    for (std::atomic<char*>& place : table)
        if (char* nobody = nullptr; place.compare_exchange_strong(nobody, path)) return true;
    return false;
}

bool take(char* path, Table& table) noexcept {
    for (std::atomic<char*>& place : table)
        if (char* mine = path; place.compare_exchange_strong(mine, nullptr)) return true;
    return false;
}

}  // namespace

void remove_unfinished_outputs() noexcept {
    char* folders[std::size(unfinished)];  // empty only when the files in them are gone
    std::size_t count = 0;
    for (std::atomic<char*>& place : unfinished) {
        char* const path = place.exchange(nullptr);
        if (path && ::unlink(path) == 0)
            put(path, removed);
        else if (path)
            folders[count++] = path;
    }
    while (count > 0) {
        ::rmdir(folders[--count]);
        put(folders[count], removed);
    }
}

namespace io {

void UnfinishedOutput::watch(const std::string& path) {
    forget();
    path_ = ::strdup(path.c_str());
    if (path_ && put(path_, unfinished)) return;
    std::free(path_);
    path_ = nullptr;
}

void UnfinishedOutput::forget() noexcept {
    if (path_ && (take(path_, unfinished) || take(path_, removed))) std::free(path_);
    path_ = nullptr;
}

}  // namespace io
}  // namespace rakelight
