// SPDX-License-Identifier: Apache-2.0
// Sequences: which pictures they have, where the camera stands, and that each picture is the same whatever else is drawn.
#include <rakelight/render/sequence.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include <rakelight/math/linear.h>
#include <rakelight/render/render.h>

#include "render/sequence/sequence_plan.h"
#include "render/sequence/sequence_views.h"
#include "support/scene_builder.h"
#include "support/temporary_folder.h"
#include "support/thrown_error.h"

namespace rakelight {
namespace {

using test::error_of;

/// A square that goes from x = 0 to x = 6 between second 1 and 2.
Scene moving_square() {
    Scene scene;
    scene.source = "moving";
    scene.materials.push_back(test::matte({0.8f, 0.5f, 0.2f}));
    test::add_object(scene, test::square_mesh(0));
    scene.nodes[0].local = {};
    Animation clip{.name = "slide"};
    AnimationChannel channel{.element = 0, .path = AnimationPath::translation};
    channel.times = std::vector<float>{1, 2};
    channel.values = std::vector<float>{0, 0, 0, 6, 0, 0};
    clip.channels.push_back(channel);
    scene.animations.push_back(clip);
    return scene;
}

SequenceRequest request_of(FrameRange frames = {}, double fps = 10, int turntable = 0) {
    SequenceRequest request;
    request.frames = frames, request.fps = fps, request.turntable = turntable;
    request.picture.output = "p.{frame:3}.png";
    request.picture.settings.width = 48, request.picture.settings.height = 32;
    return request;
}

TEST(SequencePlan, AClipHasItsFirstAndItsLastMoment) {
    const SequencePlan plan(moving_square(), request_of());
    EXPECT_EQ(plan.count(), 11);
    EXPECT_EQ(plan.frames().size(), 11u);
    EXPECT_DOUBLE_EQ(plan.time_of(0), 1);
    EXPECT_DOUBLE_EQ(plan.time_of(5), 1.5);
    EXPECT_DOUBLE_EQ(plan.time_of(10), 2);
    EXPECT_EQ(plan.angle_of(5), 0);
}

TEST(SequencePlan, RangesAreInclusiveAndHaveSteps) {
    using Numbers = std::vector<std::int64_t>;
    EXPECT_EQ(SequencePlan(moving_square(), request_of({3, 5, 1})).frames(), (Numbers{3, 4, 5}));
    EXPECT_EQ(SequencePlan(moving_square(), request_of({1, 8, 3})).frames(), (Numbers{1, 4, 7}));
    EXPECT_EQ(SequencePlan(moving_square(), request_of({9, std::nullopt, 1})).frames(), (Numbers{9, 10}));
}

TEST(SequencePlan, ATurntableGoesOnceAroundAndRepeatsItsClip) {
    SequenceRequest request = request_of({}, 10, 16);
    const SequencePlan still(moving_square(), request);
    EXPECT_EQ(still.count(), 16);
    EXPECT_FALSE(still.has_clip());
    EXPECT_DOUBLE_EQ(still.angle_of(4), pi / 2);
    request.picture.motion.name = "slide";
    const SequencePlan playing(moving_square(), request);
    EXPECT_DOUBLE_EQ(playing.time_of(5), 1.5);
    EXPECT_NEAR(playing.time_of(13), 1.3, 1e-12);
    request.picture.motion.time_s = 1.25;
    EXPECT_DOUBLE_EQ(SequencePlan(moving_square(), request).time_of(7), 1.25);
}

TEST(SequencePlan, RefusesWhatCannotBe) {
    const auto refused = [](const Scene& scene, const SequenceRequest& request) {
        return error_of([&] { SequencePlan(scene, request); });
    };
    Scene still = moving_square();
    still.animations.clear();
    EXPECT_NE(refused(still, request_of()).reason().find("no animations"), std::string::npos);
    EXPECT_NE(refused(moving_square(), request_of({0, 11, 1})).reason().find("0 to 10"), std::string::npos);
    EXPECT_NE(refused(still, request_of({16, 16, 1}, 10, 16)).reason().find("0 to 15"), std::string::npos);
    EXPECT_EQ(refused(moving_square(), request_of({5, 4, 1})).setting(), "frames");
    EXPECT_EQ(refused(moving_square(), request_of({0, 4, 0})).setting(), "frames");
    EXPECT_EQ(refused(moving_square(), request_of({-1, 4, 1})).setting(), "frames");
    EXPECT_EQ(refused(moving_square(), request_of({0, 200'000'000, 1})).setting(), "frames");
    EXPECT_EQ(refused(moving_square(), request_of({}, 0)).setting(), "fps");
    EXPECT_EQ(refused(moving_square(), request_of({}, std::nan(""))).setting(), "fps");
    EXPECT_EQ(refused(still, request_of({}, 10, 2'000'000)).setting(), "turntable");
    Scene endless = moving_square();
    endless.animations[0].channels[0].times = std::vector<float>{1, 1e9f};
    EXPECT_EQ(refused(endless, request_of()).setting(), "fps");
    SequenceRequest moment = request_of();
    moment.picture.motion.time_s = 1;
    EXPECT_EQ(refused(moving_square(), moment).setting(), "animation-time");
}

TEST(SequenceNames, HaveTheNumberOfThePicture) {
    EXPECT_EQ(frame_name("a.{frame:4}.png", 17), "a.0017.png");
    EXPECT_EQ(frame_name("{frame}/a-{frame:2}.png", 123), "123/a-123.png");
    EXPECT_EQ(frame_name("{frames}{frame:x}.png", 1), "{frames}{frame:x}.png");
    EXPECT_TRUE(has_frame_number("{frame:4}"));
    EXPECT_FALSE(has_frame_number("a.png"));
    SequenceRequest request = request_of();
    request.picture.output = "a.png";
    EXPECT_EQ(error_of([&] { check_sequence(request); }).code(), ErrorCode::usage);
}

class SequenceCameras : public testing::Test {
protected:
    SequenceViews views(const Scene& scene, const SequenceRequest& request) {
        const SequencePlan plan(scene, request);
        return {plan, request.picture, [&](double t) { return scene_at(scene, plan.clips_at(t)); }, context_};
    }
    /// Whether a place lies in the picture.
    static bool sees(const Camera& camera, dvec3 place) {
        dmat4 to_camera;
        EXPECT_TRUE(inverse_affine(camera.to_world, to_camera));
        const dvec3 p = transform_point(to_camera, place);
        const double half = -p.z * std::tan(camera.vertical_fov_rad / 2);
        return p.z < 0 && std::fabs(p.y) <= half && std::fabs(p.x) <= half * 48 / 32 && -p.z >= camera.z_near &&
               -p.z <= camera.z_far;
    }
    Context context_{{.threads = 1}};
};

TEST_F(SequenceCameras, AFittedViewShowsTheWholeClip) {
    const Scene scene = moving_square();
    const SequenceViews all = views(scene, request_of());
    const Camera camera = all.camera(scene, 0);
    for (const double x : {-1.0, 7.0}) EXPECT_TRUE(sees(camera, {x, 1, 0})) << x;
    EXPECT_DOUBLE_EQ(all.bounds().high.x, 7);
    // It does not depend on the range.
    EXPECT_EQ(views(scene, request_of({4, 4, 1})).camera(scene, 0).to_world, camera.to_world);
}

TEST_F(SequenceCameras, ATurntableShowsTheModelFromAllSidesAndTurnsItToTheRight) {
    Scene scene = moving_square();
    SequenceRequest request = request_of({}, 10, 24);
    request.picture.motion.name = "slide";
    const SequenceViews all = views(scene, request);
    for (int k = 0; k < 24; ++k)
        for (const double x : {-1.0, 7.0})
            for (const double y : {-1.0, 1.0})
                EXPECT_TRUE(sees(all.camera(scene, 2 * pi * k / 24), {x, y, 0})) << k << " " << x;
    // The side that faces the camera goes to the right: the camera goes to its left.
    const Camera first = all.camera(scene, 0), next = all.camera(scene, 0.2);
    const dvec3 moved = next.to_world[3].xyz() - first.to_world[3].xyz();
    EXPECT_LT(dot(moved, first.to_world[0].xyz()), 0);
    EXPECT_NEAR(moved.y, 0, 1e-12);
    // It comes near: the farthest corner takes most of the picture's width.
    double widest = 0;
    for (int k = 0; k < 24; ++k) {
        dmat4 to_camera;
        const Camera camera = all.camera(scene, 2 * pi * k / 24);
        ASSERT_TRUE(inverse_affine(camera.to_world, to_camera));
        for (const double x : {-1.0, 7.0}) {
            const dvec3 p = transform_point(to_camera, {x, 0, 0});
            widest = std::max(widest, std::fabs(p.x / p.z) / std::tan(camera.vertical_fov_rad / 2) * 32 / 48);
        }
    }
    EXPECT_GT(widest, 0.8);
    EXPECT_LT(widest, 0.92);
}

TEST_F(SequenceCameras, ACameraOfTheFileThatTheClipMovesDoesMove) {
    Scene scene = moving_square();
    Node node;
    node.parent = 0;
    node.local.translation = {0, 0, 8};
    scene.nodes.push_back(node);
    scene.cameras.push_back({.node = 1});
    const SequenceRequest request = request_of();
    const SequenceViews all = views(scene, request);
    const SequencePlan plan(scene, request);
    for (const double t : {1.0, 1.5, 2.0}) {
        const Camera camera = all.camera(scene_at(scene, plan.clips_at(t)), 0);
        EXPECT_NEAR(camera.to_world[3].x, 6 * (t - 1), 1e-6) << t;
    }
}

TEST_F(SequenceCameras, NearFollowsWhatComesCloseInEachPicture) {
    Scene scene = moving_square();
    test::add_object(scene, test::square_mesh(0, 900), translation(dvec3{0, 0, -800}));
    SequenceRequest request = request_of();
    request.picture.view.position = dvec3{30, 0, 0.05};
    request.picture.view.focal_point = dvec3{30, 0, -1};
    const SequencePlan plan(scene, request);
    const SequenceViews all = views(scene, request);
    const auto near_at = [&](double time_s, double wall) {
        Scene moved = scene;
        moved.nodes[1].local.matrix = translation(dvec3{0, 0, wall});
        return all.camera(scene_at(moved, plan.clips_at(time_s)), 0).z_near;
    };
    const double usual = near_at(1, -800);
    EXPECT_GT(usual, 0.05);
    EXPECT_NEAR(near_at(1.53, 0), 0.025, 1e-9);
    EXPECT_EQ(near_at(2, -800), usual);
    request.picture.settings.visibility = Visibility::z16;
    const SequenceViews of_16_bits = views(scene, request);
    scene.nodes[1].local.matrix = translation(dvec3{0, 0, 0});
    EXPECT_EQ(of_16_bits.camera(scene_at(scene, plan.clips_at(1.53)), 0).z_near, usual) << "a depth that loses by it";
}

TEST_F(SequenceCameras, APlacedCameraGoesRoundWhatItLooksAt) {
    Scene scene = moving_square();
    scene.animations.clear();
    SequenceRequest request = request_of({}, 10, 4);
    request.picture.view.position = dvec3{0, 1, 5};
    request.picture.view.focal_point = dvec3{0, 0, 1};
    const SequenceViews all = views(scene, request);
    const Camera half = all.camera(scene, pi);
    EXPECT_NEAR(half.to_world[3].z, -3, 1e-9);
    EXPECT_NEAR(half.to_world[3].y, 1, 1e-9);
    EXPECT_LT(half.z_near, 3);  // about the model, from there too
    EXPECT_GT(half.z_far, 3);
}

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

class SequenceFiles : public testing::Test {
protected:
    void SetUp() override {
        Context context({.threads = 1});
        save(moving_square(), folder_.file("m.glb"), context);
    }
    std::vector<SequenceFrame> draw(SequenceRequest request, const std::string& name, int threads = 1) {
        request.picture.input = folder_.file("m.glb");
        request.picture.output = folder_.file(name + "{frame:3}.png");
        request.picture.look = Look::standard;
        std::vector<SequenceFrame> frames;
        Context context({.threads = threads});
        render_sequence(request, context, [&](const SequenceFrame& frame) { frames.push_back(frame); });
        return frames;
    }
    test::TemporaryFolder folder_;
};

TEST_F(SequenceFiles, APictureIsTheSameWhateverElseIsDrawn) {
    for (const int turntable : {0, 9}) {
        SequenceRequest request = request_of({}, 10, turntable);
        request.picture.motion.index = 0;
        const auto whole = draw(request, "whole", 2);
        ASSERT_EQ(whole.size(), turntable > 0 ? 9u : 11u);
        EXPECT_NE(bytes_of(whole[0].picture.output), bytes_of(whole[5].picture.output));
        request.frames = {7, 7, 1};
        const auto alone = draw(request, "alone");
        ASSERT_EQ(alone.size(), 1u);
        EXPECT_EQ(bytes_of(alone[0].picture.output), bytes_of(whole[7].picture.output)) << turntable;
        request.frames = {2, 8, 2};
        for (const SequenceFrame& frame : draw(request, "stepped"))
            EXPECT_EQ(bytes_of(frame.picture.output), bytes_of(whole[std::size_t(frame.frame)].picture.output));
    }
}

TEST_F(SequenceFiles, WhatIsThereAndWholeIsNotDrawnAgain) {
    SequenceRequest request = request_of({0, 3, 1});
    const auto first = draw(request, "p");
    const std::string kept = bytes_of(first[1].picture.output);
    std::filesystem::resize_file(first[2].picture.output, 40);
    std::filesystem::remove(first[3].picture.output);
    request.skip_existing = true;
    const auto second = draw(request, "p");
    for (const std::size_t i : {0u, 1u, 2u, 3u}) EXPECT_EQ(second[i].is_skipped, i < 2) << i;
    EXPECT_EQ(bytes_of(first[1].picture.output), kept);
    request.picture.settings.width = 40;  // of another size: drawn again
    for (const SequenceFrame& frame : draw(request, "p")) EXPECT_FALSE(frame.is_skipped);
}

TEST_F(SequenceFiles, CancellingLeavesWholePicturesAlone) {
    SequenceRequest request = request_of();
    request.picture.input = folder_.file("m.glb");
    request.picture.output = folder_.file("c{frame:3}.png");
    Context context({.threads = 1});
    const Error error = error_of([&] {
        render_sequence(request, context, [&](const SequenceFrame& frame) {
            if (frame.frame == 4) context.cancel();
        });
    });
    EXPECT_EQ(error.code(), ErrorCode::failed);
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
        files += entry.path() != folder_ / "m.glb";
    EXPECT_EQ(files, 5u);
}

}  // namespace
}  // namespace rakelight
