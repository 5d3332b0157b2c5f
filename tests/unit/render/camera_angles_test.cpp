// SPDX-License-Identifier: Apache-2.0
// Fields of view by either axis or both, against closed forms: what lies at an angle a from the axis is seen at
// tan(a) / tan(fov / 2) of half the picture.
#include <gtest/gtest.h>
#include <rakelight/rakelight.h>

#include <cmath>

#include "io/gltf/write/glb_writer.h"
#include "render/camera/camera_depths.h"
#include "support/temporary_folder.h"

namespace rakelight {
namespace {

constexpr int width = 200, height = 100;
const double right_of_axis = std::tan(radians(20)), above_axis = std::tan(radians(10));  // [m] at 1 m

/// A rectangle 1 m before an eye at the origin, from the axis to 20 degrees on its right and 10 degrees above it.
Scene rectangle() {
    const float x = float(right_of_axis), y = float(above_axis);
    Scene scene;
    scene.meshes.resize(1);
    scene.meshes[0].positions = std::vector<vec3>{{0, 0, -1}, {x, 0, -1}, {x, y, -1}, {0, y, -1}};
    scene.meshes[0].indices = std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3};
    scene.nodes.resize(1);
    scene.nodes[0].meshes = {0};
    return scene;
}

struct Extent {
    int columns = 0, rows = 0, pixels = 0;
    bool operator==(const Extent&) const = default;
};

/// Pixels that are covered in the row above the middle, in the column right of it, and at all.
Extent extent_of(const Frame& frame, vec4 background) {
    const auto is_covered = [&](int x, int y) { return frame.color[std::size_t(y * width + x)] != background; };
    Extent e;
    for (int x = 0; x < width; ++x) e.columns += is_covered(x, height / 2 - 1);
    for (int y = 0; y < height; ++y) e.rows += is_covered(width / 2, y);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) e.pixels += is_covered(x, y);
    return e;
}

Extent extent_seen_by(const Camera& camera) {
    Context context;
    const RenderSettings settings{.width = width, .height = height};
    return extent_of(render(rectangle(), camera, settings, context), settings.background);
}

/// What half tangents of the field of view across and up make of the rectangle.
Extent expected(double half_width, double half_height) {
    const int columns = int(std::lround(0.5 * width * right_of_axis / half_width));
    const int rows = int(std::lround(0.5 * height * above_axis / half_height));
    return {columns, rows, columns * rows};
}

Camera chosen(std::optional<double> vertical_deg, std::optional<double> horizontal_deg, bool orthographic) {
    Context context;
    ViewRequest view{.position = dvec3{0, 0, 0}, .focal_point = dvec3{0, 0, -1}, .orthographic = orthographic};
    if (vertical_deg) view.vertical_fov_rad = radians(*vertical_deg);
    if (horizontal_deg) view.horizontal_fov_rad = radians(*horizontal_deg);
    return choose_camera(rectangle(), view, double(width) / height, context);
}

void PrintTo(const Extent& e, std::ostream* out) { *out << e.columns << " x " << e.rows << ", " << e.pixels; }

TEST(CameraAngles, TheVerticalAngleAloneGivesSquarePixels) {
    const double half = std::tan(radians(30));
    for (const bool parallel : {false, true})
        EXPECT_EQ(extent_seen_by(chosen(60, {}, parallel)), expected(half * width / height, half)) << parallel;
}

TEST(CameraAngles, TheHorizontalAngleAloneGivesSquarePixels) {
    for (const bool parallel : {false, true}) {
        const Camera camera = chosen({}, 90, parallel);
        EXPECT_FALSE(camera.horizontal_fov_rad || camera.half_width);
        EXPECT_NEAR(std::tan(0.5 * camera.vertical_fov_rad), double(height) / width, 1e-15);
        EXPECT_EQ(extent_seen_by(camera), expected(1, double(height) / width)) << parallel;
    }
}

TEST(CameraAngles, BothAnglesHoldWhateverThePictureIs) {
    for (const bool parallel : {false, true}) {
        EXPECT_EQ(extent_seen_by(chosen(60, 90, parallel)), expected(1, std::tan(radians(30)))) << parallel;
        EXPECT_EQ(extent_seen_by(chosen(90, 60, parallel)), expected(std::tan(radians(30)), 1)) << parallel;
    }
}

TEST(CameraAngles, ACameraWithAWidthOfItsOwnKeepsItBesideItsAspect) {
    Camera camera;
    camera.vertical_fov_rad = radians(60);
    camera.horizontal_fov_rad = radians(90);
    camera.half_height = 0.7;
    camera.half_width = 0.9;
    camera.aspect = 8;
    EXPECT_EQ(extent_seen_by(camera), expected(1, std::tan(radians(30))));
    camera.projection = Projection::orthographic;
    EXPECT_EQ(extent_seen_by(camera), expected(0.9, 0.7));
}

TEST(CameraAngles, AnAngleThatIsAskedForReplacesBothOfTheScenesCamera) {
    Context context;
    Scene scene = rectangle();
    scene.cameras.resize(1);
    scene.cameras[0].horizontal_fov_rad = radians(90);
    scene.cameras[0].half_width = 3;
    const double aspect = double(width) / height;
    EXPECT_EQ(choose_camera(scene, {}, aspect, context).horizontal_fov_rad, radians(90));
    const ViewRequest up{.camera = "0", .vertical_fov_rad = radians(60)};
    EXPECT_EQ(extent_seen_by(choose_camera(scene, up, aspect, context)), extent_seen_by(chosen(60, {}, false)));
    scene.cameras[0].projection = Projection::orthographic;
    EXPECT_FALSE(choose_camera(scene, up, aspect, context).half_width);
}

TEST(CameraAngles, BothAnglesStillFitTheModel) {
    Context context;
    const Scene scene = rectangle();
    for (const auto& [up, across] : {std::pair{60.0, 5.0}, {5.0, 60.0}, {40.0, 40.0}}) {
        const ViewRequest view{.side = "front", .vertical_fov_rad = radians(up), .horizontal_fov_rad = radians(across)};
        const Camera camera = choose_camera(scene, view, double(width) / height, context);
        EXPECT_EQ(camera.horizontal_fov_rad, radians(across));
        for (const vec3 p : scene.meshes[0].positions) {
            const dvec3 corner{p.x, p.y, p.z};
            EXPECT_TRUE(may_see(camera, double(width) / height, Bounds{corner, corner})) << up << " " << across;
        }
    }
}

TEST(CameraAngles, WhatIsOutsideOfTheAngleAcrossIsNotSeen) {
    Camera camera;
    camera.vertical_fov_rad = radians(90);
    camera.horizontal_fov_rad = radians(30);
    const dvec3 at_20{right_of_axis, 0, -1}, at_10{above_axis, 0, -1};
    EXPECT_FALSE(may_see(camera, 2, Bounds{at_20, at_20}));
    EXPECT_TRUE(may_see(camera, 2, Bounds{at_10, at_10}));
    camera.projection = Projection::orthographic;
    camera.half_width = 0.3;
    EXPECT_FALSE(may_see(camera, 2, Bounds{at_20, at_20}));
    EXPECT_TRUE(may_see(camera, 2, Bounds{at_10, at_10}));
}

TEST(CameraAngles, WrittenFilesHaveThemAsAnAspect) {
    Context context;
    Scene scene = rectangle();
    scene.cameras.resize(2);
    for (Camera& camera : scene.cameras) {
        camera.vertical_fov_rad = radians(60);
        camera.horizontal_fov_rad = radians(90);
        camera.half_height = 0.5;
        camera.half_width = 2;
        camera.aspect = 8;
    }
    scene.cameras[1].projection = Projection::orthographic;
    const test::TemporaryFolder folder;
    const std::string path = folder.file("cameras.glb");
    io::write_glb(scene, path, context);
    const std::vector<Camera> read = load(path, {}, context).cameras;
    ASSERT_EQ(read.size(), 2u);
    EXPECT_NEAR(read[0].aspect.value_or(0), 1 / std::tan(radians(30)), 1e-6);
    EXPECT_NEAR(read[1].aspect.value_or(0), 4, 1e-6);
}

TEST(CameraAngles, ImpossibleOnesAreRefused) {
    Context context;
    for (const double angle : {0.0, -1.0, pi, 4.0, std::nan("")}) {
        EXPECT_THROW(choose_camera(rectangle(), {.horizontal_fov_rad = angle}, 1, context), Error) << angle;
        Camera camera;
        camera.horizontal_fov_rad = angle;
        EXPECT_THROW(extent_seen_by(camera), Error) << angle;
        camera = {};
        camera.projection = Projection::orthographic;
        camera.half_width = angle > 0 ? double(INFINITY) : angle;
        EXPECT_THROW(extent_seen_by(camera), Error) << angle;
    }
}

}  // namespace
}  // namespace rakelight
