// SPDX-License-Identifier: Apache-2.0
// What an engine keeps for the next picture is charged as long as it is kept.
#include <gtest/gtest.h>

#include "unit/raster/shadows/shadow_scenes.h"

using namespace rakelight;
using namespace rakelight::test;

TEST(KeptMemory, VerticesOfALargerPictureStayPaidOrAreGivenBack) {
    Scene both;
    both.materials = {matte()};
    both.lights = {lamp({2, 5, 1})};
    for (const double x : {0.0, 6.0}) add_object(both, sphere_mesh(64, 128), translation(dvec3{x, 0, 0}));
    const auto charged_after = [](const Scene& scene, const std::vector<Camera>& cameras) {
        Context context({.threads = 1});
        const std::unique_ptr<Engine> engine = raster::make_engine();
        engine->prepare(scene, context);
        const std::uint64_t before = context.memory().charged();
        Frame frame;
        for (const Camera& camera : cameras) engine->render(camera, {.width = 32, .height = 24}, frame, context);
        return context.memory().charged() - before;
    };
    const Camera of_two = looking({3, 0, 14}, {3, 0, 0}), of_one = looking({0, 0, 2.5}, {0, 0, 0}),
                 of_none = looking({0, 0, 4}, {0, 0, 8});
    const std::uint64_t two = charged_after(both, {of_two}), none_seen = charged_after(both, {of_none});
    EXPECT_GT(two, 2 * 64 * 128 * 32u);
    EXPECT_LT(charged_after(both, {of_one}), two);
    EXPECT_GE(charged_after(both, {of_two, of_one}), 2 * 64 * 128 * 32u) << "its stores are there still";
    EXPECT_EQ(charged_after(both, {of_two, of_none}), none_seen) << "given back";
}
