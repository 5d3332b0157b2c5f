// SPDX-License-Identifier: Apache-2.0
#include "render/output/overlay.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/output/ground_grid.h"
#include "support/scene_builder.h"

namespace rakelight {
namespace {

using test::add_object;
using test::square_mesh;

TEST(GroundGrid, StepsAreOneTwoOrFiveTimesAPowerOfTen) {
    EXPECT_EQ(step_of_scale(1), 1);
    EXPECT_EQ(step_of_scale(1.99), 1);
    EXPECT_EQ(step_of_scale(2), 2);
    EXPECT_EQ(step_of_scale(4.9), 2);
    EXPECT_EQ(step_of_scale(77), 50);
    EXPECT_EQ(step_of_scale(1e6), 1e6);
    EXPECT_NEAR(step_of_scale(0.03), 0.02, 1e-15);
    EXPECT_NEAR(step_of_scale(1e-9) / 1e-9, 1, 1e-9);
}

/// Sees the ground from above in parallel: 100 pixels a meter, the origin in the middle.
shading::PictureCamera from_above() {
    Camera camera = test::flat_camera();
    camera.half_height = 2;
    camera.z_near = 0.1, camera.z_far = 100;
    camera.to_world = {};
    camera.to_world[1] = {0, 0, -1, 0}, camera.to_world[2] = {0, 1, 0, 0}, camera.to_world[3] = {0, 10, 0, 1};
    return shading::make_picture_camera(camera, camera.to_world, {.width = 400, .height = 400});
}

TEST(GroundGrid, LinesLieAtWholeSteps) {
    const Bounds bounds{{-1, 0, -1}, {1, 1, 1}};
    const GroundGrid grid(from_above(), {0, 1, 0}, bounds, false);
    EXPECT_EQ(grid.step(), 0.2);
    const double far = 1e30;
    EXPECT_GT(grid.at(199, 250, far).w, 0.4);                       // x = -0.005, beside the axis
    EXPECT_GT(grid.at(220, 210, far).w, 0.15);                      // x = 0.2
    EXPECT_EQ(grid.at(210, 210, far).w, 0);                         // between lines
    EXPECT_GT(grid.at(199, 250, far).z, grid.at(199, 250, far).x);  // the z axis is blue
    EXPECT_GT(grid.at(250, 199, far).x, grid.at(250, 199, far).z);  // the x axis is red
}

TEST(GroundGrid, IsHiddenByWhatIsNearer) {
    const Bounds bounds{{-1, -3, -1}, {1, 1, 1}};
    const GroundGrid grid(from_above(), {0, 1, 0}, bounds, false);
    EXPECT_GT(grid.at(200, 250, 13.1).w, 0.4);
    EXPECT_EQ(grid.at(200, 250, 12.9).w, 0);
}

TEST(GroundGrid, FadesAndEnds) {
    const Bounds bounds{{-0.1, 0, -0.1}, {0.1, 0.1, 0.1}};
    const GroundGrid grid(from_above(), {0, 1, 0}, bounds, true);
    const float near = grid.at(200, 201, 1e30).w, farther = grid.at(200, 230, 1e30).w;
    EXPECT_GT(near, farther);
    EXPECT_GT(farther, 0);
    EXPECT_EQ(grid.at(200, 260, 1e30).w, 0);
}

TEST(GroundGrid, LiesAcrossTheAxisThatIsUp) {
    const Bounds bounds{{-1, -1, 0}, {1, 1, 1}};
    Camera camera = test::flat_camera(10);  // along -z, which is down here
    camera.half_height = 2;
    const shading::PictureCamera view =
        shading::make_picture_camera(camera, camera.to_world, {.width = 400, .height = 400});
    const GroundGrid grid(view, {0, 0, 1}, bounds, false);
    EXPECT_GT(grid.at(200, 250, 1e30).w, 0.4);
    const GroundGrid seen_from_its_edge(view, {0, 1, 0}, bounds, false);
    EXPECT_EQ(seen_from_its_edge.at(200, 250, 1e30).w, 0);
}

Scene small_scene() {
    Scene scene;
    scene.source = "folder/model.glb";
    scene.materials.push_back(test::matte());
    add_object(scene, square_mesh(0));
    return scene;
}

PictureRequest request_with(const Overlays& overlays) {
    PictureRequest request;
    request.input = "folder/model.glb";
    request.settings.width = 200, request.settings.height = 160;
    request.overlays = overlays;
    return request;
}

TEST(Overlay, RowsAndWindowsAreThoseOfTheWhole) {
    Context context;
    const Overlay overlay(request_with({true, true, true, true}), small_scene(), test::flat_camera());
    EXPECT_TRUE(overlay.needs_depth());
    for (const PixelFormat format : {PixelFormat{Component::u8, 3}, PixelFormat{Component::u8, 4},
                                     PixelFormat{Component::f32, 3}, PixelFormat{Component::f32, 4}}) {
        std::vector<std::byte> whole(200 * 160 * format.bytes(), std::byte(60)), part(37 * 29 * format.bytes());
        if (format.component == Component::f32) whole.assign(whole.size(), std::byte(0));
        const std::vector<float> depth(200 * 160, 1e9f);
        for (const auto& [x, y] : {std::pair{0, 131}, {80, 0}, {163, 131}, {90, 70}}) {
            std::fill(part.begin(), part.end(), whole[0]);
            std::vector<std::byte> drawn = whole;
            overlay.draw({format, 0, 0, 200, 160, drawn.data(), depth.data()}, context);
            EXPECT_NE(drawn, whole);
            overlay.draw({format, x, y, 37, 29, part.data(), depth.data()}, context);
            for (int row = 0; row < 29; ++row)
                EXPECT_TRUE(std::equal(
                    part.begin() + std::ptrdiff_t(std::size_t(row) * 37 * format.bytes()),
                    part.begin() + std::ptrdiff_t(std::size_t(row + 1) * 37 * format.bytes()),
                    drawn.begin() + std::ptrdiff_t((std::size_t(y + row) * 200 + std::size_t(x)) * format.bytes())))
                    << x << ", " << y << ", " << row;
        }
    }
}

TEST(Overlay, IsEmptyWhereNothingIsAskedFor) {
    EXPECT_TRUE(Overlay(request_with({}), small_scene(), test::flat_camera()).is_empty());
    EXPECT_FALSE(Overlay(request_with({.axis = true}), small_scene(), test::flat_camera()).needs_depth());
    EXPECT_TRUE(Overlay(request_with({.grid = true}), Scene{}, test::flat_camera()).is_empty());
    PictureRequest tiny = request_with({.axis = true, .filename = true, .metadata = true});
    tiny.settings.width = tiny.settings.height = 1;
    Context context;
    std::byte pixel[3] = {};
    Overlay(tiny, small_scene(), test::flat_camera())
        .draw({{Component::u8, 3}, 0, 0, 1, 1, pixel, nullptr}, context);  // nothing out of bounds
}

TEST(Overlay, MetadataSaysHowMuchThereIs) {
    EXPECT_EQ(metadata_text("model.glb", small_scene()),
              "format GLB\nobjects 1\ntriangles 2\nmaterials 1\ntextures 0\nsize 2 x 2 x 0");
    EXPECT_EQ(metadata_text("builtin:teapot", Scene{}).substr(0, 15), "format built in");
}

}  // namespace
}  // namespace rakelight
