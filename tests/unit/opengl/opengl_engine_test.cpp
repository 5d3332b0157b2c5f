// SPDX-License-Identifier: Apache-2.0
// The engine gl beside the soft one, and what it says when it cannot.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include <rakelight/tools/strip_sink.h>

#include "engines/raster/raster_engine.h"
#include "scene/scene_tools.h"
#include "support/scene_builder.h"
#include "support/temporary_folder.h"
#include "support/thrown_error.h"
#include "unit/opengl/opengl_test.h"

namespace rakelight {
namespace {

using test::EnvironmentVariable, test::OpenGl;

RenderSettings small() {
    RenderSettings s;
    s.width = 64, s.height = 48;
    return s;
}

Camera oblique() {
    Camera camera;
    camera.vertical_fov_rad = 0.8;
    camera.to_world = look_at({1.2, 1.5, 3}, {0, 0, 0}, {0, 1, 0});
    return camera;
}

/// Two squares that cross, one behind the other, textured and lit.
Scene two_squares() {
    Scene scene;
    Material m = test::matte({0.8f, 0.5f, 0.2f});
    m.base_color_texture = test::add_texture(scene, test::picture(test::rgb_pixels(8, 8, [](int x, int y) {
                                                 return std::array{200, 30 * x, 30 * y};
                                             })));
    scene.materials = {m, test::matte({0.2f, 0.6f, 0.9f})};
    test::add_object(scene, test::square_mesh(0));
    test::add_object(scene, test::square_mesh(1), translation(dvec3{0.4, 0.3, 0.3}));
    scene.lights = {test::directional({-1, -1, -2})};
    scene.lights[0].ambient = {0.1f, 0.1f, 0.1f};
    return scene;
}

Frame drawn(Engine& engine, const Scene& scene, const RenderSettings& settings, Context& context,
            const Camera& camera = oblique()) {
    engine.prepare(scene, context);
    Frame frame;
    engine.render(camera, settings, frame, context);
    return frame;
}

Frame by_soft(const Scene& scene, const RenderSettings& settings, Context& context, const Camera& camera = oblique()) {
    return drawn(*raster::make_engine(), scene, settings, context, camera);
}

double rmse(const Frame& a, const Frame& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) {
            const double d = double(a.color[i][c]) - double(b.color[i][c]);
            sum += d * d;
        }
    return std::sqrt(sum / (4 * double(a.color.size())));
}

TEST_F(OpenGl, ChannelsAreThoseOfTheSoftEngine) {
    RenderSettings settings = small();
    settings.channels = channels_all;
    const Frame soft = by_soft(two_squares(), settings, context), gl = drawn(*engine, two_squares(), settings, context);
    EXPECT_EQ(gl.object, soft.object);
    EXPECT_EQ(gl.mesh, soft.mesh);
    EXPECT_EQ(gl.material, soft.material);
    EXPECT_EQ(gl.triangle, soft.triangle);
    EXPECT_EQ(gl.overdraw, soft.overdraw);
    const auto is_near = [](const auto& a, const auto& b, std::size_t components, double tolerance, const char* what) {
        ASSERT_EQ(a.size(), b.size()) << what;
        for (std::size_t i = 0; i < a.size(); ++i)
            for (std::size_t c = 0; c < components; ++c)
                ASSERT_NEAR(a[i][c], b[i][c], tolerance) << what << " of pixel " << i;
    };
    for (std::size_t i = 0; i < gl.depth.size(); ++i) {
        if (std::isinf(soft.depth[i]))
            ASSERT_TRUE(std::isinf(gl.depth[i]));
        else
            ASSERT_NEAR(gl.depth[i], soft.depth[i], 1e-5 * soft.depth[i]);
    }
    is_near(gl.normal, soft.normal, 3, 1e-5, "normal");
    is_near(gl.face_normal, soft.face_normal, 3, 1e-5, "face normal");
    is_near(gl.position, soft.position, 3, 1e-4, "position");
    is_near(gl.barycentric, soft.barycentric, 3, 1e-4, "barycentrics");
    is_near(gl.tangent, soft.tangent, 4, 1e-5, "tangent");
    is_near(gl.uv, soft.uv, 2, 1e-4, "texture coordinates");
    is_near(gl.uv1, soft.uv1, 2, 0, "second texture coordinates");
    is_near(gl.base_color, soft.base_color, 3, 0.01, "base color");
    is_near(gl.ambient, soft.ambient, 3, 0.01, "ambient");
    is_near(gl.diffuse, soft.diffuse, 3, 0.01, "diffuse");
    is_near(gl.specular, soft.specular, 3, 0.01, "specular");
    is_near(gl.emission, soft.emission, 3, 0.01, "emission");
}

TEST_F(OpenGl, AWindowIsAPartOfThePicture) {
    RenderSettings settings = small();
    const Frame whole = drawn(*engine, two_squares(), settings, context);
    settings.window = {10, 5, 40, 30};
    Frame part;
    engine->render(oblique(), settings, part, context);
    std::size_t differing = 0;
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
            const vec4 a = part.color[std::size_t(40 * y + x)], b = whole.color[std::size_t(64 * (y + 5) + x + 10)];
            differing += std::fabs(a.x - b.x) > 2e-3f || std::fabs(a.y - b.y) > 2e-3f;
        }
    EXPECT_LE(differing, 6u) << "but for pixels at edges, which rounding may turn over";
}

/// Holds few rows at once.
class NarrowSink final : public StripSink {
public:
    void begin(int width, int height, Window window, std::uint32_t) override {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        rows = 0;
        color.assign(std::size_t(width) * std::size_t(height), {});
        area = window;
    }
    int rows_at_once() const override { return 16; }
    void tile(const Tile& t) override {
        EXPECT_GE(t.area.y, rows);
        EXPECT_LE(t.area.y + t.area.height, rows + 16);
        for (int y = 0; y < t.area.height; ++y)
            for (int x = 0; x < t.area.width; ++x)
                color[std::size_t((t.area.y + y) * area.width + t.area.x + x)] =
                    t.color[std::size_t(y * t.area.width + x)];
    }
    void rows_done(int first, int count) override {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_EQ(first, rows);
        rows += count;
    }
    void end_pass(int) override { EXPECT_EQ(std::this_thread::get_id(), caller); }
    const std::thread::id caller = std::this_thread::get_id();
    int rows = 0;
    Window area{};
    std::vector<vec4> color;
};

TEST_F(OpenGl, StripsGiveTheSamePicture) {
    const Frame whole = drawn(*engine, two_squares(), small(), context);
    NarrowSink sink;
    engine->render(oblique(), small(), sink, context);
    EXPECT_EQ(sink.rows, 48);
    EXPECT_EQ(sink.color, whole.color);
}

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

TEST_F(OpenGl, ASceneThatFailsLeavesRoomForTheNext) {
    const Frame expected = drawn(*engine, two_squares(), small(), context);
    Scene other = two_squares();
    other.environment = Environment{};
    drawn(*engine, other, small(), context);
    Context cancelled({.threads = 1});
    cancelled.cancel();
    EXPECT_EQ(test::error_of([&] { engine->prepare(two_squares(), cancelled); }).code(), ErrorCode::failed);
    Frame frame;
    engine->render(oblique(), small(), frame, context);  // of nothing
    for (const vec4& c : frame.color) ASSERT_NEAR(c.z, small().background.z, 1e-4);
    EXPECT_EQ(rmse(drawn(*engine, two_squares(), small(), context), expected), 0);
}

/// Three points and a line beside them.
Scene lines_and_points() {
    Scene scene;
    scene.materials = {test::matte({0.9f, 0.2f, 0.1f})};
    scene.materials[0].model = MaterialModel::unlit;
    Mesh points;
    points.topology = Topology::points;
    points.positions = std::vector<vec3>{{-0.5f, 0, 0}, {0, 0.3f, 0}, {0.5f, 0, 0}};
    points.indices = std::vector<std::uint32_t>{0, 1, 2};
    test::add_object(scene, points);
    Mesh line = points;
    line.topology = Topology::lines;
    line.indices = std::vector<std::uint32_t>{0, 2};
    line.positions = std::vector<vec3>{{-0.5f, -0.6f, 0.2f}, {}, {0.5f, -0.6f, -0.7f}};
    line.colors = std::vector<vec4>{{1, 0, 0, 1}, {0, 0, 0, 1}, {0, 1, 1, 1}};
    test::add_object(scene, line);
    return scene;
}

TEST_F(OpenGl, LinesAndPointsAreCountedAndHeldAsBySoft) {
    RenderSettings settings = small();
    settings.point_size = 7, settings.line_width = 3;
    settings.channels = channel_object | channel_mesh | channel_material | channel_depth | channel_position;
    const auto soft = raster::make_engine();
    soft->prepare(lines_and_points(), context), engine->prepare(lines_and_points(), context);
    Frame a, b;
    const RenderStats by_soft = soft->render(oblique(), settings, a, context);
    const RenderStats by_gl = engine->render(oblique(), settings, b, context);
    EXPECT_LT(rmse(a, b), 0.01) << "but for the borders of points over the line";
    EXPECT_EQ(a.object, b.object);
    EXPECT_EQ(a.mesh, b.mesh);
    EXPECT_EQ(a.material, b.material);
    for (std::size_t i = 0; i < a.depth.size(); ++i) {
        if (std::isinf(a.depth[i])) continue;
        ASSERT_NEAR(b.depth[i], a.depth[i], 1e-4 * a.depth[i]);
        for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(b.position[i][c], a.position[i][c], 1e-3);
    }
    EXPECT_GT(by_soft.pixels_marked, 50u);
    EXPECT_NEAR(double(by_gl.pixels_marked), double(by_soft.pixels_marked), 12) << "but for the line behind points";
    EXPECT_EQ(by_gl.pixels_covered, 0u);
}

/// A bent sheet of points in many colors, nearer to each other than they are wide.
Scene colored_cloud() {
    Scene scene;
    scene.materials = {test::matte({1, 1, 1})};
    scene.materials[0].model = MaterialModel::unlit;
    Mesh points;
    points.topology = Topology::points;
    std::vector<vec3> places;
    std::vector<vec4> colors;
    std::vector<std::uint32_t> indices;
    for (int n = 0; n < 400; ++n) {
        const float x = float(n % 20) / 10 - 1, y = float(n / 20) / 10 - 1;
        places.push_back({x + 0.3f * y * y, y, 0.5f * x * x - 0.4f * y});
        colors.push_back({float(n % 3) / 2, float(n % 5) / 4, float(n % 2), 1});
        indices.push_back(std::uint32_t(n));
    }
    points.positions = places, points.colors = colors, points.indices = indices;
    test::add_object(scene, points);
    return scene;
}

TEST_F(OpenGl, OverlappingPointsPartAsBySoftAndNothingShowsThroughTheirBorders) {
    RenderSettings settings = small();
    settings.width = 200, settings.height = 150;
    settings.channels = channel_depth | channel_base_color;
    for (const bool is_parallel : {false, true})
        for (const PointShape shape : {PointShape::none, PointShape::square})
            for (const float size : {2.0f, 17.0f}) {
                Camera camera = oblique();
                if (is_parallel) camera.projection = Projection::orthographic, camera.half_height = 1.2;
                settings.points = shape, settings.point_size = size;
                const auto soft = raster::make_engine();
                soft->prepare(colored_cloud(), context), engine->prepare(colored_cloud(), context);
                Frame a, b;
                soft->render(camera, settings, a, context), engine->render(camera, settings, b, context);
                std::size_t others = 0, covered = 0;
                for (std::size_t i = 0; i < a.color.size(); ++i) {
                    covered += !std::isinf(a.depth[i]);
                    const vec3 d = a.color[i].xyz() - b.color[i].xyz();
                    others += dot(d, d) > 0.01f || std::isinf(a.depth[i]) != std::isinf(b.depth[i]) ||
                              a.base_color[i] != b.base_color[i];
                }
                EXPECT_GT(covered, size > 10 ? 5000u : 500u);
                EXPECT_LT(double(others), 0.02 * double(covered)) << is_parallel << int(shape) << ' ' << size;
            }
}

TEST_F(OpenGl, EdgesInANearAndFarRangeAreHiddenBySurfaces) {
    RenderSettings settings = small();
    settings.width = 200, settings.height = 150;
    settings.edges = true;
    settings.line_width = 3;
    settings.line_color = {0.1f, 0.9f, 0.1f, 1};
    Camera camera = oblique();
    camera.z_near = 2.5, camera.z_far = 6;  // far is near: nearness is not near / distance
    EXPECT_LT(rmse(drawn(*engine, two_squares(), settings, context, camera),
                   by_soft(two_squares(), settings, context, camera)),
              0.02);
    camera.projection = Projection::orthographic;
    camera.half_height = 1.5;
    EXPECT_LT(rmse(drawn(*engine, two_squares(), settings, context, camera),
                   by_soft(two_squares(), settings, context, camera)),
              0.02);
}

TEST_F(OpenGl, AnotherSceneTakesThePlaceOfTheFirst) {
    drawn(*engine, two_squares(), small(), context);
    Scene scene = two_squares();
    scene.materials[0].base_color_texture = {};
    scene.nodes.pop_back();
    EXPECT_LT(rmse(drawn(*engine, scene, small(), context), by_soft(scene, small(), context)), 0.003);
}

TEST_F(OpenGl, SamplesBeyondTheDriversAreRefusedBeforeAnythingIsDrawn) {
    const EngineCapabilities can = engine->capabilities();
    EXPECT_EQ(can.samples.front(), 1);
    EXPECT_FALSE(can.visibility_methods);
    EXPECT_TRUE(can.user_lighting && can.lines_and_points && can.shadows);
    EXPECT_EQ(can.channels, channels_all);
}

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
    EXPECT_FALSE(engine->capabilities().screen_interpolation) << "ES has no noperspective";
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

TEST_F(OpenGl, ACancelledPictureIsAnErrorAndTheNextOneIsWhole) {
    const Frame whole = drawn(*engine, two_squares(), small(), context);
    Context cancelled({.threads = 1});
    cancelled.cancel();
    Frame frame;
    EXPECT_EQ(test::error_of([&] { engine->render(oblique(), small(), frame, cancelled); }).code(), ErrorCode::failed);
    engine->render(oblique(), small(), frame, context);
    EXPECT_EQ(rmse(whole, frame), 0);
}

TEST_F(OpenGl, WhatIsNotFiniteIsShownBlackAndCounted) {
    Scene scene = two_squares();
    scene.lights[0].diffuse = {3e38f, 3e38f, 3e38f};
    scene.materials[1].base_color = {3e38f, 0, 0, 1};
    scene.materials[0] = scene.materials[1];
    scene.materials[0].emission = scene.materials[1].emission = {0, 0, 0};
    const Frame frame = drawn(*engine, scene, small(), context);
    for (const vec4& c : frame.color) ASSERT_TRUE(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z));
}

TEST_F(OpenGl, CountsSayWhatWasDrawn) {
    engine->prepare(two_squares(), context);
    Frame frame;
    RenderStats stats = engine->render(oblique(), small(), frame, context);
    EXPECT_EQ(stats.triangles_in, 4u);
    EXPECT_EQ(stats.objects_outside, 0u);
    EXPECT_GT(stats.pixels_covered, 200u);
    EXPECT_LT(stats.pixels_covered, 64u * 48);
    EXPECT_GT(stats.depth_passes, stats.pixels_covered) << "the squares overlap";
    EXPECT_EQ(std::ranges::count(stats.gpu_passes, "surfaces", &GpuPass::name), 1);
    Camera away = oblique();
    away.to_world = look_at({1.2, 1.5, 3}, {3, 3, 6}, {0, 1, 0});
    stats = engine->render(away, small(), frame, context);
    EXPECT_EQ(stats.objects_outside, 2u);
    EXPECT_EQ(stats.pixels_covered, 0u);
}

}  // namespace
}  // namespace rakelight
