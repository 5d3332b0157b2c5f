// SPDX-License-Identifier: Apache-2.0
#include <cassert>

#include "base/arena.h"

namespace rakelight {

int usable_threads(int) { return 1; }

struct Context::Arena::Threads {};

// Nobody makes one: a context of one thread runs its loops itself.
Context::Arena::Arena(int) { assert(false); }
Context::Arena::~Arena() = default;
void Context::Arena::run(const Context&, std::size_t, void (*)(const void*, std::size_t), const void*) {}

}  // namespace rakelight
