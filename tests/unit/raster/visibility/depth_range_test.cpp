// SPDX-License-Identifier: Apache-2.0
// Surfaces are told apart however far from the scene the camera's near and far planes stand.
#include <gtest/gtest.h>

#include <limits>

#include "engines/raster/inspect/inspection.h"
#include "engines/raster/raster_engine.h"
#include "support/scene_builder.h"

namespace rakelight::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A red square, and a green one 0.01 before it that comes later.
Scene two_squares() {
    Scene scene;
    for (const vec3 color : {vec3{1, 0, 0}, vec3{0, 1, 0}}) {
        scene.materials.push_back(matte(color));
        scene.materials.back().model = MaterialModel::unlit;
    }
    add_object(scene, square_mesh(0));
    add_object(scene, square_mesh(1), translation(dvec3{0, 0, 0.01}));
    return scene;
}

Camera camera_of(Projection projection, double near, double far) {
    Camera camera = flat_camera();
    camera.projection = projection;
    camera.z_near = near;
    camera.z_far = far;
    return camera;
}

Frame render(const Camera& camera, Visibility visibility = Visibility::z_reversed) {
    Context context({.threads = 1});
    const auto engine = raster::make_engine();
    engine->prepare(two_squares(), context);
    Frame frame;
    engine->render(camera, {.width = 16, .height = 16, .channels = channel_depth, .visibility = visibility}, frame,
                   context);
    return frame;
}

const Camera unusual[] = {
    camera_of(Projection::perspective, 1e-320, infinity), camera_of(Projection::perspective, 1e-38, infinity),
    camera_of(Projection::perspective, 1e-38, 1e30),      camera_of(Projection::perspective, 1e-20, 1e20),
    camera_of(Projection::orthographic, 0, 1e5),          camera_of(Projection::orthographic, 0, 1e9),
    camera_of(Projection::orthographic, -1e30, 1e30),     camera_of(Projection::orthographic, -1e300, 1e300),
};

TEST(DepthRange, TheNearerSurfaceIsSeenAtItsDistanceHoweverFarNearAndFarAre) {
    for (const Camera& camera : unusual) {
        const Frame f = render(camera);
        EXPECT_EQ(f.color[8 * 16 + 8], (vec4{0, 1, 0, 1})) << camera.z_near << " to " << camera.z_far;
        EXPECT_NEAR(f.depth[8 * 16 + 8], 4.99, 1e-4) << camera.z_near << " to " << camera.z_far;
    }
}

TEST(DepthRange, WhatTheCameraLeavesOutStaysOut) {
    for (const auto& [near, far] : {std::pair{4.995, 1e9}, {-1e9, 4.0}, {6.0, 1e9}}) {
        const Frame f = render(camera_of(Projection::orthographic, near, far));
        EXPECT_EQ(f.color[8 * 16 + 8].x, near < 5 && far > 5 ? 1.0f : RenderSettings{}.background.x)
            << near << " to " << far;
    }
}

TEST(DepthRange, TheTextbooksFormatsKeepTheCamerasOwn) {
    const Camera camera = camera_of(Projection::orthographic, 0, 1e5);
    EXPECT_EQ(render(camera, Visibility::z16).color[8 * 16 + 8], (vec4{1, 0, 0, 1})) << "one step is 1.5 m";
    EXPECT_EQ(render(camera, Visibility::z32).color[8 * 16 + 8], (vec4{0, 1, 0, 1}));
}

TEST(DepthRange, AnExplainedPixelIsThatOfThePicture) {
    for (const Camera& camera : unusual) {
        Context context({.threads = 1});
        const raster::Inspection inspection(two_squares(), camera, {.width = 16, .height = 16}, context);
        const auto pixel = inspection.explain(8, 8, context);
        EXPECT_EQ(pixel.color, (vec4{0, 1, 0, 1}));
        EXPECT_EQ(pixel.sum, pixel.color);
    }
}

}  // namespace
}  // namespace rakelight::test
