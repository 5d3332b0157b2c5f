// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/document/eye.h"

#include <gtest/gtest.h>

#include <cmath>

#include <rakelight/math/linear.h>

namespace rakelight::viewer {
namespace {

constexpr dvec3 y_up{0, 1, 0};

void expect_near(dvec3 a, dvec3 b, double tolerance = 1e-9) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

Bounds unit_box() {
    Bounds box;
    box.low = {-1, -1, -1}, box.high = {1, 1, 1};
    return box;
}

TEST(Eye, TurntableGoesRoundAndKeepsItsDistance) {
    Eye eye;
    turn_table(eye, radians(90), 0, y_up);
    expect_near(eye.position, {-5, 0, 0});  // the pointer went right: the model turns with it
    expect_near(eye.up, y_up);
    turn_table(eye, 0, radians(30), y_up);  // y grows downwards: seen from above
    EXPECT_NEAR(distance_of(eye), 5, 1e-12);
    EXPECT_NEAR(eye.position.y, 5 * std::sin(radians(30)), 1e-9);
}

TEST(Eye, TurntableStopsBeforeThePoleAndComesBack) {
    Eye eye;
    for (int i = 0; i < 100; ++i) turn_table(eye, 0.01, radians(10), y_up);
    EXPECT_GT(eye.position.y, 4.99);
    EXPECT_LT(eye.position.y, 5);
    EXPECT_GT(dot(eye.up, y_up), 0);
    turn_table(eye, 0, radians(-89.5), y_up);
    EXPECT_NEAR(eye.position.y, 0, 1e-9);
}

TEST(Eye, TurntableLeavesAViewFromAboveWithoutAJump) {
    Eye eye{.position = {0, 5, 0}, .up = {0, 0, -1}};
    turn_table(eye, 0.001, 0, y_up);
    EXPECT_NEAR(eye.position.y, 5, 1e-9);
    EXPECT_NEAR(dot(eye.up, dvec3{0, 0, -1}), std::cos(0.001), 1e-9);
    turn_table(eye, 0, radians(-30), y_up);
    EXPECT_NEAR(eye.position.y, 5 * std::cos(radians(30)), 1e-9);
    EXPECT_GT(dot(eye.up, y_up), 0.4);
}

TEST(Eye, TurntableTurnsAboutTheUpAxisOfTheWorld) {
    Eye eye{.position = {0, -5, 0}, .up = {0, 0, 1}};
    turn_table(eye, radians(90), 0, {0, 0, 1});
    EXPECT_NEAR(eye.position.z, 0, 1e-9);
    EXPECT_NEAR(std::fabs(eye.position.x), 5, 1e-9);
}

TEST(Eye, WhatTheArcballHoldsFollowsThePointer) {
    Eye eye;
    const dvec2 from{0.1, -0.2}, to{0.3, 0.15};
    // The point of a unit ball about the focal point that lies under `from` lies under `to` afterwards.
    const dvec3 held{from.x, from.y, std::sqrt(1 - from.x * from.x - from.y * from.y)};
    turn_ball(eye, from, to);
    EXPECT_NEAR(dot(held, right_of(eye)), to.x, 1e-9);
    EXPECT_NEAR(dot(held, eye.up), to.y, 1e-9);
    EXPECT_NEAR(distance_of(eye), 5, 1e-12);
    EXPECT_NEAR(dot(eye.up, forward_of(eye)), 0, 1e-12);
}

TEST(Eye, PannedPointsFollowThePointer) {
    Eye eye;
    const double height = 2 * 5 * std::tan(radians(20));
    pan(eye, 300, 0, 600);  // half the height
    expect_near(eye.focal, {-0.5 * height, 0, 0});
    pan(eye, 0, 300, 600);
    expect_near(eye.focal, {-0.5 * height, 0.5 * height, 0});
    EXPECT_NEAR(distance_of(eye), 5, 1e-12);
}

TEST(Eye, ZoomStopsBeforeThePointItLooksAt) {
    Eye eye;
    for (int i = 0; i < 200; ++i) dolly(eye, 0.5);
    EXPECT_GT(distance_of(eye), 0);
    for (int i = 0; i < 400; ++i) dolly(eye, 2);
    EXPECT_TRUE(std::isfinite(distance_of(eye)));
    EXPECT_LT(length(eye.position), 1e15);
}

TEST(Eye, RolledPicturesStayUpright) {
    Eye eye;
    roll(eye, radians(90));
    EXPECT_NEAR(dot(eye.up, y_up), 0, 1e-12);
    for (int i = 0; i < 3; ++i) roll(eye, radians(90));
    expect_near(eye.up, y_up);
}

TEST(Eye, WalkingGoesWhereTheHeadLooks) {
    Eye eye;
    look(eye, radians(-90), 0, y_up);  // the pointer goes left
    expect_near(eye.position, {0, 0, 5});
    expect_near(forward_of(eye), {-1, 0, 0});
    walk(eye, 2, 0, 1, y_up);
    expect_near(eye.position, {-2, 1, 5});
    walk(eye, 0, 1, 0, y_up);
    expect_near(eye.position, {-2, 1, 4});
}

TEST(Eye, TheEyeOfACameraSeesWhatTheCameraSees) {
    Camera camera;
    camera.to_world = look_at({4, 3, 2}, {0, 0, 0}, y_up);
    camera.vertical_fov_rad = radians(50);
    const Eye eye = eye_of(camera, unit_box());
    expect_near(eye.position, {4, 3, 2});
    expect_near(eye.focal, {0, 0, 0});
    EXPECT_NEAR(eye.fov_deg, 50, 1e-12);
    camera.projection = Projection::orthographic;
    camera.half_height = 3;
    const Eye parallel = eye_of(camera, unit_box());
    EXPECT_TRUE(parallel.is_orthographic);
    EXPECT_NEAR(distance_of(parallel) * std::tan(radians(20)), 3, 1e-9);
}

TEST(Eye, PlacingKeepsNearAndFarOfARequest) {
    ViewRequest view{.side = "front", .z_near = 0.5, .z_far = 7};
    place(view, Eye{.fov_deg = 30, .is_orthographic = true}, {0, 1, 0});
    EXPECT_TRUE(view.side.empty());
    EXPECT_EQ(view.z_near, 0.5);
    EXPECT_EQ(view.z_far, 7);
    EXPECT_EQ(view.position, (dvec3{0, 0, 5}));
    EXPECT_TRUE(view.orthographic);
}

TEST(Eye, ARequestHasTheWorldsUpUnlessTheViewIsRolledOrSteep) {
    const auto up_of = [](const Eye& eye, dvec3 world_up) {
        ViewRequest view;
        place(view, eye, world_up);
        return *view.up;
    };
    Eye eye;
    turn_table(eye, 0.7, 0.4, {0, 1, 0});
    EXPECT_EQ(up_of(eye, {0, 1, 0}), (dvec3{0, 1, 0}));
    EXPECT_EQ(up_of(eye, {0, 0, 1}), eye.up);  // of another world
    Eye rolled = eye;
    roll(rolled, 0.3);
    EXPECT_EQ(up_of(rolled, {0, 1, 0}), rolled.up);
    eye.position = eye.focal + dvec3{0, 5, 0};
    EXPECT_EQ(up_of(eye, {0, 1, 0}), eye.up);
}

TEST(Eye, PixelsThatAreNotSquareStaySo) {
    Camera camera;
    camera.vertical_fov_rad = radians(40), camera.horizontal_fov_rad = radians(90);
    ViewRequest view;
    place(view, eye_of(camera, unit_box()), {0, 1, 0});
    EXPECT_NEAR(*view.vertical_fov_rad, radians(40), 1e-12);
    EXPECT_NEAR(*view.horizontal_fov_rad, radians(90), 1e-12);
}

}  // namespace
}  // namespace rakelight::viewer
