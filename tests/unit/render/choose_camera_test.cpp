// SPDX-License-Identifier: Apache-2.0
#include "render/camera/camera_depths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/linear.h"
#include "unit/render/test_scene.h"

namespace rakelight {
namespace {

using test::two_squares;

constexpr double aspect = 16.0 / 9.0;

Camera camera_at(dvec3 eye, dvec3 target) {
    Camera camera;
    camera.name = "eye";
    camera.to_world = look_at(eye, target, {0, 1, 0});
    return camera;
}

dvec3 eye_of(const Camera& c) { return c.to_world[3].xyz(); }
dvec3 picture_camera_of(const Camera& c) { return -c.to_world[2].xyz(); }

/// Whether a world point is inside the picture, near and far included.
bool shows(const Camera& c, dvec3 point) { return may_see(c, aspect, Bounds{point, point}); }

TEST(ChooseCamera, FitsTheModelWhereTheFileHasNoCamera) {
    Context context;
    const Camera c = choose_camera(two_squares(), {}, aspect, context);
    EXPECT_EQ(c.node, no_index);
    for (const dvec3 corner : {dvec3{-1, 0, 0}, dvec3{1, 1, 0}, dvec3{-1, 1, 0}, dvec3{1, 0, 0}})
        EXPECT_TRUE(shows(c, corner));
    EXPECT_TRUE(context.report().entries().empty());
}

TEST(ChooseCamera, TakesTheFirstCameraOfTheFile) {
    Context context;
    Scene scene = two_squares();
    scene.cameras = {camera_at({0, 0, 7}, {0, 0, 0}), camera_at({0, 0, 9}, {0, 0, 0})};
    EXPECT_EQ(eye_of(choose_camera(scene, {}, aspect, context)), (dvec3{0, 0, 7}));
    EXPECT_EQ(eye_of(choose_camera(scene, {.camera = "1"}, aspect, context)), (dvec3{0, 0, 9}));
}

TEST(ChooseCamera, FindsACameraByItsNameAndPlacesItByItsNode) {
    Context context;
    Scene scene = two_squares();
    scene.cameras = {camera_at({0, 0, 7}, {0, 0, 0}), Camera{}};
    scene.cameras[1].name = "on a node";
    scene.cameras[1].node = 1;
    scene.nodes[1].local.translation = {0, 0, 4};
    scene.nodes[1].local.scale = {2, 2, 2};
    const Camera c = choose_camera(scene, {.camera = "on a node"}, aspect, context);
    EXPECT_EQ(eye_of(c), (dvec3{0, 0, 4}));
    EXPECT_EQ(c.node, no_index);
    EXPECT_NEAR(length(c.to_world[0].xyz()), 1, 1e-12);
}

TEST(ChooseCamera, RefusesAnUnknownCameraAndListsTheOthers) {
    Context context;
    Scene scene = two_squares();
    scene.cameras = {camera_at({0, 0, 7}, {0, 0, 0})};
    for (const char* name : {"1", "-1", "nobody", "0x", "99999999999999999999"}) {
        try {
            choose_camera(scene, {.camera = name}, aspect, context);
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::usage);
            EXPECT_NE(std::string(error.what()).find("'eye'"), std::string::npos) << error.what();
        }
    }
}

TEST(ChooseCamera, ReplacesACameraThatLooksAwayAndSaysSo) {
    Context context;
    Scene scene = two_squares();
    scene.cameras = {camera_at({0, 0, 7}, {0, 0, 20})};
    const Camera c = choose_camera(scene, {}, aspect, context);
    EXPECT_TRUE(shows(c, {0, 0.5, 0}));
    ASSERT_EQ(context.report().entries().size(), 1u);
    EXPECT_EQ(context.report().entries()[0].remark, Remark::warning);
    EXPECT_NE(context.report().entries()[0].message.find("sees nothing"), std::string::npos);
}

TEST(ChooseCamera, ReplacesACameraWhoseFarPlaneEndsBeforeTheModelOrThatIsImpossible) {
    Scene scene = two_squares();
    Camera near_sighted = camera_at({0, 0, 7}, {0, 0, 0});
    near_sighted.z_far = 5;
    Camera impossible = camera_at({0, 0, 7}, {0, 0, 0});
    impossible.projection = Projection::orthographic;
    impossible.z_far = std::numeric_limits<double>::infinity();  // scenes may have it, engines cannot draw by it
    for (const Camera& camera : {near_sighted, impossible}) {
        Context context;
        scene.cameras = {camera};
        EXPECT_TRUE(shows(choose_camera(scene, {}, aspect, context), {0, 0.5, 0}));
        EXPECT_EQ(context.report().entries().size(), 1u);
    }
}

TEST(ChooseCamera, WidensACameraThatWantsABroaderPicture) {
    Context context;
    Scene scene = two_squares();
    scene.cameras = {camera_at({0, 0, 7}, {0, 0, 0})};
    scene.cameras[0].vertical_fov_rad = radians(30);
    scene.cameras[0].aspect = 2.0;
    const Camera square = choose_camera(scene, {}, 1.0, context);
    EXPECT_NEAR(std::tan(square.vertical_fov_rad / 2), 2 * std::tan(radians(15)), 1e-12);
    EXPECT_FALSE(square.aspect);
    EXPECT_EQ(choose_camera(scene, {}, 3.0, context).vertical_fov_rad,
              radians(30));  // the picture is broader: all stays in
}

TEST(ChooseCamera, MovesEyeAndFocalPointAsAsked) {
    Context context;
    const Camera c =
        choose_camera(two_squares(), {.position = dvec3{3, 2, 5}, .focal_point = dvec3{0, 0, 0}}, aspect, context);
    EXPECT_EQ(eye_of(c), (dvec3{3, 2, 5}));
    const dvec3 expected = normalize_or(dvec3{-3, -2, -5}, dvec3{0, 0, 0});
    EXPECT_NEAR(length(picture_camera_of(c) - expected), 0, 1e-12);
    EXPECT_TRUE(shows(c, {0, 0, 0}));
    const Camera middle = choose_camera(two_squares(), {.position = dvec3{0, 0.5, 5}}, aspect, context);
    EXPECT_NEAR(length(picture_camera_of(middle) - dvec3{0, 0, -1}), 0,
                1e-12);  // the focal point defaults to the model's middle
}

TEST(ChooseCamera, AnotherViewAngleStillFitsTheModel) {
    Context context;
    const Camera wide = choose_camera(two_squares(), {.vertical_fov_rad = radians(90)}, aspect, context);
    const Camera narrow = choose_camera(two_squares(), {.vertical_fov_rad = radians(5)}, aspect, context);
    EXPECT_LT(length(eye_of(wide)), length(eye_of(narrow)));
    for (const Camera& c : {wide, narrow}) {
        EXPECT_TRUE(shows(c, {-1, 1, 0}));
        EXPECT_TRUE(shows(c, {1, 0, 0}));
    }
}

TEST(ChooseCamera, OrthographicShowsWhatPerspectiveShowsAtTheFocalPoint) {
    Context context;
    const Camera c = choose_camera(two_squares(), {.side = "front", .orthographic = true}, aspect, context);
    EXPECT_EQ(c.projection, Projection::orthographic);
    EXPECT_TRUE(shows(c, {-1, 0, 0}));
    EXPECT_TRUE(shows(c, {1, 1, 0}));
    EXPECT_LT(c.half_height, 2.0);
    EXPECT_LT(c.z_near, c.z_far);
}

TEST(ChooseCamera, AnotherUpStillFitsTheModel) {
    Context context;
    const ViewRequest views[] = {{.up = dvec3{0, 0, 1}},
                                 {.up = dvec3{0, -2, 0}},
                                 {.up = dvec3{1, 1, 0}},
                                 {.side = "front", .up = dvec3{1, 0, 0}},
                                 {.side = "isometric", .up = dvec3{0, 0, 1}, .orthographic = true},
                                 {.side = "left", .up = dvec3{0, 1, 1}, .vertical_fov_rad = radians(70)}};
    for (const ViewRequest& view : views) {
        const Camera c = choose_camera(two_squares(), view, 4.0, context);
        for (const dvec3 corner : {dvec3{-1, 0, 0}, dvec3{1, 1, 0}, dvec3{-1, 1, 0}, dvec3{1, 0, 0}})
            EXPECT_TRUE(may_see(c, 4.0, Bounds{corner, corner})) << view.side << corner.x << corner.y;
        EXPECT_GT(dot(c.to_world[1].xyz(), *view.up), 0);
    }
    EXPECT_TRUE(context.report().entries().empty());
}

/// The up of the picture where it was replaced, and the remark of that.
void expect_up(const ViewRequest& view, dvec3 up, Remark remark, const std::string& words) {
    Context context;
    const Camera c = choose_camera(two_squares(), view, aspect, context);
    EXPECT_NEAR(length(c.to_world[1].xyz() - up), 0, 1e-12) << words;
    ASSERT_EQ(context.report().entries().size(), 1u) << words;
    EXPECT_EQ(context.report().entries()[0].remark, remark) << words;
    EXPECT_NE(context.report().entries()[0].message.find(words), std::string::npos);
}

TEST(ChooseCamera, AnUpAlongTheViewIsReplacedByThatOfTheTopOrTheBottomAndSaid) {
    const dvec3 middle{0, 0.5, 0};
    expect_up({.position = dvec3{0, 5, 0}, .focal_point = middle}, {0, 0, -1}, Remark::note, "-Z is up");
    expect_up({.position = dvec3{0, -5, 0}, .focal_point = middle}, {0, 0, 1}, Remark::note, "+Z is up");
    expect_up({.position = dvec3{5, 0.5, 0}, .focal_point = middle, .up = dvec3{3, 0, 0}}, {0, 1, 0}, Remark::warning,
              "+Y is up");
    expect_up({.side = "bottom", .up = dvec3{0, 1, 0}, .world_up = dvec3{0, 1, 0}}, {0, 0, 1}, Remark::warning,
              "parallel to its view direction");
}

TEST(ChooseCamera, TheDefaultViewTurnsWithUp) {
    Context context;
    const Camera y = choose_camera(two_squares(), {}, aspect, context);
    const Camera z = choose_camera(two_squares(), {.up = dvec3{0, 0, 3}}, aspect, context);
    const dvec3 from = y.to_world[2].xyz();
    EXPECT_NEAR(length(z.to_world[2].xyz() - dvec3{from.x, -from.z, from.y}), 0, 1e-12) << "-Y is the front, Z is up";
}

TEST(ChooseCamera, GoesRoundAfterAllElse) {
    Context context;
    const ViewRequest placed{.position = dvec3{0, 0, 5}, .focal_point = dvec3{0, 0, 0}};
    ViewRequest round = placed;
    round.azimuth_rad = radians(90), round.elevation_rad = radians(30);
    const Camera c = choose_camera(two_squares(), round, aspect, context);
    EXPECT_NEAR(length(eye_of(c) - dvec3{5 * std::cos(radians(30)), 2.5, 0}), 0, 1e-12);
    EXPECT_NEAR(length(picture_camera_of(c) + normalize_or(eye_of(c), dvec3{0, 0, 0})), 0, 1e-12)
        << "at the same point";
    Scene scene = two_squares();
    scene.cameras = {camera_at({0, 0.5, 7}, {0, 0.5, 0})};
    const Camera of_file = choose_camera(scene, {.azimuth_rad = radians(180)}, aspect, context);
    EXPECT_NEAR(length(eye_of(of_file) - dvec3{0, 0.5, -7}), 0, 1e-9);
    EXPECT_THROW(choose_camera(scene, {.camera = "0", .zoom_factor = 2}, aspect, context), Error);
    EXPECT_THROW(choose_camera(scene, {.side = "top", .direction = dvec3{0, 0, 1}}, aspect, context), Error);
}

TEST(ChooseCamera, TheDefaultViewCanBeHadWhereTheFileHasACamera) {
    Context context;
    Scene scene = two_squares();
    const Camera fitted = choose_camera(scene, {}, aspect, context);
    scene.cameras = {camera_at({0, 0, 7}, {0, 0, 0})};
    EXPECT_EQ(choose_camera(scene, {.side = "default"}, aspect, context).to_world, fitted.to_world);
}

TEST(ChooseCamera, AViewAngleSizesParallelProjectionToo) {
    Context context;
    const ViewRequest view{.position = dvec3{0, 0.5, 10}, .vertical_fov_rad = radians(90), .orthographic = true};
    EXPECT_NEAR(choose_camera(two_squares(), view, aspect, context).half_height, 10, 1e-12);
}

TEST(ChooseCamera, AFarPlaneLiesBehindTheModelEvenFromInside) {
    Context context;
    const Camera c = choose_camera(two_squares(), {.position = dvec3{0, 0.5, 0.01}}, aspect, context);
    EXPECT_GT(c.z_near, 0);
    EXPECT_LT(c.z_near, 0.01);
    EXPECT_GT(c.z_far, 1);
}

TEST(ChooseCamera, RefusesImpossiblePlacements) {
    Context context;
    const double infinity = std::numeric_limits<double>::infinity();
    const ViewRequest impossible[] = {{.position = dvec3{1, 1, 1}, .focal_point = dvec3{1, 1, 1}},
                                      {.position = dvec3{infinity, 0, 0}},
                                      {.position = dvec3{1e30, 0, 0}},
                                      {.focal_point = dvec3{0, -1e30, 0}},
                                      {.up = dvec3{0, 0, 0}},
                                      {.vertical_fov_rad = 0.0},
                                      {.vertical_fov_rad = pi},
                                      {.side = "front", .camera = "0"},
                                      {.side = "behind"}};
    for (const ViewRequest& view : impossible) EXPECT_THROW(choose_camera(two_squares(), view, aspect, context), Error);
}

TEST(ChooseCamera, AnAngleThatNoDistanceServesIsRefusedByName) {
    Context context;
    for (const bool orthographic : {false, true})
        for (const double degrees : {1e-30, 1e-12, 1e-6}) {
            const ViewRequest up{.vertical_fov_rad = radians(degrees), .orthographic = orthographic};
            const ViewRequest across{.horizontal_fov_rad = radians(degrees), .orthographic = orthographic};
            for (const ViewRequest& view : {up, across}) {
                try {
                    choose_camera(two_squares(), view, aspect, context);
                    ADD_FAILURE() << degrees;
                } catch (const Error& error) {
                    EXPECT_EQ(error.code(), ErrorCode::usage);
                    EXPECT_NE(error.reason().find("angle of view is so small"), std::string::npos) << error.reason();
                }
            }
        }
    const Camera narrow = choose_camera(two_squares(), {.vertical_fov_rad = radians(1e-5)}, aspect, context);
    EXPECT_LT(float(narrow.z_near), float(narrow.z_far));
    const ViewRequest placed{.position = dvec3{0, 0, 5}, .vertical_fov_rad = radians(1e-12)};
    EXPECT_NO_THROW(choose_camera(two_squares(), placed, aspect, context)) << "a look through a pinhole";
}

TEST(ChooseCamera, WarnsWhenTheAskedForCameraSeesNothing) {
    Context context;
    choose_camera(two_squares(), {.position = dvec3{0, 0, 5}, .focal_point = dvec3{0, 0, 9}}, aspect, context);
    ASSERT_EQ(context.report().entries().size(), 1u);
    EXPECT_EQ(context.report().entries()[0].file, "two.obj");
}

TEST(ChooseCamera, NothingToDrawIsABadFile) {
    Context context;
    try {
        choose_camera(Scene{.source = "empty.obj"}, {}, aspect, context);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::bad_file);
        EXPECT_STREQ(error.what(), "empty.obj: nothing to draw");
    }
}

TEST(ChooseCamera, AModelFarFromTheOriginIsSeenLikeOneAtIt) {
    Context context;
    Scene scene = two_squares();
    const Camera here = choose_camera(scene, {.vertical_fov_rad = radians(30)}, aspect, context);
    const dvec3 away{1e6, -1e6, 1e6};
    for (Node& node : scene.nodes) node.local.translation = away;
    const Camera there = choose_camera(scene, {.vertical_fov_rad = radians(30)}, aspect, context);
    EXPECT_NEAR(length(eye_of(there) - away - eye_of(here)), 0, 1e-8);
    EXPECT_NEAR(there.z_near, here.z_near, 1e-6);
}

TEST(MaySee, TellsABoxBeyondEachPlane) {
    const Camera c = camera_at({0, 0, 0}, {0, 0, -1});  // 40 degrees, near 0.1, far 1000
    const auto box = [](dvec3 center) { return Bounds{center - dvec3{1, 1, 1}, center + dvec3{1, 1, 1}}; };
    EXPECT_TRUE(may_see(c, 1, box({0, 0, -10})));
    EXPECT_TRUE(may_see(c, 1, box({0, 0, 0})));
    EXPECT_FALSE(may_see(c, 1, box({0, 0, 10})));
    EXPECT_FALSE(may_see(c, 1, box({0, 0, -1002})));
    EXPECT_FALSE(may_see(c, 1, box({10, 0, -10})));
    EXPECT_FALSE(may_see(c, 1, box({-10, 0, -10})));
    EXPECT_FALSE(may_see(c, 1, box({0, 10, -10})));
    EXPECT_FALSE(may_see(c, 1, box({0, -10, -10})));
    EXPECT_TRUE(may_see(c, 4, box({10, 0, -10})));
}

}  // namespace
}  // namespace rakelight
