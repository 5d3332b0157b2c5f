// SPDX-License-Identifier: Apache-2.0
// Cancelling long loops that do not run in parallel; Context::parallel_for() looks by itself.
#pragma once
#include <cstdint>

#include <rakelight/context.h>

namespace rakelight {

/// To be called once for each item of a loop: every 16384th call looks whether the run is cancelled.
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
