// SPDX-License-Identifier: Apache-2.0
#include "motion_times.h"

#include <algorithm>
#include <cmath>

namespace rakelight::viewer {

void MotionTimes::asked(std::uint64_t number, Clock::time_point at) { asked_.push_back({number, at}); }

void MotionTimes::displayed(std::uint64_t number, Clock::time_point at) {
    std::erase_if(asked_, [&](const Asked& a) {
        if (a.number > number) return false;
        ms_.push_back(std::chrono::duration<double, std::milli>(at - a.at).count());
        return true;
    });
}

double MotionTimes::quantile_ms(double share) const {
    if (ms_.empty()) return 0;
    std::vector<double> sorted = ms_;
    std::ranges::sort(sorted);
    return sorted[std::size_t(std::lround(std::clamp(share, 0.0, 1.0) * double(sorted.size() - 1)))];
}

}  // namespace rakelight::viewer
