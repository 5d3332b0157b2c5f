// SPDX-License-Identifier: Apache-2.0
// Memory that is charged to the budget only as long as a scope lasts.
#pragma once
#include <rakelight/context.h>

namespace rakelight {

/// What is charged while it lives is given back at its end, by an exception too. For work that nothing else charges
/// beside.
class TemporaryCharges {
public:
    explicit TemporaryCharges(MemoryBudget& memory) : memory_(memory), before_(memory.charged()) {}
    ~TemporaryCharges() {
        if (memory_.charged() > before_) memory_.release(memory_.charged() - before_);
    }
    TemporaryCharges(const TemporaryCharges&) = delete;
    TemporaryCharges& operator=(const TemporaryCharges&) = delete;

private:
    MemoryBudget& memory_;
    std::uint64_t before_;
};

}  // namespace rakelight
