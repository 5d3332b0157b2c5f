// SPDX-License-Identifier: Apache-2.0
// Lines and points in the engine gl.

#include "engines/raster/raster_engine.h"
#include "support/scene_builder.h"
#include "unit/opengl/opengl_scenes.h"
#include "unit/opengl/opengl_test.h"

namespace rakelight {
namespace {

using test::by_soft, test::drawn, test::oblique, test::rmse, test::small, test::two_squares;
using test::OpenGl;

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

}  // namespace
}  // namespace rakelight
