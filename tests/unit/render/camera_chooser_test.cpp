// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include <rakelight/render/camera_chooser.h>
#include <rakelight/render/picture.h>
#include <rakelight/scene/motion.h>
#include <rakelight/world/load.h>

#include "support/shared.h"
#include "unit/render/test_scene.h"

namespace rakelight {
namespace {

std::vector<std::string> remarks_of(Context& context) {
    std::vector<std::string> texts;
    for (const auto& entry : context.report().entries()) texts.push_back(entry.message);
    return texts;
}

const std::vector<ViewRequest>& views() {
    static const std::vector<ViewRequest> list{
        {},
        {.side = "isometric"},
        {.side = "top", .orthographic = true},
        {.azimuth_rad = 1.0, .elevation_rad = 0.5},
        {.direction = dvec3{1, 2, 3}, .zoom_factor = 0.3},
        {.position = dvec3{0, 0, 9}},
        {.position = dvec3{4, 5, 9}, .focal_point = dvec3{1, 1, 1}},
        {.vertical_fov_rad = 0.2, .horizontal_fov_rad = 0.4},
        {.z_near = 1e6, .z_far = 2e6},
    };
    return list;
}

void expect_as_chosen(const Scene& scene) {
    Context context;
    const CameraChooser chooser(scene, context);
    for (const ViewRequest& view : views())
        for (const double aspect : {0.5, 2.0}) {
            Context by_function, by_chooser;
            EXPECT_EQ(chooser.choose(view, aspect, by_chooser), choose_camera(scene, view, aspect, by_function));
            EXPECT_EQ(remarks_of(by_chooser), remarks_of(by_function));
        }
}

TEST(CameraChooser, ChoosesAsChooseCameraToTheBit) { expect_as_chosen(test::two_squares()); }

TEST(CameraChooser, TakesCamerasOfTheFileAndWarnsOfThoseThatSeeNothing) {
    Scene scene = test::two_squares();
    Camera away;
    away.to_world[3] = {0, 0, -1e4, 1};
    scene.cameras = {away};
    expect_as_chosen(scene);
}

TEST(CameraChooser, ShowsVerticesWhereTheyArePosed) {
    Context context;
    const std::filesystem::path file = test::shared_dir() / "assets/gltf/RiggedFigure/RiggedFigure.glb";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << file;
    Scene scene = load(file, {}, context);
    expect_as_chosen(scene);
    const ClipTime late{0, 0.8};
    expect_as_chosen(scene_at(scene, {&late, 1}));
}

TEST(CameraChooser, RefusesWhatChooseCameraRefuses) {
    Context context;
    CameraChooser chooser(test::two_squares(), context);
    EXPECT_THROW(chooser.choose({}, 0, context), Error);
    EXPECT_THROW(chooser.choose({.side = "file"}, 1, context), Error);
    EXPECT_THROW(chooser.choose({.position = dvec3{1e20, 0, 0}}, 1, context), Error);
    EXPECT_THROW(CameraChooser(Scene{}, context).choose({}, 1, context), Error) << "nothing to draw";
    Scene broken = test::two_squares();
    broken.nodes[0].meshes = {99};
    EXPECT_THROW(CameraChooser(broken, context), Error);
    const CameraChooser moved = std::move(chooser);
    EXPECT_NO_THROW(moved.choose({}, 1, context));
}

}  // namespace
}  // namespace rakelight
