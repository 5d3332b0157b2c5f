// SPDX-License-Identifier: Apache-2.0
// How long pictures in motion take to come.
#pragma once
#include <chrono>
#include <cstdint>
#include <vector>

namespace rakelight::viewer {

/// From the moment at which the window saw the motion to the moment at which the first picture of it, or of a later one, is on the
/// screen.
class MotionTimes {
public:
    using Clock = std::chrono::steady_clock;

    /// A picture was requested. @param number  grows, as PaintJob::number has it
    void asked(std::uint64_t number, Clock::time_point at);
    /// A picture is on the screen: it answers all that were requested up to it.
    void displayed(std::uint64_t number, Clock::time_point at);

    std::size_t count() const { return ms_.size(); }
    /// [ms]; 0 where there is none. @param share  0: the shortest, 0.5: the median, 1: the longest
    double quantile_ms(double share) const;

private:
    struct Asked {
        std::uint64_t number;
        Clock::time_point at;
    };
    std::vector<Asked> asked_;  ///< not answered yet, in order
    std::vector<double> ms_;
};

}  // namespace rakelight::viewer
