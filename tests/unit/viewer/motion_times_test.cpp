// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/motion/motion_times.h"

#include <gtest/gtest.h>

namespace rakelight::viewer {
namespace {

MotionTimes::Clock::time_point at(int ms) { return MotionTimes::Clock::time_point{} + std::chrono::milliseconds(ms); }

TEST(MotionTimes, APictureAnswersAllThatWereAskedForBefore) {
    MotionTimes times;
    EXPECT_EQ(times.quantile_ms(0.5), 0);
    times.asked(3, at(0));
    times.asked(4, at(10));
    times.asked(5, at(20));
    times.displayed(2, at(25));
    EXPECT_EQ(times.count(), 0u);
    times.displayed(4, at(40));
    times.displayed(4, at(50));
    times.displayed(5, at(100));
    EXPECT_EQ(times.count(), 3u);
    EXPECT_DOUBLE_EQ(times.quantile_ms(0), 30);
    EXPECT_DOUBLE_EQ(times.quantile_ms(0.5), 40);
    EXPECT_DOUBLE_EQ(times.quantile_ms(1), 80);
}

}  // namespace
}  // namespace rakelight::viewer
