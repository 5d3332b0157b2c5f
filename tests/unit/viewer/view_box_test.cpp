// SPDX-License-Identifier: Apache-2.0
#include "../../../apps/viewer/view/view_box.h"

#include <gtest/gtest.h>

#include <rakelight/math/linear.h>
#include <rakelight/world/load.h>

namespace rakelight::viewer {
namespace {

/// A teapot with a camera on a node that another one carries.
Scene scene_with_cameras() {
    Context context;
    Scene scene = load("builtin:teapot", {}, context);
    const std::uint32_t first = std::uint32_t(scene.nodes.size());
    scene.nodes.push_back({.name = "arm", .local = {.translation = {0.1, 0.7, 0.3}}});
    scene.nodes.push_back({.name = "head", .parent = first, .local = {.translation = {0, 0, 3.3}}});
    scene.cameras.push_back({.name = "mounted", .node = first + 1, .vertical_fov_rad = radians(33), .aspect = 2.5});
    scene.cameras.push_back({.to_world = look_at({1, 2, 3}, {0, 0, 0}, {0, 1, 0}), .half_height = 2});
    scene.cameras.back().projection = Projection::orthographic;
    return scene;
}

/// What a moment moves: one of the two squares, by a clip of its node.
Scene scene_in_motion() {
    Scene scene = scene_with_cameras();
    AnimationChannel channel;
    channel.element = 0, channel.path = AnimationPath::translation;
    channel.times = std::vector<float>{0, 1};
    channel.values = std::vector<float>{0, 0, 0, 8, -3, 5};
    Animation clip;
    clip.channels = {channel};
    scene.animations = {clip};
    return scene;
}

TEST(ViewBox, KeepsOnlyNodesThatCarryCameras) {
    Context context;
    Scene scene = scene_with_cameras();
    for (int i = 0; i < 1000; ++i) scene.nodes.insert(scene.nodes.begin(), Node{.name = "idle"});
    for (Node& node : scene.nodes)
        if (node.parent != no_index) node.parent += 1000;
    scene.cameras[0].node += 1000;
    const ViewBox box(scene);
    EXPECT_EQ(box.camera(scene, {.camera = "mounted"}, 1), choose_camera(scene, {.camera = "mounted"}, 1, context));
    EXPECT_EQ(box.node_count(), 4u) << "arm, head, two corners";
}

TEST(ViewBox, GivesTheCamerasOfTheWholeSceneToTheBit) {
    Context context;
    const Scene scene = scene_with_cameras();
    const ViewBox box(scene);
    const ViewRequest views[] = {{},
                                 {.side = "top"},
                                 {.side = "default", .up = dvec3{0, 0, 1}},
                                 {.world_up = dvec3{0, 0, 1}, .direction = dvec3{1, 2, 3}, .zoom_factor = 0.5},
                                 {.camera = "1"},
                                 {.camera = "mounted"},
                                 {.position = dvec3{1, 0.3, 2}},
                                 {.position = dvec3{0, 0.5, 0}, .focal_point = dvec3{0, 0.5, -1}},
                                 {.vertical_fov_rad = radians(70), .orthographic = true}};
    for (const ViewRequest& view : views)
        for (const double aspect : {0.3, 1.6})
            EXPECT_EQ(box.camera(scene, view, aspect), choose_camera(scene, view, aspect, context))
                << view.side << view.camera;
}

TEST(ViewBox, WhoWalksThroughALargeSceneSeesWhatIsClose) {
    Context context;
    Scene scene = scene_in_motion();
    scene.nodes.push_back({.local = {.translation = {0, 0, -15'000}}, .meshes = {0}});
    const ViewBox box(scene);
    const ViewRequest view{.position = dvec3{0, 0.6, 1.5}, .focal_point = dvec3{0, 0.6, 0}};
    const Camera camera = box.camera(scene, view, 1.5);
    EXPECT_LT(camera.z_near, 1.5 / 2) << "far / 10,000 is 1.5 m";
    EXPECT_EQ(camera, choose_camera(scene, view, 1.5, context));
    EXPECT_EQ(camera, box.quick_camera(scene, view, 1.5, std::vector<ClipTime>{{0, 1}}));
}

TEST(ViewBox, GivesTheCamerasOfEveryMomentToTheBit) {
    Context context;
    const Scene scene = scene_in_motion();
    const ViewBox box(scene);
    const ViewRequest views[] = {
        {}, {.side = "top"}, {.camera = "mounted"}, {.position = dvec3{4, 5, 9}, .focal_point = dvec3{1, 1, 1}}};
    for (const double time : {0.25, 1.0, 0.25}) {
        const std::vector<ClipTime> clips{{0, time}};
        for (const ViewRequest& view : views)
            EXPECT_EQ(box.camera(scene, view, 1.5, clips), choose_camera(scene_at(scene, clips), view, 1.5, context))
                << view.side << view.camera << time;
    }
    const ViewRequest front{.side = "front"};
    EXPECT_NE(box.camera(scene, front, 1.5, std::vector<ClipTime>{{0, 1}}), box.camera(scene, front, 1.5));
}

TEST(ViewBox, NamesCamerasByNumberWhereTheyHaveNoName) {
    const ViewBox box(scene_with_cameras());
    ASSERT_EQ(box.cameras().size(), 2u);
    EXPECT_EQ(box.cameras()[0], "mounted");
    EXPECT_EQ(box.cameras()[1], "camera 1");
}

TEST(ViewBox, RefusesAnEmptyScene) { EXPECT_THROW(ViewBox{Scene{}}, Error); }

}  // namespace
}  // namespace rakelight::viewer
