// SPDX-License-Identifier: Apache-2.0
// Work on a thread of its own. In a build without threads it is done at once.
#pragma once
#include <future>
#include <utility>

namespace rakelight {

/// @returns what the work returns or throws
template <class Work>
auto start_apart(Work work) {
#if RL_THREADS
    return std::async(std::launch::async, std::move(work));
#else
    std::packaged_task<decltype(work())()> task(std::move(work));
    auto result = task.get_future();
    task();
    return result;
#endif
}

}  // namespace rakelight
