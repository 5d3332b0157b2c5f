// SPDX-License-Identifier: Apache-2.0
// Programs of the engine gl: texture units, lighting models of the user's, OpenGL ES, the program cache.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "engines/opengl/context/headless.h"
#include "engines/opengl/programs/features.h"
#include "engines/opengl/programs/program_cache.h"
#include "engines/opengl/programs/programs.h"
#include "support/scene_builder.h"
#include "support/temporary_folder.h"
#include "support/thrown_error.h"
#include "unit/opengl/opengl_scenes.h"
#include "unit/opengl/opengl_test.h"

namespace rakelight {
namespace {

using test::by_soft, test::drawn, test::oblique, test::rmse, test::small, test::two_squares;
using test::EnvironmentVariable, test::OpenGl;

TEST_F(OpenGl, AMaterialWithMoreMapsThanUnitsLosesTheLeastVisible) {
    const EnvironmentVariable few("RAKELIGHT_GL_TEXTURE_UNITS", "8");
    engine = opengl::make_engine();
    Scene scene = two_squares();
    Material& m = scene.materials[0];
    const TextureUse use = m.base_color_texture;
    m.model = MaterialModel::metallic_roughness;
    m.normal_texture = m.occlusion_texture = m.emission_texture = m.metallic_roughness.texture = use;
    m.metallic_roughness.clearcoat = 1;
    m.metallic_roughness.clearcoat_roughness_texture = use;
    m.emission = {0.1f, 0.1f, 0.1f};
    scene.lights[0].ambient = {0.2f, 0.2f, 0.2f};
    drawn(*engine, scene, small(), context);
    const auto entries = context.report().entries();
    const auto warning =
        std::ranges::find_if(entries, [](const ReportEntry& e) { return e.message.find("textures left out") == 0; });
    ASSERT_NE(warning, entries.end());
    EXPECT_NE(warning->message.find("clearcoat_roughness"), std::string::npos) << warning->message;
    EXPECT_EQ(warning->message.find("base_color"), std::string::npos) << warning->message;
}

TEST_F(OpenGl, OfThirteenMapsAndSixteenUnitsTheLeastVisibleGoes) {
    const EnvironmentVariable units("RAKELIGHT_GL_TEXTURE_UNITS", "16");
    engine = opengl::make_engine();
    Scene scene = two_squares();
    Material& m = scene.materials[0];
    const TextureUse use = m.base_color_texture;
    m.model = MaterialModel::metallic_roughness;
    m.normal_texture = m.occlusion_texture = m.emission_texture = use;
    m.emission = {0.1f, 0.1f, 0.1f};
    MetallicRoughnessParameters& p = m.metallic_roughness;
    p.texture = p.specular_texture = p.specular_color_texture = p.anisotropy_texture = p.clearcoat_texture = use;
    p.clearcoat_roughness_texture = p.clearcoat_normal_texture = p.sheen_color_texture = p.sheen_roughness_texture =
        use;
    p.anisotropy = 0.4f, p.clearcoat = 0.5f, p.clearcoat_roughness = 0.3f;
    p.sheen_color = {0.2f, 0.1f, 0.3f}, p.sheen_roughness = 0.5f;
    scene.lights[0].ambient = {0.2f, 0.2f, 0.2f};
    const Frame all = drawn(*engine, scene, small(), context);
    const auto entries = context.report().entries();
    ASSERT_EQ(
        std::ranges::count_if(entries, [](const ReportEntry& e) { return e.message.starts_with("textures left out"); }),
        1);
    EXPECT_TRUE(std::ranges::any_of(entries, [](const ReportEntry& e) {
        return e.message.starts_with("textures left out: clearcoat_roughness: this OpenGL driver samples 16");
    }));
    p.clearcoat_roughness_texture = {};
    EXPECT_LT(rmse(all, by_soft(scene, small(), context)), 0.004) << "all others act";
}

constexpr const char* steps =
    "RL_FN LightTerms user_terms(RL_IN(MaterialSurface) s, RL_IN(LightSample) light)\n"
    "{\n"
    "    LightTerms terms;\n"
    "    terms.ambient = vec3(0.0f);\n"
    "    terms.diffuse = s.base.diffuse * (light.diffuse * floor(3.0f * lambert_cosine(dot(s.diffuse_n, light.l))));\n"
    "    terms.specular = vec3(0.0f);\n"
    "    return terms;\n"
    "}\n";

TEST_F(OpenGl, ATextOfTheUsersTakesThePlaceOfAllModels) {
    RenderSettings settings = small();
    settings.lighting_name = "steps.glsl", settings.lighting_text = steps;
    Scene scene = two_squares();
    scene.materials[0] = scene.materials[1];
    scene.lights = {test::directional({0, 0, -1})};
    const Frame frame = drawn(*engine, scene, settings, context);
    const vec4 middle = frame.color[24 * 64 + 32];
    EXPECT_NEAR(middle.x, 3 * 0.2f, 0.002) << "facing the light: three steps";
    settings.lighting_text = std::string(steps).replace(std::string(steps).find("3.0f"), 4, "2.0f");
    Frame other;
    engine->render(oblique(), settings, other, context);
    EXPECT_NEAR(other.color[24 * 64 + 32].x, 2 * 0.2f, 0.002) << "a text that changed is compiled anew";
}

TEST_F(OpenGl, AFaultOfTheUsersTextIsNamedByItsFileAndLine) {
    RenderSettings settings = small();
    settings.lighting_name = "steps.glsl";
    settings.lighting_text =
        std::string(steps).replace(std::string(steps).find("vec3(0.0f);\n    terms.diffuse"), 11, "vec3(0.0f) ");
    const Error error = test::error_of([&] { drawn(*engine, two_squares(), settings, context); });
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_NE(error.reason().find("steps.glsl:5"), std::string::npos) << error.reason();
}

TEST_F(OpenGl, AUsersTextWithoutTheFunctionIsItsFault) {
    RenderSettings settings = small();
    settings.lighting_name = "empty.glsl", settings.lighting_text = "// user_terms is not here\n";
    const Error error = test::error_of([&] { drawn(*engine, two_squares(), settings, context); });
    EXPECT_EQ(error.code(), ErrorCode::bad_file);
    EXPECT_NE(error.reason().find("empty.glsl"), std::string::npos) << error.reason();
}

TEST_F(OpenGl, Es30CountsAndMarksAsCore33) {
    Scene scene = two_squares();
    RenderSettings settings = small();
    settings.edges = true;
    engine->prepare(scene, context);
    Frame core, es;
    const RenderStats by_core = engine->render(oblique(), settings, core, context);
    const EnvironmentVariable wish("RAKELIGHT_GL", "es");
    engine = opengl::make_engine();
    engine->prepare(scene, context);
    const RenderStats by_es = engine->render(oblique(), settings, es, context);
    EXPECT_LT(rmse(core, es), 0.002);
    EXPECT_NEAR(double(by_es.pixels_covered), double(by_core.pixels_covered), 2);
    EXPECT_EQ(by_es.depth_passes, 0u) << "not known";
}

TEST_F(OpenGl, Es30DrawsThePictureOfCore33) {
    const Frame core = drawn(*engine, two_squares(), small(), context);
    const EnvironmentVariable es("RAKELIGHT_GL", "es");
    engine = opengl::make_engine();
    EXPECT_TRUE(engine->capabilities().screen_interpolation);
    EXPECT_LT(rmse(drawn(*engine, two_squares(), small(), context), core), 0.002);
    RenderSettings settings = small();
    settings.channels = channel_object | channel_normal;
    settings.shadows = true;
    settings.shading = Shading::flat;
    const Frame flat = drawn(*engine, two_squares(), settings, context);
    EXPECT_EQ(flat.object, by_soft(two_squares(), settings, context).object);
}

TEST_F(OpenGl, ProgramsAreKeptAsFilesAndABrokenOneIsMadeAnew) {
    const test::TemporaryFolder folder;
    const EnvironmentVariable cache("XDG_CACHE_HOME", folder.path().c_str()), on("RAKELIGHT_GL_CACHE", "on");
    const Frame first = drawn(*opengl::make_engine(), two_squares(), small(), context);
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
        if (entry.is_regular_file() && entry.path().extension() == ".bin") files.push_back(entry.path());
    if (files.empty()) GTEST_SKIP() << "this driver has no binary programs";
    const Frame second = drawn(*opengl::make_engine(), two_squares(), small(), context);
    EXPECT_EQ(rmse(first, second), 0);
    for (const auto& file : files) std::ofstream(file, std::ios::binary) << "no program at all";
    const Frame third = drawn(*opengl::make_engine(), two_squares(), small(), context);
    EXPECT_EQ(rmse(first, third), 0);
}

TEST_F(OpenGl, OfManyProgramsThoseOfTheLastPictureAndTheLatestOnesAreKept) {
    const opengl::HeadlessContext current;
    const opengl::Driver driver = opengl::ask_driver();
    opengl::Programs programs(driver, 3);
    const auto draw = [&](std::initializer_list<int> lights) {
        programs.begin_picture();
        for (const int count : lights) {
            opengl::Features features;
            features.light_count = count;
            programs.of(features);
        }
    };
    const std::vector<std::size_t> wanted = {2, 4, 3, 3};
    std::vector<std::size_t> counts;
    draw({1, 2}), counts.push_back(programs.count());
    draw({3, 4}), counts.push_back(programs.count());  // all of the picture before stay while it begins
    draw({3, 4}), counts.push_back(programs.count());  // 1 or 2 goes
    draw({4}), counts.push_back(programs.count());
    EXPECT_EQ(counts, wanted);
}

TEST(ProgramCache, TheLeastUsedFilesAreRemoved) {
    const test::TemporaryFolder folder;
    const auto now = std::filesystem::file_time_type::clock::now();
    for (int i = 0; i < 5; ++i) {
        folder.write(std::to_string(i), std::string(100, 'x'));
        std::filesystem::last_write_time(folder.file(std::to_string(i)), now - std::chrono::hours(i == 0 ? 1 : 10 - i));
    }
    opengl::remove_least_used(folder.path(), 300);
    std::vector<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        left.push_back(entry.path().filename());
    std::ranges::sort(left);
    EXPECT_EQ(left, (std::vector<std::string>{"0", "3", "4"}));
}

}  // namespace
}  // namespace rakelight
