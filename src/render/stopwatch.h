// SPDX-License-Identifier: Apache-2.0
// Milliseconds since a moment.
#pragma once
#include <chrono>

namespace rakelight {

class Stopwatch {
public:
    double ms() const { return std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }
    /// The time since the last lap, which begins a new one.
    double lap_ms() {
        const double passed = ms();
        start_ = Clock::now();
        return passed;
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace rakelight
