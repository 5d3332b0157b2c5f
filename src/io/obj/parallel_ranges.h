// SPDX-License-Identifier: Apache-2.0
// Long arrays in parts that several threads take.
#pragma once
#include <algorithm>
#include <cstddef>

#include <rakelight/base/context.h>

namespace rakelight::io::obj {

/// Calls body(begin, end) for parts of 0..count, whose size does not depend on the number of threads.
template <class Body>
void parallel_ranges(std::size_t count, Context& context, const Body& body) {
    constexpr std::size_t part = 1 << 15;
    context.parallel_for((count + part - 1) / part,
                         [&](std::size_t i) { body(i * part, std::min(count, (i + 1) * part)); });
}

}  // namespace rakelight::io::obj
