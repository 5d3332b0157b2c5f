// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/motion/player.h"

#include "../../../apps/viewer/motion/recorded_keys.h"
#include "looks.h"
#include "support/shared.h"

namespace rakelight::viewer {
namespace {

/// A door with the clips swing (0 to 1 s), slide (0.5 to 2.5 s) and fly (likewise, of the camera).
class Playing : public Looks {
protected:
    Playing() : model_(model((test::source_dir() / "data/motion/door.gltf").string())), look_(first_look(*model_)) {}
    bool apply(Command command) { return viewer::apply(command, player_, look_, *model_, width, height); }
    bool advance(double elapsed_s) { return viewer::advance(look_, *model_, player_, width, height, elapsed_s); }
    double now() { return time_of(look_, *model_, player_); }

    std::shared_ptr<const Model> model_;
    Look look_;
    Player player_;
};

TEST(PlayersClock, BeginsWhenItIsAskedFirst) {
    Player player;
    EXPECT_EQ(player.elapsed(100), 0);
    EXPECT_EQ(player.elapsed(100.25), 0.25);
    EXPECT_EQ(player.elapsed(100), 0) << "back";
    player.stop_clock();
    EXPECT_EQ(player.elapsed(500), 0);
    EXPECT_EQ(player.elapsed(501), 1);
}

TEST_F(Playing, BeginsWithTheFirstClipAtItsBeginning) {
    EXPECT_FALSE(has_motion(look_));
    ASSERT_TRUE(apply(Command::play));
    EXPECT_TRUE(player_.is_playing);
    EXPECT_EQ(chosen_clip(look_, *model_), 0);
    EXPECT_TRUE(advance(0.25));
    EXPECT_EQ(now(), 0.25);
    EXPECT_EQ(request_of(look_, width, height).motion.time_s, 0.25);
    apply(Command::play);
    EXPECT_TRUE(advance(0.25));
    EXPECT_EQ(now(), 0.25) << "paused";
}

TEST_F(Playing, GoesOnAtTheBeginningOfTheClipWhereItLoops) {
    choose_clip(look_, 1);
    player_.is_playing = true;
    EXPECT_EQ(now(), 0.5);
    EXPECT_TRUE(advance(2.25));
    EXPECT_NEAR(now(), 0.75, 1e-12);
    EXPECT_TRUE(advance(20.5)) << "ten times around, while the window hung";
    EXPECT_NEAR(now(), 1.25, 1e-12);
}

TEST_F(Playing, EndsAtTheLastMomentWhereItDoesNotLoop) {
    choose_clip(look_, 1);
    player_.is_playing = true, player_.loops = false;
    EXPECT_TRUE(advance(1.5));
    EXPECT_FALSE(advance(7));
    EXPECT_EQ(now(), 2.5);
    player_.is_playing = false;
    apply(Command::play);
    EXPECT_EQ(now(), 0.5) << "once more from the beginning";
}

TEST_F(Playing, IsFasterAndSlowerBySpeed) {
    choose_clip(look_, 1);
    player_.is_playing = true;
    apply(Command::faster);
    advance(0.5);
    EXPECT_EQ(now(), 1.5);
    for (int i = 0; i < 3; ++i) apply(Command::slower);
    advance(0.5);
    EXPECT_EQ(now(), 1.625);
    for (int i = 0; i < 20; ++i) apply(Command::slower);
    EXPECT_GT(player_.speed, 0);
}

TEST_F(Playing, StepsThroughTheClipsAndTheModelAtRest) {
    std::vector<int> seen;
    for (int i = 0; i < 5; ++i) apply(Command::next_clip), seen.push_back(chosen_clip(look_, *model_).value_or(-1));
    EXPECT_EQ(seen, (std::vector<int>{0, 1, 2, -1, 0}));
    apply(Command::previous_clip);
    EXPECT_FALSE(look_.request.motion.is_set());
    apply(Command::previous_clip);
    EXPECT_EQ(chosen_clip(look_, *model_), 2);
    EXPECT_EQ(now(), 0.5);
    player_.is_playing = true;
    apply(Command::at_rest);
    EXPECT_FALSE(player_.moves());
    EXPECT_TRUE(clips_of(look_, *model_).empty());
}

TEST_F(Playing, AllClipsTakeTheTimeOfAll) {
    choose_clip(look_, -1);
    EXPECT_EQ(clips_of(look_, *model_).size(), 3u);
    EXPECT_EQ(span_of(look_, *model_, player_).begin_s, 0);
    EXPECT_EQ(span_of(look_, *model_, player_).end_s, 2.5);
    EXPECT_EQ(clip_title(*model_, -1), "all clips");
    EXPECT_EQ(clip_title(*model_, 1), "1: slide, 2.00 s");
}

TEST_F(Playing, IsScrubbedWithinTheClipAndSteppedAPictureAtATime) {
    choose_clip(look_, 0);
    set_time(look_, *model_, player_, width, height, 7);
    EXPECT_EQ(now(), 1);
    player_.is_playing = true;
    apply(Command::frame_back);
    EXPECT_FALSE(player_.is_playing);
    EXPECT_NEAR(now(), 1 - 1.0 / 30, 1e-12);
    set_time(look_, *model_, player_, width, height, -7);
    apply(Command::frame_back);
    EXPECT_EQ(now(), 0);
}

TEST_F(Playing, AFittedViewStaysWhereItIs) {
    look_.request.view = {.side = "front"};
    choose_clip(look_, 1);
    const dmat4 before = camera_of(look_, *model_, width, height).to_world;
    set_time(look_, *model_, player_, width, height, 2.5);
    ASSERT_TRUE(look_.eye);
    const dvec3 moved = camera_of(look_, *model_, width, height).to_world[3].xyz() - before[3].xyz();
    EXPECT_LT(length(moved), 1e-9);
}

TEST_F(Playing, ACameraOfTheFileMovesAsItsClipSays) {
    look_.request.view = {.camera = "0"};
    choose_clip(look_, 2);
    set_time(look_, *model_, player_, width, height, 1.5);
    EXPECT_FALSE(look_.eye);
    for (const Camera& camera :
         {camera_of(look_, *model_, width, height), quick_camera_of(look_, *model_, width, height)})
        EXPECT_EQ(camera.to_world[3].xyz(), (dvec3{1.5, 1, 5.5}));
}

TEST_F(Playing, TheTurntableGoesAroundWhileClipsPlay) {
    choose_clip(look_, 0);
    const Eye before = seen_eye(look_, *model_, width, height);
    apply(Command::turntable);
    player_.is_playing = true, player_.turn_s = 8;
    advance(0.5);
    for (int i = 0; i < 7; ++i) advance(0.5);  // half a turn
    EXPECT_NEAR(now(), 1, 1e-9) << "four times around";
    const dvec3 a = before.position - before.focal, b = look_.eye->position - look_.eye->focal;
    EXPECT_NEAR(b.x, -a.x, 1e-9);
    EXPECT_NEAR(b.y, a.y, 1e-9);
    EXPECT_NEAR(b.z, -a.z, 1e-9);
}

TEST_F(Playing, WithoutClipsThereIsNothingToPlay) {
    model_ = model(write_model());
    look_ = first_look(*model_);
    for (const Command command : {Command::play, Command::next_clip, Command::frame_on}) apply(command);
    EXPECT_FALSE(player_.is_playing);
    EXPECT_FALSE(request_of(look_, width, height).motion.is_set());
    EXPECT_NE(effect_of(Command::play, player_, look_, *model_).find("nothing to play"), std::string::npos);
}

TEST_F(Playing, IsNotAboutOtherCommands) { EXPECT_FALSE(apply(Command::grid)); }

}  // namespace
}  // namespace rakelight::viewer
