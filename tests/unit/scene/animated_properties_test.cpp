// SPDX-License-Identifier: Apache-2.0
// Numbers that channels set and that are right only beside one another.
#include <gtest/gtest.h>
#include <rakelight/scene/motion.h>
#include <rakelight/scene/validate.h>

#include <algorithm>
#include <limits>

#include "scenes.h"

namespace rakelight::test {
namespace {

/// A channel that says one thing at all times.
AnimationChannel set_to(AnimationPath path, const char* property, std::vector<float> values) {
    AnimationChannel channel;
    channel.element = 0, channel.path = path, channel.property = property;
    channel.times = std::vector<float>{0};
    channel.values = std::move(values);
    return channel;
}

/// The scene with these numbers, in either order of the channels, which must not count.
Scene with(Scene scene, std::vector<AnimationChannel> channels) {
    const ClipTime clip{0, 0};
    scene.animations = {{"clip", channels}};
    const Scene there = scene_at(scene, std::span(&clip, 1));
    std::ranges::reverse(channels);
    scene.animations = {{"clip", channels}};
    const Scene back = scene_at(scene, std::span(&clip, 1));
    EXPECT_EQ(there.cameras, back.cameras);
    EXPECT_EQ(there.lights, back.lights);
    EXPECT_NO_THROW(validate(there));
    return there;
}

Scene with_camera(Camera camera) {
    Scene scene;
    scene.cameras = {camera};
    return scene;
}

TEST(AnimatedProperties, PlanesOfACameraMoveTogetherOrNotAtAll) {
    const auto planes = [](float near, float far) {
        const Camera camera = with(with_camera({}), {set_to(AnimationPath::camera, "near", {near}),
                                                     set_to(AnimationPath::camera, "far", {far})})
                                  .cameras[0];
        return std::pair(camera.z_near, camera.z_far);
    };
    EXPECT_EQ(planes(2000, 4000), std::pair(2000.0, 4000.0));
    EXPECT_EQ(planes(0.01f, 0.05f), std::pair(double(0.01f), double(0.05f)));
    EXPECT_EQ(planes(5, 4), std::pair(0.1, 1000.0)) << "nothing could be seen";
    EXPECT_EQ(planes(-1, 4), std::pair(0.1, 1000.0));
}

TEST(AnimatedProperties, ClipsApartFromTheirSceneAreThoseOfTheirList) {
    const std::vector<Animation> clips = {{"clip", {set_to(AnimationPath::camera, "far", {7})}}};
    MemoryBudget memory;
    const auto far = [&](Scene still, std::vector<ClipTime> times) {
        return scene_at(std::move(still), clips, times, memory).cameras[0].z_far;
    };
    EXPECT_EQ(far(with_camera({}), {{0, 0}}), 7);
    Scene with_own_clips = with_camera({});
    with_own_clips.animations = {{}, {}};
    EXPECT_EQ(far(with_own_clips, {{0, 0}}), 7);
    EXPECT_THROW(far(with_own_clips, {{1, 0}}), Error);
    EXPECT_THROW(far(with_camera({}), {{0, 0}, {0, 0}, {1, 0}}), Error);
    EXPECT_THROW(far(with_camera({}), {{0, std::numeric_limits<double>::quiet_NaN()}}), Error);
}

TEST(AnimatedProperties, ConesGrowAndShrinkTogether) {
    Scene scene;
    scene.lights = {Light{
        .type = LightType::spot, .units = LightUnits::photometric, .inner_cone_rad = 0.25f, .outer_cone_rad = 0.5f}};
    const auto cones = [&](float inner, float outer) {
        const Light light = with(scene, {set_to(AnimationPath::light, "inner_cone", {inner}),
                                         set_to(AnimationPath::light, "outer_cone", {outer})})
                                .lights[0];
        return std::pair(light.inner_cone_rad, light.outer_cone_rad);
    };
    EXPECT_EQ(cones(0.75f, 1), std::pair(0.75f, 1.0f));
    EXPECT_EQ(cones(0.0625f, 0.125f), std::pair(0.0625f, 0.125f));
    EXPECT_EQ(cones(1, 0.5f), std::pair(0.5f, 0.5f));
}

TEST(AnimatedProperties, AParallelProjectionWithAnAspectKeepsItsWidth) {
    Camera camera;
    camera.projection = Projection::orthographic, camera.half_height = 2, camera.aspect = 2;
    const auto size = [&](std::vector<AnimationChannel> channels) {
        const Camera c = with(with_camera(camera), std::move(channels)).cameras[0];
        return std::pair(c.half_height * *c.aspect, c.half_height);
    };
    const AnimationChannel width = set_to(AnimationPath::camera, "half_width", {8}),
                           height = set_to(AnimationPath::camera, "half_height", {1});
    EXPECT_EQ(size({width}), std::pair(8.0, 2.0));
    EXPECT_EQ(size({height}), std::pair(4.0, 1.0));
    EXPECT_EQ(size({width, height}), std::pair(8.0, 1.0));
}

}  // namespace
}  // namespace rakelight::test
