// SPDX-License-Identifier: Apache-2.0
// Names of saved files, and what a saved scene does not hold.
#include "looks.h"

namespace rakelight::viewer {
namespace {

TEST_F(Looks, SeamlessModelsGetANameThatIsFree) {
    EXPECT_EQ(free_seamless_name(file("helmet.gltf")), file("helmet-seamless.gltf"));
    folder_.write("helmet-seamless.gltf", "mine");
    folder_.write("helmet-seamless-2.gltf", "mine, too");
    EXPECT_EQ(free_seamless_name(file("helmet.gltf")), file("helmet-seamless-3.gltf"));
    EXPECT_EQ(free_seamless_name(file("part.stl")), file("part-seamless.glb"));
    EXPECT_EQ(free_seamless_name("builtin:teapot"), "teapot-seamless.glb");
    EXPECT_EQ(free_seamless_name("builtin:sphere:tolerance=0.1"), "sphere-tolerance-0.1-seamless.glb");
}

TEST_F(Looks, WhatIsNotSavedIsSaid) {
    const auto m = model(write_model());
    Look look = first_look(*m);
    EXPECT_EQ(not_saved(look), "");
    std::vector<LightItem>& lights = changing_lights(look, *m, width, height);
    EXPECT_EQ(not_saved(look), "");
    lights[0].is_on = false;
    EXPECT_EQ(not_saved(look), "1 light that is off");
    lights[1].is_on = false;
    lights[2].follows_camera = true;
    look.channel = channel_depth;
    EXPECT_EQ(not_saved(look), "2 lights that are off, that a light follows the camera, the data channel shown");
}

}  // namespace
}  // namespace rakelight::viewer
