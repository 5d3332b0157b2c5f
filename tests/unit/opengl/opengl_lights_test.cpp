// SPDX-License-Identifier: Apache-2.0
// Many lights and shadow maps in the engine gl.

#include "support/scene_builder.h"
#include "support/thrown_error.h"
#include "unit/opengl/opengl_scenes.h"
#include "unit/opengl/opengl_test.h"

namespace rakelight {
namespace {

using test::by_soft, test::drawn, test::oblique, test::rmse, test::small, test::two_squares;
using test::OpenGl;

TEST_F(OpenGl, ManyLightsAreListedForSquaresOfPixels) {
    Scene scene = two_squares();
    scene.lights.clear();
    for (int i = 0; i < 60; ++i) {
        Light light;
        light.position = {-1.5 + 0.05 * i, 1.2 * std::sin(0.7 * i), 0.4};
        light.range = 0.7f;
        light.diffuse = light.specular = {0.3f * float(i % 3), 0.2f, 0.1f * float(i % 5)};
        scene.lights.push_back(light);
    }
    RenderSettings settings = small();
    settings.width = 200, settings.height = 150;
    EXPECT_LT(rmse(drawn(*engine, scene, settings, context), by_soft(scene, settings, context)), 0.004);
    for (const Shading shading : {Shading::gouraud, Shading::flat}) {
        settings.shading = shading;
        EXPECT_LT(rmse(drawn(*engine, scene, settings, context), by_soft(scene, settings, context)), 0.004);
    }
}

TEST_F(OpenGl, NineLightsAreATableForTrianglesThatAreLookedUpToo) {
    Scene scene = two_squares();
    scene.materials[0].normal_texture = scene.materials[0].base_color_texture;
    scene.lights.clear();
    for (int i = 0; i < 9; ++i) {
        scene.lights.push_back(test::directional({-1 + 0.2 * i, 0.3, -1}));
        scene.lights.back().diffuse = scene.lights.back().specular = {0.02f * float(i), 0.1f, 0.2f - 0.02f * float(i)};
    }
    RenderSettings settings = small();
    settings.shading = Shading::flat;
    EXPECT_LT(rmse(drawn(*engine, scene, settings, context), by_soft(scene, settings, context)), 0.004);
    settings.shading = Shading::phong;
    settings.tangent_space = TangentSpace::vertex;
    EXPECT_LT(rmse(drawn(*engine, scene, settings, context), by_soft(scene, settings, context)), 0.004);
}

TEST_F(OpenGl, OtherLightsMakeOtherShadowMaps) {
    Scene scene = two_squares();
    scene.lights = {test::directional({-0.3, -0.2, -1})};
    RenderSettings settings = small();
    settings.shadows = true;
    const Frame first = drawn(*engine, scene, settings, context);
    scene.lights[0].direction = {0.6, 0.1, -1};
    engine->set_lights(scene.lights);
    Frame second;
    const RenderStats stats = engine->render(oblique(), settings, second, context);
    EXPECT_EQ(stats.shadow_maps, 1u);
    EXPECT_GT(rmse(first, second), 0.01);
    EXPECT_LT(rmse(second, by_soft(scene, settings, context)), 0.01);
}

TEST_F(OpenGl, ShadowMapsThatDoNotFitLeaveNoneBehind) {
    Scene scene = two_squares();
    scene.lights.assign(40, test::directional({-0.3, -0.2, -1}));
    for (Light& light : scene.lights) light.diffuse = light.specular = {0.02f, 0.02f, 0.02f};
    RenderSettings settings = small();
    settings.shadows = true;
    settings.shadow_size = 64;
    const Frame first = drawn(*engine, scene, settings, context);
    settings.shadow_size = 8192;
    Frame frame;
    Context roomy({.threads = 1, .max_memory = std::uint64_t(64) << 30});
    EXPECT_EQ(test::error_of([&] { engine->render(oblique(), settings, frame, roomy); }).code(), ErrorCode::failed);
    settings.shadow_size = 64;
    engine->render(oblique(), settings, frame, context);
    EXPECT_EQ(rmse(first, frame), 0);
}

}  // namespace
}  // namespace rakelight
