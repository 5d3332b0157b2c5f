// SPDX-License-Identifier: Apache-2.0
// Cancellation of long sequential loops; Context::parallel_for() checks by itself.
#pragma once
#include <cstdint>

#include <rakelight/base/context.h>

namespace rakelight {

/// Call it once per item of a loop: every 16384th call checks for cancellation.
class CancelCheck {
public:
    explicit CancelCheck(const Context& context) : context_(context) {}
    /// @throws Error failed "cancelled"
    void operator()() {
        if ((++calls_ & 16383) == 0) context_.throw_if_cancelled();
    }

private:
    const Context& context_;
    std::uint32_t calls_ = 0;
};

}  // namespace rakelight
