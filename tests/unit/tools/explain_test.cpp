// SPDX-License-Identifier: Apache-2.0
// Explained pixels of real models: the sum is the picture's color to the bit.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include <rakelight/scene/scene_queries.h>
#include <rakelight/tools/explain.h>

#include "engines/raster/inspect/inspection.h"
#include "engines/raster/raster_engine.h"
#include "support/scene_builder.h"
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

namespace {

/// Seen from above in parallel.
Scene lit_square(std::vector<Light> lights, vec3 color = {0.8f, 0.8f, 0.8f}) {
    Scene scene;
    scene.materials = {matte(color)};
    add_object(scene, square_mesh(0, 0.8f));
    scene.cameras = {flat_camera()};
    scene.lights = std::move(lights);
    return scene;
}

/// The last line, of the pixel in the middle.
std::string conclusion(const Scene& scene, bool shadows = false, int x = 16) {
    Context context({.threads = 1});
    PictureRequest request{.input = "square"};
    request.settings.width = request.settings.height = 32;
    request.settings.shadows = shadows;
    if (scene.lights.empty()) request.lights.emplace();
    const std::string text = to_text(*explain(scene, request, x, 16, context));
    const std::string begin = "\nIn short: ";
    return text.substr(std::min(text.rfind(begin), text.size() - begin.size()) + begin.size());
}

}  // namespace

TEST(Explain, TheLastLineSaysWhichTermMakesMostOfThePixel) {
    Light around;
    around.type = LightType::ambient;
    around.ambient = {0.25f, 0.25f, 0.25f};
    around.name = "sky";
    const Light sun = directional({0, 0, -1}, {0.75f, 0.75f, 0.75f});
    EXPECT_EQ(conclusion(lit_square({around, sun})),
              "75 % of its light is the diffuse term of light 1 (directional).\n");
    EXPECT_EQ(
        conclusion(lit_square({around, directional({0, 0, 1}, {2, 2, 2})})),
        "100 % of its light is the ambient term of light 0 (ambient, sky); the strongest light, 1 (directional), is "
        "below the surface (n.l <= 0).\n");
    EXPECT_EQ(conclusion(lit_square({around})), "100 % of its light is the ambient term of light 0 (ambient, sky).\n");
    EXPECT_EQ(conclusion(lit_square({sun}), false, 0), "the background.\n");
    Scene glass = lit_square({sun});
    glass.materials.push_back(glass.materials[0]);
    glass.materials[1].alpha_mode = AlphaMode::blend;
    glass.materials[1].base_color.w = 0.25f;
    add_object(glass, square_mesh(1, 0.5f), translation(dvec3{0, 0, 1}));
    EXPECT_EQ(conclusion(glass).substr(0, 32), "layer 0 makes 75 % of the pixel;");
    Scene own = lit_square({sun});
    own.materials[0].model = MaterialModel::unlit;
    EXPECT_EQ(conclusion(own), "100 % of its light is its own color, which is unlit.\n");
}

TEST(Explain, TheLastLineOfADarkPixelSaysWhatMakesItDark) {
    const Light sun = directional({0, 0, -1}), from_below = directional({0, 0, 1}), slanting = directional({1, 0, -1}),
                grazing = directional({1, 0, -0.01});
    EXPECT_EQ(conclusion(lit_square({from_below})),
              "black, because light 0 (directional) is below the surface (n.l <= 0).\n");
    EXPECT_EQ(conclusion(lit_square({})), "black, because the scene has no light.\n");
    Scene shadowed = lit_square({slanting});
    add_object(shadowed, square_mesh(0, 0.3f), translation(dvec3{-1, 0, 1}));
    EXPECT_EQ(conclusion(shadowed, true), "black, because light 0 (directional) is in shadow.\n");
    EXPECT_EQ(conclusion(lit_square({grazing, from_below})),
              "dark, because light 0 (directional) is at a grazing angle, light 1 (directional) is below the surface "
              "(n.l <= 0); 100 % of its light is the diffuse term of light 0 (directional).\n");
    EXPECT_EQ(conclusion(lit_square({sun}, {0.01f, 0.01f, 0.01f})).substr(0, 46),
              "dark, because the surface reflects little (k a");
    Light spot = directional({0, 0, -1}), lamp = spot;
    spot.type = LightType::spot, lamp.type = LightType::point;
    spot.position = lamp.position = {1, 1, 2};
    lamp.range = 1, spot.cutoff_rad = 0.2f;
    const std::string both = conclusion(lit_square({spot, lamp, from_below, from_below, from_below}));
    EXPECT_EQ(both.substr(0, both.find(", light 2")),
              "black, because light 0 (spot) shines past it, light 1 (point) does not reach this far");
    EXPECT_NE(both.find(", 2 more contribute nothing or little."), std::string::npos) << both;
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
