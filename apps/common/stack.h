// SPDX-License-Identifier: Apache-2.0
// A stack that is large enough whatever `ulimit -s` says: with 64 KiB the program would end by SIGSEGV.
#pragma once
#include <functional>

namespace rakelight::apps {

/// Runs `work`, which throws nothing; on a thread of its own where the stack of the process is small. Threads that are
/// started later, and as far as the system permits it programs too, have a large stack then.
int with_enough_stack(const std::function<int()>& work);

}  // namespace rakelight::apps
