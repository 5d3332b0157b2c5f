// SPDX-License-Identifier: Apache-2.0
// Near and far as the caller gives them, and what is said of a camera that sees nothing because of them.
#include <gtest/gtest.h>
#include <rakelight/rakelight.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "math/linear.h"
#include "render/engines.h"
#include "render/shot.h"
#include "support/scene_builder.h"
#include "unit/render/test_scene.h"

namespace rakelight {
namespace {

using test::two_squares;

constexpr double aspect = 1.5;

Camera camera_at(dvec3 eye, dvec3 target) {
    Camera camera;
    camera.to_world = look_at(eye, target, {0, 1, 0});
    return camera;
}

Scene seen_from(dvec3 eye, dvec3 target = {0, 0, 0}) {
    Scene scene = two_squares();
    scene.cameras = {camera_at(eye, target)};
    return scene;
}

std::string only_remark(Context& context) {
    const std::vector<ReportEntry> entries = context.report().entries();
    return entries.size() == 1 ? entries[0].message : std::to_string(entries.size()) + " remarks";
}

TEST(CameraDepths, NearAndFarOfTheRequestReplaceThoseOfEveryKindOfCamera) {
    Context context;
    const Scene scene = seen_from({0, 0, 7});
    for (const ViewRequest& view :
         {ViewRequest{}, ViewRequest{.camera = "0"}, ViewRequest{.side = "front"},
          ViewRequest{.position = dvec3{0, 0, 9}}, ViewRequest{.camera = "0", .orthographic = true}}) {
        ViewRequest asked = view;
        asked.z_near = 0.25, asked.z_far = 2000;
        const Camera with = choose_camera(scene, asked, aspect, context),
                     without = choose_camera(scene, view, aspect, context);
        EXPECT_EQ(with.z_near, 0.25);
        EXPECT_EQ(with.z_far, 2000);
        EXPECT_EQ(with.to_world[3], without.to_world[3]) << "the camera stays where it is";
        asked.z_far.reset();
        EXPECT_EQ(choose_camera(scene, asked, aspect, context).z_far, without.z_far);
    }
}

TEST(CameraDepths, WhatIsNearerThanNearOrFartherThanFarIsNotDrawn) {
    Context context;
    Scene scene = two_squares();
    scene.nodes[1].local.translation = {0, 0, -4};  // the right square is 11 m away, the left one 7
    scene.cameras = {camera_at({0, 0.5, 7}, {0, 0.5, 0})};
    const auto halves = [&](std::optional<double> near, std::optional<double> far) {
        const Camera camera = choose_camera(scene, {.z_near = near, .z_far = far}, 1, context);
        const Frame frame = render(scene, camera, {.width = 40, .height = 40}, context);
        const vec4 background = frame.color[0];
        return std::pair{frame.color[20 * 40 + 18] != background, frame.color[20 * 40 + 21] != background};
    };
    EXPECT_EQ(halves({}, {}), std::pair(true, true));
    EXPECT_EQ(halves(8.0, {}), std::pair(false, true));
    EXPECT_EQ(halves({}, 10.0), std::pair(true, false));
    EXPECT_EQ(halves(6.9, 11.1), std::pair(true, true));
}

/// A floor of 1500 m, a wall at its end, and a red square before an eye 1.7 m above the middle.
Scene large_scene(double distance) {
    Scene scene;
    const dmat4 lying{{{1, 0, 0, 0}, {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1}}};
    for (const vec3 color : {vec3{0, 1, 0}, vec3{0, 0, 1}, vec3{1, 0, 0}}) {
        scene.materials.push_back(test::matte(color));
        scene.materials.back().model = MaterialModel::unlit;
    }
    test::add_object(scene, test::square_mesh(0, 750), lying);
    test::add_object(scene, test::square_mesh(1, 700), translation(dvec3{0, 0, -700}));
    test::add_object(scene, test::square_mesh(2, float(0.1 * distance)), translation(dvec3{0, 1.7, -distance}));
    return scene;
}

TEST(CameraDepths, WhatIsCloseToACameraInsideALargeSceneIsDrawn) {
    Context context;
    for (const double distance : {0.4, 0.1, 0.01, 0.001}) {
        const Scene scene = large_scene(distance);
        const Camera camera =
            choose_camera(scene, {.position = dvec3{0, 1.7, 0}, .focal_point = dvec3{0, 1.7, -1}}, 1, context);
        EXPECT_LT(camera.z_near, distance);
        EXPECT_GE(camera.z_near, 0.49 * std::min(distance, 2e-4 * camera.z_far)) << "no nearer than it has to be";
        for (const std::string& name : engine_names()) {
            if (name != "soft" && name != "trace") continue;
            Session session(name);
            session.set(scene);
            Frame frame;
            session.render(camera, {.width = 41, .height = 41}, frame, context);
            EXPECT_EQ(frame.color[20 * 41 + 20].xyz(), (vec3{1, 0, 0})) << name << " " << distance;
            EXPECT_EQ(frame.color[5 * 41 + 20].xyz(), (vec3{0, 0, 1})) << name << " " << distance;
            EXPECT_EQ(frame.color[40 * 41 + 20].xyz(), (vec3{0, 1, 0})) << name << " " << distance;
        }
    }
}

TEST(CameraDepths, NearStaysWhereNothingIsNearer) {
    Context context;
    const ViewRequest view{.position = dvec3{0, 1.7, 0}, .focal_point = dvec3{0, 1.7, -1}};
    const Camera camera = choose_camera(large_scene(100), view, 1, context);
    EXPECT_EQ(camera.z_near, 1e-4 * camera.z_far);
    Scene beside = large_scene(0.1);
    beside.nodes[2].local.matrix = translation(dvec3{0, 1.7, 0.1});  // behind the eye
    EXPECT_EQ(choose_camera(beside, view, 1, context).z_near, 1e-4 * camera.z_far);
    ViewRequest asked = view;
    asked.z_near = 0.2;
    EXPECT_EQ(choose_camera(large_scene(0.1), asked, 1, context).z_near, 0.2);
}

/// A floor of 1 km, a red square of 1 m standing on it 10 m before the eye, and a blue speck 0.01 mm before the eye in a corner.
Scene scene_with_speck() {
    Scene scene = large_scene(1);
    scene.meshes = {test::square_mesh(0, 500), test::square_mesh(2, 0.5f), test::square_mesh(1, 1e-6f)};
    scene.nodes[1].local.matrix = translation(dvec3{0, 0.5, -10});
    scene.nodes[2].local.matrix = translation(dvec3{3e-6, 1.7 + 3e-6, -1e-5});
    return scene;
}

const ViewRequest from_head_height{.position = dvec3{0, 1.7, 0}, .focal_point = dvec3{0, 1.7, -1}};

/// One step of a textbook's depth of b bits is d^2 / (near 2^b): with near = far / 10000 0.02 m at 10 m in 16 bits, less than
/// the 0.3 m by which rows of the floor differ there. With the near plane before the speck it would be 200 m, and 0.8 m in 24.
TEST(CameraDepths, DepthsThatLoseByItKeepNearAwayFromTheEye) {
    Context context;
    const Scene scene = scene_with_speck();
    const auto drawn = [&](Visibility visibility) {
        PictureRequest request;
        request.view = from_head_height;
        request.settings = {.width = 160, .height = 160, .visibility = visibility};
        Session session;
        const Camera camera = decide_single(session, scene, request, {}, {}, context).camera;
        return std::pair{camera, render(scene, camera, request.settings, context)};
    };
    const auto [sharp, right] = drawn(Visibility::z_reversed);
    EXPECT_LT(sharp.z_near, 1e-5);
    const auto count = [](const Frame& f, vec3 color) {
        return std::ranges::count_if(f.color, [&](const vec4& c) { return c.xyz() == color; });
    };
    EXPECT_GT(count(right, {0, 0, 1}), 100) << "the speck";
    EXPECT_GT(count(right, {1, 0, 0}), 300) << "the square";
    for (const Visibility v : {Visibility::z16, Visibility::z24, Visibility::z32, Visibility::z_float}) {
        const auto [camera, frame] = drawn(v);
        EXPECT_EQ(camera.z_near, 1e-4 * camera.z_far);
        std::size_t others = 0;
        for (std::size_t i = 0; i < frame.color.size(); ++i)
            others += right.color[i].xyz() != vec3{0, 0, 1} && frame.color[i] != right.color[i];
        EXPECT_EQ(others, 0u) << int(v);
    }
    for (const Visibility v : {Visibility::painter, Visibility::none, Visibility::back_face})
        EXPECT_EQ(drawn(v).first.z_near, sharp.z_near);
    const CameraChooser chooser(scene, context);
    EXPECT_EQ(chooser.choose(from_head_height, 1, Visibility::z24, context).z_near, 1e-4 * sharp.z_far);
    EXPECT_EQ(chooser.choose(from_head_height, 1, context).z_near, sharp.z_near);
}

TEST(CameraDepths, APictureOfASceneAloneHasTheNearOfItsVisibility) {
    Context context;
    Scene scene = scene_with_speck();
    scene.source = "tour.scene.toml";
    scene.cameras = {camera_at({0, 1.7, 0}, {0, 1.7, -1})};
    const auto drawn = [&](Visibility visibility) {
        return render(scene, {.width = 160, .height = 160, .visibility = visibility}, context);
    };
    const Frame right = drawn(Visibility::z_reversed);
    for (const Visibility v : {Visibility::z16, Visibility::z24, Visibility::z_float}) {
        const Frame frame = drawn(v);
        std::size_t others = 0;
        for (std::size_t i = 0; i < frame.color.size(); ++i)
            others += right.color[i].xyz() != vec3{0, 0, 1} && frame.color[i] != right.color[i];
        EXPECT_EQ(others, 0u) << int(v);
    }
}

TEST(CameraDepths, OfAFilesCamerasOnlyThoseOfAWorldWithoutNearAndFarFollowTheScene) {
    Context context;
    Scene scene = large_scene(0.05);
    scene.source = "tour.glb";
    scene.cameras = {camera_at({0, 1.7, 0}, {0, 1.7, -1})};
    EXPECT_EQ(choose_camera(scene, {}, 1, context).z_near, 0.1) << "znear of glTF";
    scene.source = "tour.scene.toml";
    EXPECT_NEAR(choose_camera(scene, {}, 1, context).z_near, 0.025, 1e-6);
    EXPECT_GT(choose_camera(scene, {}, 1, context).z_far, 1000);
    scene.cameras[0].z_near = 0.2;
    EXPECT_EQ(choose_camera(scene, {}, 1, context).z_near, 0.2);
}

TEST(CameraDepths, WhatCannotBeIsRefusedWithBothDistances) {
    Context context;
    const Scene scene = seen_from({0, 0, 7});
    const auto refusal = [&](const ViewRequest& view) -> std::string {
        try {
            choose_camera(scene, view, aspect, context);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::usage);
            return error.reason() + "; " + error.advice();
        }
        return "taken";
    };
    EXPECT_EQ(refusal({.z_near = 0.0}), "the camera's near and far must be more than 0 m; ");
    EXPECT_EQ(refusal({.z_far = -1.0}), "the camera's near and far must be more than 0 m; ");
    EXPECT_EQ(refusal({.z_near = 3.0, .z_far = 3.0}), "the camera's near must be less than its far; ");
    EXPECT_EQ(refusal({.z_near = 5000.0}), "near, 5000 m, is not less than this camera's far, 1000 m; give a far too");
    EXPECT_EQ(refusal({.z_far = 0.05}), "far, 0.05 m, is not more than this camera's near, 0.1 m; give a near too");
}

TEST(CameraDepths, ACameraOfTheFileThatIsReplacedIsSaidToBeSoAndWhy) {
    const auto said_of = [](const Scene& scene) {
        Context context;
        choose_camera(scene, {}, aspect, context);
        return only_remark(context);
    };
    const std::string begin = "the camera sees nothing of the model: ", end = "; the default view is used instead";
    EXPECT_EQ(said_of(seen_from({0, 0, 4300})),
              begin + "all of it is 4300 m away or more, but the far plane is at 1000 m" + end);
    EXPECT_EQ(said_of(seen_from({0, 0, 0.05})),
              begin + "all of it is 0.05 m away or less, but the near plane is at 0.1 m" + end);
    EXPECT_EQ(said_of(seen_from({0, 0, 7}, {0, 0, 9})), begin + "all of it is behind the camera" + end);
    EXPECT_EQ(said_of(seen_from({20, 0, 7}, {20, 0, 0})), begin + "all of it is to the left of the picture" + end);
    EXPECT_EQ(said_of(seen_from({0, -20, 7}, {0, -20, 0})), begin + "all of it is above the picture" + end);
}

TEST(CameraDepths, ACameraThatSeesNothingByWhatWasAskedForIsKeptWithAWarning) {
    Context context;
    const Camera camera = choose_camera(seen_from({0, 0, 7}), {.z_far = 5.0}, aspect, context);
    EXPECT_EQ(camera.to_world[3].xyz(), (dvec3{0, 0, 7}));
    EXPECT_EQ(only_remark(context),
              "the camera sees nothing of the model: all of it is 7 m away or more, but the far plane is at 5 m");
}

TEST(CameraDepths, ACameraBlindByItsOwnFaultIsReplacedWhateverDepthsWereAskedForUnlessTheyHelp) {
    const Scene too_far = seen_from({0, 0, 4300});
    Context context;
    Camera fitted = choose_camera(two_squares(), {}, aspect, context);
    const Camera camera = choose_camera(too_far, {.z_near = 0.01}, aspect, context);
    EXPECT_EQ(camera.to_world, fitted.to_world);
    EXPECT_EQ(camera.z_near, 0.01);
    EXPECT_EQ(camera.z_far, fitted.z_far);
    EXPECT_EQ(only_remark(context),
              "the camera sees nothing of the model: all of it is 4300 m away or more, but the far plane is at 1000 m; "
              "the default view is used instead");
    Context helped;
    EXPECT_EQ(choose_camera(too_far, {.z_far = 5000.0}, aspect, helped).to_world[3].xyz(), (dvec3{0, 0, 4300}));
    EXPECT_EQ(only_remark(helped), "0 remarks");
    Scene impossible = too_far;
    impossible.cameras[0].projection = Projection::orthographic;
    impossible.cameras[0].z_far = std::numeric_limits<double>::infinity();
    EXPECT_EQ(choose_camera(impossible, {.z_near = 0.01}, aspect, context).z_near, 0.01);
}

}  // namespace
}  // namespace rakelight
