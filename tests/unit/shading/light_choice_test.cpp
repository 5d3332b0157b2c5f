// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/light_choice.h"

#include <gtest/gtest.h>

namespace rakelight::shading {
namespace {

TEST(LightChoice, TakesWhatIsThereAndHalfOfEachWhereBothAre) {
    const LightChoice both{true, true}, sky{true, false}, triangles{false, true}, none;
    EXPECT_EQ(both.probability_of_environment(), 0.5);
    EXPECT_EQ(both.probability_of_emitters(), 0.5);
    EXPECT_EQ(sky.probability_of_environment(), 1);
    EXPECT_EQ(sky.probability_of_emitters(), 0);
    EXPECT_EQ(triangles.probability_of_environment(), 0);
    EXPECT_EQ(triangles.probability_of_emitters(), 1);
    EXPECT_EQ(none.probability_of_environment() + none.probability_of_emitters(), 0);
}

TEST(LightChoice, LeavesTheRestOfTheNumber) {
    const LightChoice both{true, true};
    EXPECT_TRUE(both.pick(0.25).is_environment);
    EXPECT_EQ(both.pick(0.25).rest, 0.5);
    EXPECT_FALSE(both.pick(0.5).is_environment);
    EXPECT_EQ(both.pick(0.5).rest, 0);
    EXPECT_EQ(both.pick(0.75).probability, 0.5);
    EXPECT_TRUE((LightChoice{true, false}.pick(0.999).is_environment));
    EXPECT_EQ((LightChoice{false, true}.pick(0.25).rest), 0.25);
    EXPECT_EQ((LightChoice{false, true}.pick(0.25).probability), 1);
}

}  // namespace
}  // namespace rakelight::shading
