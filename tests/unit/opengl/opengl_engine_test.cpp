// SPDX-License-Identifier: Apache-2.0
// The engine gl beside the soft one, and its messages when it cannot draw.
#include <rakelight/base/report.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "support/scene_builder.h"
#include "support/thrown_error.h"
#include "unit/opengl/opengl_scenes.h"
#include "unit/opengl/opengl_test.h"

namespace rakelight {
namespace {

using test::by_soft, test::drawn, test::oblique, test::rmse, test::small, test::two_squares;
using test::OpenGl;

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

/// Panes of glass over the picture, which lean to the right by these angles.
Scene leaning_panes(std::initializer_list<double> angles, double apart) {
    Scene scene;
    Material m = test::matte();
    m.alpha_mode = AlphaMode::blend;
    m.base_color.w = 0.5f;
    m.double_sided = true;
    scene.materials = {m};
    double z = 0;
    for (const double angle : angles)
        test::add_object(scene, test::square_mesh(0),
                         translation(dvec3{0, 0, z -= apart}) *
                             look_at({0, 0, 0}, {std::sin(angle), 0, -std::cos(angle)}, {0, 1, 0}));
    return scene;
}

std::vector<std::string> warnings_of(Context& context) {
    std::vector<std::string> texts;
    for (const ReportEntry& e : context.report().entries())
        if (e.remark == Remark::warning) texts.push_back(e.message);
    return texts;
}

TEST_F(OpenGl, WarnsWhereTransparentSurfacesCrossAndNowhereElse) {
    const auto warnings = [&](const Scene& scene) {
        Context own({.threads = 1});
        drawn(*engine, scene, small(), own);
        return warnings_of(own);
    };
    const std::vector<std::string> crossing = warnings(leaning_panes({0.3, -0.3}, 0));
    ASSERT_EQ(crossing.size(), 1u);
    EXPECT_NE(crossing[0].find("engines soft and trace"), std::string::npos) << crossing[0];
    EXPECT_TRUE(warnings(leaning_panes({0.3, 0.3}, 0.4)).empty());
    EXPECT_TRUE(warnings(leaning_panes({0.3, -0.3}, 3)).empty());
    EXPECT_TRUE(warnings(leaning_panes({0.3}, 0)).empty());
}

TEST_F(OpenGl, WarnsOfTransparentSurfacesThatCrossAndNotWhereAShaderMovesThem) {
    RenderSettings settings = small();
    const auto warnings = [&] {
        Context own({.threads = 1});
        Frame frame;
        engine->render(oblique(), settings, frame, own);
        return warnings_of(own).size();
    };
    const Scene crossing = leaning_panes({0.3, -0.3}, 0);
    engine->prepare(crossing, context);
    settings.vertex_name = "still.glsl", settings.vertex_text = "void user_vertex(inout Vertex v) {}\n";
    EXPECT_EQ(warnings(), 0u) << "where they stand is not known";
    settings.vertex_name.clear(), settings.vertex_text.clear();
    EXPECT_EQ(warnings(), 1u);
    EXPECT_EQ(warnings(), 1u) << "each picture may have a report of its own";
    engine->prepare(leaning_panes({0.3, -0.3}, 3), context);
    EXPECT_EQ(warnings(), 0u);
}

/// A step of the depth at 1.68 m is 1.68^2 / (1e-4 2^24) = 1.68 / 1000. All of the scene is nearer than 5 m.
TEST_F(OpenGl, WarnsOfANearThatADriverWithoutClipControlCannotHave) {
    const auto warnings = [&](double near) {
        Context own({.threads = 1});
        Camera camera = oblique();
        camera.z_near = near;
        Frame frame;
        engine->render(camera, small(), frame, own);
        return warnings_of(own);
    };
    engine->prepare(two_squares(), context);
    EXPECT_TRUE(warnings(1e-4).empty()) << "reversed depth loses nothing";
    const test::EnvironmentVariable off("RAKELIGHT_GL_CLIP_CONTROL", "off");
    engine = opengl::make_engine();
    engine->prepare(two_squares(), context);
    EXPECT_TRUE(warnings(1e-3).empty());
    const std::vector<std::string> coarse = warnings(1e-4);
    ASSERT_EQ(coarse.size(), 1u);
    EXPECT_NE(coarse[0].find("beyond 1.68 m"), std::string::npos) << coarse[0];
    EXPECT_NE(coarse[0].find("'near'"), std::string::npos) << coarse[0];
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
class NarrowSink final : public Sink {
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
