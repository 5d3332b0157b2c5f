// SPDX-License-Identifier: Apache-2.0
// Pictures of rays: shadows against closed forms, channels beside those of the soft engine, the same bits for threads and windows.
#include "engines/raytrace/raytrace_engine.h"

#include <gtest/gtest.h>

#include <cmath>

#include <rakelight/world/load.h>

#include "engines/raster/raster_engine.h"
#include "math/linear.h"
#include "support/scene_builder.h"
#include "support/shared.h"

namespace rakelight::raytrace {
namespace {

Frame drawn(Engine& engine, const Scene& scene, const Camera& camera, const RenderSettings& settings, int threads = 0) {
    Context context({.threads = threads});
    engine.prepare(scene, context);
    Frame frame;
    engine.render(camera, settings, frame, context);
    return frame;
}

Frame traced(const Scene& scene, const Camera& camera, const RenderSettings& settings, int threads = 0) {
    return drawn(*make_engine(), scene, camera, settings, threads);
}

/// Lies in y = height, facing up.
dmat4 lying(double height) {
    dmat4 m = translation(dvec3{0, height, 0});
    m[0] = {1, 0, 0, 0}, m[1] = {0, 0, -1, 0}, m[2] = {0, 1, 0, 0};
    return m;
}

Camera from_above() {
    Camera camera;
    camera.to_world = look_at({3, 6, 4}, {0, 0, 0}, {0, 1, 0});
    camera.vertical_fov_rad = radians(50);
    camera.z_near = 0.1, camera.z_far = 100;
    return camera;
}

TEST(Raytrace, TheShadowOfAPointLightIsExact) {
    Scene scene;
    scene.materials = {test::matte()};
    scene.materials[0].classical.specular = {};
    test::add_object(scene, test::square_mesh(0, 4), lying(0));
    test::add_object(scene, test::square_mesh(0, 0.5f), lying(2));
    scene.lights = {{.type = LightType::point, .position = {0, 4, 0}, .ambient = {0, 0, 0}}};
    const RenderSettings settings{
        .width = 200, .height = 150, .channels = channel_position, .shadows = true, .background = {0, 0, 0, 1}};
    const Frame frame = traced(scene, from_above(), settings);
    int lit = 0, dark = 0;
    for (std::size_t i = 0; i < frame.color.size(); ++i) {
        const vec3 p = frame.position[i];
        const float far = std::max(std::fabs(p.x), std::fabs(p.z));
        if (std::fabs(p.y) > 0.01f || frame.color[i] == vec4{0, 0, 0, 1} ? far > 3.9f : false) continue;
        if (std::fabs(p.y) > 0.01f || far == 0 || std::fabs(far - 1) < 1e-4f) continue;
        (far < 1 ? dark : lit) += 1;
        EXPECT_EQ(frame.color[i].x > 0, far > 1) << p.x << " " << p.z;
    }
    EXPECT_GT(dark, 300);
    EXPECT_GT(lit, 3000);
}

Scene knight(Context& context) {
    return load((test::source_dir() / "data/knight/Knight_noNormals.glb").string(), {}, context);
}

TEST(Raytrace, ChannelsAreThoseOfTheSoftEngine) {
    Context context;
    Scene scene = load("builtin:torus:tolerance=0.002", {}, context);
    scene.meshes[0].shape.reset();
    RenderSettings settings{.width = 160, .height = 120, .channels = channels_all};
    Camera camera = from_above();
    const auto soft = raster::make_engine();
    const Frame a = drawn(*soft, scene, camera, settings), b = traced(scene, camera, settings);
    int compared = 0, far = 0;
    // The rasterizer's corners lie on 1/256 of a pixel.
    const auto near = [](auto x, auto y) { return length(x - y) < 3e-3f; };
    for (std::size_t i = 0; i < a.color.size(); ++i) {
        EXPECT_EQ(a.object[i], b.object[i]) << i;
        if (a.triangle[i] != b.triangle[i] || a.object[i] == no_index) continue;  // at edges
        ++compared;
        far += std::fabs(a.depth[i] - b.depth[i]) > 3e-3f || !near(a.normal[i], b.normal[i]) ||
               !near(a.face_normal[i], b.face_normal[i]) || !near(a.position[i], b.position[i]);
        EXPECT_EQ(a.mesh[i], b.mesh[i]);
        EXPECT_EQ(a.material[i], b.material[i]);
        EXPECT_TRUE(near(a.base_color[i], b.base_color[i])) << i;
        EXPECT_TRUE(near(a.diffuse[i], b.diffuse[i]) && near(a.specular[i], b.specular[i])) << i;
        EXPECT_TRUE(near(a.ambient[i], b.ambient[i]) && near(a.emission[i], b.emission[i])) << i;
        EXPECT_NEAR(a.tangent[i].w, b.tangent[i].w, 0);
    }
    EXPECT_GT(compared, 1000);
    EXPECT_LE(far, compared / 200) << "at grazing rays";
    int overdraw = 0;
    for (std::size_t i = 0; i < a.overdraw.size(); ++i) overdraw += a.overdraw[i] != b.overdraw[i];
    EXPECT_LT(overdraw, 100) << "at silhouettes";
}

TEST(Raytrace, TheChannelsOfLightHoldTheColorInShadowsToo) {
    Scene scene;
    scene.materials = {test::matte()};
    test::add_object(scene, test::square_mesh(0, 4), lying(0));
    test::add_object(scene, test::square_mesh(0, 0.5f), lying(2));
    scene.lights = {{.type = LightType::point, .position = {0, 4, 0}, .ambient = {0.25f, 0.25f, 0.25f}}};
    const RenderSettings settings{.width = 60, .height = 40, .channels = channels_lighting, .shadows = true};
    const Frame f = traced(scene, from_above(), settings);
    int dark = 0;
    for (std::size_t i = 0; i < f.color.size(); ++i) {
        if (f.ambient[i] == vec3{}) continue;
        dark += f.diffuse[i] == vec3{};
        const vec3 sum = f.ambient[i] + f.diffuse[i] + f.specular[i] + f.emission[i];
        ASSERT_NEAR(length(sum - f.color[i].xyz()), 0, 1e-5) << i;
    }
    EXPECT_GT(dark, 10);
}

TEST(Raytrace, DataAloneIsThatBesideColors) {
    Context context;
    const Scene scene = load("builtin:torus", {}, context);
    RenderSettings settings{.width = 60, .height = 40, .channels = channel_depth | channel_normal | channel_object};
    const Frame both = traced(scene, from_above(), settings);
    settings.colors = false;
    const Frame alone = traced(scene, from_above(), settings);
    EXPECT_TRUE(both.depth == alone.depth && both.normal == alone.normal && both.object == alone.object);
    for (const vec4& c : alone.color) ASSERT_EQ(c, settings.background);
}

TEST(Raytrace, HasTheSameBitsForAnyThreadsAndWindows) {
    Context context;
    const Scene scene = knight(context);
    RenderSettings settings{.width = 130, .height = 100, .channels = channel_depth | channel_triangle, .shadows = true};
    Camera camera;
    camera.to_world = look_at({1.2, 2, 4.5}, {0, 1.2, 0}, {0, 1, 0});
    camera.z_near = 0.1, camera.z_far = 100;
    const Frame one = traced(scene, camera, settings, 1), many = traced(scene, camera, settings, 5);
    EXPECT_TRUE(one.color == many.color && one.depth == many.depth && one.triangle == many.triangle);
    settings.window = {37, 21, 45, 50};
    const Frame part = traced(scene, camera, settings, 2);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 45; ++x) {
            const auto p = std::size_t(y * 45 + x), q = std::size_t((y + 21) * 130 + x + 37);
            ASSERT_TRUE(part.color[p] == one.color[q] && part.triangle[p] == one.triangle[q]) << x << " " << y;
        }
}

/// Moved, scaled unevenly, sheared and mirrored: by their formulas they are what fine triangles are.
TEST(Raytrace, ShapesAreTheirTrianglesUnderAnyAffineTransform) {
    for (const char* const name : {"sphere", "cylinder", "cone", "torus", "plane"})
        for (const double mirror : {1.0, -1.0}) {
            Context context;
            Scene scene = load(std::string("builtin:") + name + ":tolerance=0.0005", {}, context);
            dmat4 m = translation(dvec3{0.3, -0.2, 0.1});
            m[0] = {1.2 * mirror, 0.3, 0, 0}, m[1] = {0.5, 0.9, -0.2, 0}, m[2] = {0, 0.25, 1.4, 0};
            scene.nodes[0].local.matrix = m;
            const RenderSettings settings{.width = 120,
                                          .height = 90,
                                          .channels = channel_position | channel_normal | channel_object | channel_uv};
            const Frame exact = traced(scene, from_above(), settings);
            scene.meshes[0].shape.reset();
            const Frame fine = traced(scene, from_above(), settings);
            int both = 0, far = 0, others = 0;
            for (std::size_t i = 0; i < exact.object.size(); ++i) {
                others += exact.object[i] != fine.object[i];
                if (exact.object[i] == no_index || fine.object[i] == no_index) continue;
                ++both;
                const vec2 move = exact.uv[i] - fine.uv[i];
                const bool is_near = length(exact.position[i] - fine.position[i]) < 0.02f &&
                                     dot(exact.normal[i], fine.normal[i]) > 0.995f &&
                                     std::fabs(move.x) + std::fabs(move.y) < 0.02f;
                far += !is_near;
            }
            EXPECT_GT(both, 300) << name;
            EXPECT_LE(others, 12) << name << ": at silhouettes";
            EXPECT_LE(far, both / 50) << name << ": at silhouettes, rims and the seam of the texture";
        }
}

TEST(Raytrace, AfterAPrepareThatFailedThereIsNothing) {
    const auto engine = make_engine();
    Context context;
    engine->prepare(load("builtin:sphere", {}, context), context);
    Scene scene = knight(context);
    Context cancelled;
    cancelled.cancel();
    EXPECT_THROW(engine->prepare(scene, cancelled), Error);
    Frame frame;
    const RenderSettings settings{.width = 30, .height = 20, .channels = channel_object};
    engine->render(from_above(), settings, frame, context);
    for (const std::uint32_t object : frame.object) ASSERT_EQ(object, no_index);
}

TEST(Raytrace, AnEmptyPictureIsTheBackground) {
    const RenderSettings settings{
        .width = 40, .height = 30, .channels = channels_all, .background = {0.2f, 0.4f, 0.6f, 0.5f}};
    const Frame frame = traced(Scene{}, from_above(), settings);
    for (const vec4& c : frame.color) ASSERT_EQ(c, settings.background);
}

}  // namespace
}  // namespace rakelight::raytrace
