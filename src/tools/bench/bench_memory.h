// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

namespace rakelight {

/// How much more memory the process came to hold at most since this was made. Where the system does not tell: 0.
class MemoryPeak {
public:
    MemoryPeak();
    std::uint64_t bytes() const;

private:
    std::uint64_t start_ = 0;
};

}  // namespace rakelight
