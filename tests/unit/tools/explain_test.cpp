// SPDX-License-Identifier: Apache-2.0
// Explained pixels of real models: the sum is the picture's color to the bit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include <rakelight/explain.h>

#include "engines/raster/inspect/inspection.h"
#include "engines/raster/raster_engine.h"
#include "scene/scene_tools.h"
#include "support/shared.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int width = 160, height = 120;

struct Look {
    int samples = 1, anisotropy = 1, step = 7;
    std::string camera;
};

/// Explains a grid of pixels of a model; returns how many showed it.
int expect_explained(const std::string& file, const Look& look = {}) {
    Context context({.threads = 1});
    Scene scene = load(file, {}, context);
    const Camera camera = choose_camera(scene, {.camera = look.camera}, double(width) / height, context);
    if (scene.lights.empty()) scene.lights = default_lights(camera.to_world);
    scene = prepare_scene(scene, {}, context);
    const RenderSettings settings{
        .width = width, .height = height, .samples = look.samples, .anisotropy = look.anisotropy};
    const auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    engine->render(camera, settings, frame, context);
    const raster::Inspection inspection(scene, camera, settings, context);
    int shown = 0;
    for (int y = 0; y < height; y += look.step)
        for (int x = y % look.step; x < width; x += look.step) {
            const raster::PixelExplanation e = inspection.explain(x, y, context);
            const vec4 drawn = frame.color[std::size_t(y * width + x)];
            EXPECT_EQ(std::memcmp(&e.sum, &drawn, sizeof drawn), 0) << file << " " << x << "," << y;
            EXPECT_EQ(std::memcmp(&e.color, &drawn, sizeof drawn), 0) << file << " " << x << "," << y;
            shown += !e.layers.empty();
        }
    return shown;
}

}  // namespace

TEST(Explain, ThePixelsOfTheTeapotAddUp) {
    EXPECT_GT(expect_explained("builtin:teapot"), 50);
    EXPECT_GT(expect_explained("builtin:teapot", {.samples = 8}), 50);
}

TEST(Explain, ThePixelsOfRealModelsAddUp) {
    RL_NEEDS_SHARED("assets");
    for (const char* name : {"FlightHelmet", "AlphaBlendModeTest", "TextureSettingsTest", "NegativeScaleTest",
                             "MultiUVTest", "BoomBoxWithAxes", "GlamVelvetSofa"}) {
        const std::filesystem::path folder = shared_dir() / "assets/gltf" / name;
        int found = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            if (entry.path().extension() != ".gltf" && entry.path().extension() != ".glb") continue;
            ++found;
            EXPECT_GT(expect_explained(entry.path().string()), 10) << entry.path();
            EXPECT_GT(expect_explained(entry.path().string(), {.samples = 4, .anisotropy = 8, .step = 13}), 3)
                << entry.path();
            break;
        }
        EXPECT_EQ(found, 1) << name;
    }
    const std::string cameras = (shared_dir() / "assets/gltf/Cameras/Cameras.gltf").string();
    EXPECT_GT(expect_explained(cameras, {.samples = 4, .camera = "1"}), 10) << "the orthographic one";
}

TEST(Explain, CodesAndColorAreThoseOfTheText) {
    Context context({.threads = 1});
    PictureRequest request{.input = "builtin:teapot"};
    request.settings.width = width;
    request.settings.height = height;
    const auto pixel = explain(request, width / 2, height / 2, context);
    const std::vector<std::uint8_t> codes = codes_of(*pixel);
    ASSERT_EQ(codes.size(), 3u);
    std::string line = "sRGB code ";
    for (const int code : codes) line += " " + std::to_string(code);
    EXPECT_NE(to_text(*pixel).find(line + "\n"), std::string::npos);
    request.settings.background.w = 0;
    EXPECT_EQ(codes_of(*explain(request, 0, 0, context)).size(), 4u);
}

TEST(Explain, ASceneThatIsThereIsExplainedAsItIsDrawn) {
    Context context({.threads = 1});
    PictureRequest request{.input = "builtin:teapot"};
    request.settings.width = width;
    request.settings.height = height;
    const Scene scene = load(request.input, {}, context);
    const auto color = [&](const Scene& of) { return color_of(*explain(of, request, width / 2, height / 2, context)); };
    EXPECT_EQ(color(scene), color_of(*explain(request, width / 2, height / 2, context)));
    request.input = "no such file.obj";  // a name alone
    Scene red = scene;
    for (Material& material : red.materials) material.base_color = {1, 0, 0, 1};
    EXPECT_NE(color(red), color(scene));
    request.settings.samples = 3;
    EXPECT_THROW((void)color(scene), Error);
}

TEST(Explain, TheWindowOfARangeIsAPartOfTheAttenuationAndSaid) {
    Context context({.threads = 1});
    Scene scene = load("builtin:teapot", {}, context);
    const Camera camera = choose_camera(scene, {}, double(width) / height, context);
    Light lamp, classical, endless;
    for (Light* light : {&lamp, &classical, &endless}) light->type = LightType::point, light->position = {1, 2, 2};
    lamp.units = LightUnits::photometric;
    lamp.range = classical.range = 4;
    classical.linear = 0.25f, classical.quadratic = 0.125f;
    scene.lights = {lamp, classical, endless};
    scene = prepare_scene(scene, {}, context);
    const raster::Inspection inspection(scene, camera, {.width = width, .height = height}, context);
    const raster::PixelExplanation e = inspection.explain(width / 2, height / 2, context);
    ASSERT_FALSE(e.layers.empty());
    const std::vector<raster::TracedLight>& lights = e.layers[0].lights;
    const double d = double(lights[0].distance), window = 1 - std::pow(d / 4, 4);
    EXPECT_NEAR(double(lights[0].range_window), window, 1e-6);
    EXPECT_NEAR(double(lights[0].attenuation), window / (d * d), 1e-6);
    EXPECT_NEAR(double(lights[1].range_window), window, 1e-6);
    EXPECT_NEAR(double(lights[1].attenuation), window / (1 + 0.25 * d + 0.125 * d * d), 1e-6);
    EXPECT_EQ(lights[2].range_window, 1.0f);
}

TEST(Explain, BadPixelsAndModelsAreErrorsOfTheirKind) {
    Context context({.threads = 1});
    PictureRequest request{.input = "no such file.obj"};
    const auto code_of = [&](int x, int y) {
        try {
            explain(request, x, y, context);
        } catch (const Error& error) {
            return error.code();
        }
        return ErrorCode::failed;
    };
    EXPECT_EQ(code_of(1280, 0), ErrorCode::usage);  // before anything is loaded
    EXPECT_EQ(code_of(0, 0), ErrorCode::not_found);
}
