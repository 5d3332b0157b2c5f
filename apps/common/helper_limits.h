// SPDX-License-Identifier: Apache-2.0
// Resource limits of helper programs, set before the first foreign byte is read, not inherited.
#pragma once
#include <cstdint>

namespace rakelight::apps {

/// No more address space than `memory_bytes`, no more processor time than `seconds`, no core file, no written file, few
/// descriptors, no privileges by exec, and death with the parent.
void limit_this_process(std::uint64_t memory_bytes, std::uint64_t seconds);

}  // namespace rakelight::apps
