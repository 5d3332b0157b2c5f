// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/motion/recorded_keys.h"

#include "../../../apps/viewer/motion/player.h"
#include "looks.h"

#include <rakelight/scene/animated_properties.h>

namespace rakelight::viewer {
namespace {

class RecordedKeys : public Looks {
protected:
    RecordedKeys() : model_(model(write_model())), look_(first_look(*model_)) {}
    void key_at(double time_s, dvec3 position) {
        moving_eye(look_, *model_, width, height) = {.position = position, .focal = {0, 0, 0}, .fov_deg = 30 + time_s};
        set_key(look_, *model_, width, height, time_s);
    }
    std::shared_ptr<const Model> model_;
    Look look_;
};

TEST_F(RecordedKeys, TheEyeGoesFromOneToTheNext) {
    key_at(1, {0, 3, 4});
    key_at(3, {4, 3, 0});
    follow_keys(look_, 2);
    EXPECT_EQ(look_.eye->position, (dvec3{2, 3, 2}));
    EXPECT_EQ(look_.eye->focal, (dvec3{0, 0, 0}));
    EXPECT_NEAR(look_.eye->fov_deg, 32, 1e-5);
    EXPECT_NEAR(dot(right_of(*look_.eye), dvec3{0, 1, 0}), 0, 1e-12) << "it stands upright";
    follow_keys(look_, 9);
    EXPECT_EQ(look_.eye->position, (dvec3{4, 3, 0}));
    EXPECT_NEAR(dot(right_of(*look_.eye), dvec3{0, 1, 0}), 0, 1e-12);
}

TEST_F(RecordedKeys, OneAtTheSameMomentTakesThePlaceOfTheOther) {
    key_at(1, {0, 3, 4});
    key_at(2, {0, 3, 5});
    key_at(1, {0, 3, 7});
    EXPECT_EQ(key_times(look_), (std::vector<double>{1, 2}));
    follow_keys(look_, 1);
    EXPECT_EQ(look_.eye->position, (dvec3{0, 3, 7}));
    EXPECT_TRUE(delete_key(look_, 1));
    EXPECT_FALSE(delete_key(look_, 1));
    EXPECT_EQ(key_times(look_), std::vector<double>{2});
}

TEST_F(RecordedKeys, LightsThatWereMovedHaveThemToo) {
    auto& lights = changing_lights(look_, *model_, width, height);
    lights = {{.light = {.position = {1, 1, 1}}}, {.light = {.position = {2, 2, 2}}, .is_on = false}};
    key_at(0, {0, 0, 5});
    (*look_.lights)[0].light.position = {3, 1, 1};
    key_at(2, {0, 0, 5});
    follow_keys(look_, 1);
    EXPECT_EQ((*look_.lights)[0].light.position, (dvec3{2, 1, 1}));
    EXPECT_EQ((*look_.lights)[1].light.position, (dvec3{2, 2, 2}));
    EXPECT_FALSE((*look_.lights)[1].is_on);
}

TEST_F(RecordedKeys, LightsOfTheModelThatNobodyMovedHaveNone) {
    changing_lights(look_, *model_, width, height);
    set_key(look_, *model_, width, height, 0);
    EXPECT_EQ(look_.keys.size(), 1u);
    for (const LightItem& item : *look_.lights) EXPECT_TRUE(item.keys.empty());
}

TEST_F(RecordedKeys, AreWhatAnAnimationOfASceneSays) {
    key_at(0, {0, 0, 5});
    key_at(1, {0, 1, 5});
    const Animation animation = animation_of_keys(look_);
    EXPECT_EQ(clip_span(animation).length(), 1);
    for (const AnimationChannel& channel : animation.channels)
        EXPECT_TRUE(animated_property(channel.path, channel.property)) << channel.property;
    EXPECT_EQ(animation.channels.size(), 3u);
}

TEST_F(RecordedKeys, ArePlayedWithoutAClip) {
    Player player;
    key_at(0, {0, 0, 5});
    key_at(4, {4, 0, 5});
    look_.time_s = 0;
    apply(Command::play, player, look_, *model_, width, height);
    EXPECT_TRUE(player.is_playing);
    advance(look_, *model_, player, width, height, 1);
    EXPECT_EQ(look_.eye->position, (dvec3{1, 0, 5}));
    EXPECT_FALSE(request_of(look_, width, height).motion.is_set());
    EXPECT_EQ(request_of(look_, width, height).view.position, (dvec3{1, 0, 5}));
}

}  // namespace
}  // namespace rakelight::viewer
