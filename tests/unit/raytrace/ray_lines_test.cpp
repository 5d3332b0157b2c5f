// SPDX-License-Identifier: Apache-2.0
// Lines by rays, and edges and vertices of triangles: closed forms, and the soft engine's pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "cpu_shading/draw_list.h"
#include "engines/raytrace/scene/ray_marks.h"
#include "mark_pictures.h"

namespace rakelight::raytrace {
namespace {

constexpr std::uint32_t all_channels =
    channel_depth | channel_object | channel_mesh | channel_material | channel_triangle | channel_base_color;

double sum_of_red(const Frame& f) {
    double sum = 0;
    for (const vec4& c : f.color) sum += double(c.x);
    return sum;
}

/// Lines in many directions and colors, some behind the eye.
Scene hedgehog() {
    Scene scene;
    std::vector<vec3> ends;
    std::vector<vec4> colors;
    for (int n = 0; n < 40; ++n) {
        const float a = 2.4f * float(n), z = 1 - 2 * (float(n) + 0.5f) / 40, r = std::sqrt(1 - z * z);
        const vec3 out{r * std::cos(a), r * std::sin(a), z};
        ends.push_back(out * 0.4f), ends.push_back(out * (n % 5 == 0 ? 6.0f : 1.1f));
        colors.push_back({1, float(n % 3) / 2, 0, 1}), colors.push_back({0, float(n % 5) / 4, 1, 1});
    }
    add_lines(scene, ends, colors);
    return scene;
}

Scene cube() {
    Scene scene;
    scene.materials = {test::matte({0.7f, 0.7f, 0.7f})};
    Mesh mesh;
    std::vector<vec3> corners;
    for (int i = 0; i < 8; ++i) corners.push_back({i & 1 ? 0.6f : -0.6f, i & 2 ? 0.6f : -0.6f, i & 4 ? 0.6f : -0.6f});
    mesh.positions = corners;
    mesh.indices = std::vector<std::uint32_t>{0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                              2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    mesh.material = 0;
    test::add_object(scene, std::move(mesh));
    scene.lights = {test::directional({-1, -2, -3})};
    return scene;
}

TEST(RayLines, CoverTheirWidthTimesTheirLength) {
    for (const float width : {0.5f, 1.0f, 3.0f, 8.0f}) {
        Scene scene;
        add_lines(scene, {place(11.3, 15.2, 0.5f), place(52.1, 47.6, -0.5f)});
        const double length = std::hypot(52.1 - 11.3, 47.6 - 15.2);
        const double area = width * length + std::numbers::pi / 4 * width * width;
        EXPECT_NEAR(sum_of_red(traced(scene, flat(), line_settings(width, 8))), area, 0.05 * area) << width;
    }
}

TEST(RayLines, OneIsAStripOfItsWidthHeldByTheChannels) {
    Scene scene;
    add_lines(scene, {place(8, 32, 0.5f), place(56, 32, 0.5f)}, {{1, 0, 0, 1}, {0, 0, 1, 1}});
    RenderSettings settings = line_settings(6);
    settings.channels = all_channels;
    const Frame f = traced(scene, flat(), settings);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const std::size_t i = std::size_t(y * side + x);
            const double px = x + 0.5, dx = px - std::clamp(px, 8.0, 56.0), dy = y + 0.5 - 32;
            const bool is_in = dx * dx + dy * dy < 9;
            const float part = float((std::clamp(px, 8.0, 56.0) - 8) / 48);
            EXPECT_NEAR(f.color[i].x, is_in ? 1 - part : 0, 1e-5f) << x << ' ' << y;
            EXPECT_NEAR(f.color[i].z, is_in ? part : 0, 1e-5f) << x << ' ' << y;
            EXPECT_EQ(f.object[i], is_in ? 0u : no_index);
            EXPECT_EQ(f.triangle[i], no_index);
            EXPECT_TRUE(is_in ? std::fabs(f.depth[i] - 4.5f) < 1e-5f : std::isinf(f.depth[i]));
        }
}

TEST(RayLines, ChannelsHoldWhatTheSoftEnginesDo) {
    for (const bool is_parallel : {false, true})
        for (const float width : {0.4f, 1.0f, 5.0f}) {
            RenderSettings settings = line_settings(width);
            settings.width = 160, settings.height = 120, settings.channels = all_channels;
            const Frame a = soft(hedgehog(), oblique(is_parallel), settings),
                        b = traced(hedgehog(), oblique(is_parallel), settings);
            std::size_t covered = 0, others = 0;
            for (std::size_t i = 0; i < a.depth.size(); ++i) {
                covered += a.object[i] != no_index;
                const vec3 d = a.base_color[i] - b.base_color[i];
                others += a.object[i] != b.object[i] || std::fabs(d.x) + std::fabs(d.y) + std::fabs(d.z) > 0.02f ||
                          (a.object[i] != no_index && std::fabs(a.depth[i] - b.depth[i]) > 0.01f * a.depth[i]);
            }
            EXPECT_GT(covered, 500u);
            EXPECT_LE(others, covered / 33) << is_parallel << ' ' << width;
        }
}

TEST(RayLines, ColorsAreTheSoftEnginesInTheMean) {
    for (const bool is_parallel : {false, true})
        for (const float width : {1.0f, 3.0f}) {
            RenderSettings settings = line_settings(width, 8);
            settings.width = 160, settings.height = 120;
            const Frame a = soft(hedgehog(), oblique(is_parallel), settings),
                        b = traced(hedgehog(), oblique(is_parallel), settings);
            EXPECT_NEAR(sum_of_red(b), sum_of_red(a), 0.04 * sum_of_red(a)) << is_parallel << ' ' << width;
        }
}

TEST(RayLines, SurfacesHideThoseBehindThemAndShowThoseOnThemWhole) {
    for (const double turn_deg : {0.0, 75.0}) {
        Scene scene;
        scene.materials = {test::matte({0, 0, 1})};
        scene.materials[0].model = MaterialModel::unlit;
        const double half = 0.5 * turn_deg * std::numbers::pi / 180;
        const dmat4 turn = compose({}, {std::sin(half), 0, 0, std::cos(half)}, {1, 1, 1});
        test::add_object(scene, test::square_mesh(0, 0.9f), turn);
        const auto on = [&](float x, float y, float away) {
            return cast<float>(transform_point(turn, dvec3{double(x), double(y), double(away)}));
        };
        add_lines(scene, {on(-0.5f, 0, 0), on(0.5f, 0, 0)}, {{1, 0, 0, 1}, {1, 0, 0, 1}});
        add_lines(scene, {{-0.5f, 0.02f, -2}, {0.5f, 0.02f, -2}}, {{0, 1, 0, 1}, {0, 1, 0, 1}});
        for (const bool is_parallel : {true, false}) {
            Camera camera = flat();
            if (!is_parallel) camera.projection = Projection::perspective, camera.vertical_fov_rad = 2 * std::atan(0.2);
            const Frame f = traced(scene, camera, line_settings(6));
            int red = 0, green = 0;
            for (const vec4& c : f.color) red += c.x == 1, green += c.y == 1;
            EXPECT_NEAR(red, 6 * 32 + 28, 8) << turn_deg << ' ' << is_parallel;
            EXPECT_EQ(green, 0) << turn_deg;
        }
    }
}

TEST(RayLines, BlendedOnesShowWhatIsBehind) {
    Scene scene;
    scene.materials = {test::matte({0, 0, 1})};
    scene.materials[0].model = MaterialModel::unlit;
    test::add_object(scene, test::square_mesh(0, 2));
    add_lines(scene, {place(8, 32, 0.5f), place(56, 32, 0.5f)}, {{1, 0, 0, 1}, {1, 0, 0, 1}}, 0.25f);
    RenderSettings settings = line_settings(8);
    settings.channels = channel_object;
    const Frame f = traced(scene, flat(), settings);
    EXPECT_NEAR(f.color[std::size_t(32 * side + 32)].x, 0.25f, 1e-6f);
    EXPECT_NEAR(f.color[std::size_t(32 * side + 32)].z, 0.75f, 1e-6f);
    EXPECT_EQ(f.object[std::size_t(32 * side + 32)], 0u) << "channels hold opaque ones";
}

TEST(RayLines, EdgesAndVerticesOfTrianglesAreTheSoftEngines) {
    for (const bool has_surfaces : {true, false})
        for (const PointShape points : {PointShape::none, PointShape::disc, PointShape::square})
            for (const Cull cull : {Cull::none, Cull::back}) {
                RenderSettings settings = line_settings(2, 8);
                settings.width = 160, settings.height = 120;
                settings.edges = points != PointShape::square;
                settings.points = points, settings.point_size = 7;
                settings.surfaces = has_surfaces, settings.cull = cull;
                settings.line_color = {0, 1, 0, 1};
                const Frame a = soft(cube(), oblique(), settings), b = traced(cube(), oblique(), settings);
                double green_a = 0, green_b = 0;
                for (std::size_t i = 0; i < a.color.size(); ++i) {
                    green_a += double(a.color[i].y - a.color[i].x), green_b += double(b.color[i].y - b.color[i].x);
                }
                EXPECT_GT(green_a, 100);
                EXPECT_NEAR(green_b, green_a, 0.05 * green_a) << has_surfaces << int(points) << int(cull);
            }
}

TEST(RayLines, MirrorsShowThem) {
    Scene scene;
    Material mirror = test::matte({0, 0, 0});
    mirror.classical.mirror = Mirror::constant, mirror.classical.specular = {1, 1, 1};
    scene.materials = {mirror};
    test::add_object(scene, test::square_mesh(0, 3));
    add_lines(scene, {{-0.5f, 0, 8}, {0.5f, 0, 8}}, {{1, 0, 0, 1}, {1, 0, 0, 1}});  // behind the eye
    Camera camera = flat();
    camera.projection = Projection::perspective, camera.vertical_fov_rad = 2 * std::atan(0.2);
    RenderSettings settings = line_settings(12);  // as wide as 3 m from the eye, seen from 13 m: 2.8 pixels
    settings.max_depth = 2;
    int red = 0;
    for (const vec4& c : traced(scene, camera, settings).color) red += c.x > 0.5f;
    EXPECT_GE(red, 12 * 2);
    EXPECT_LE(red, 16 * 4);
}

TEST(RayLines, PathsShowThemInTheirOwnColors) {
    Scene scene;
    add_lines(scene, {place(8, 32), place(56, 32)}, {{0.25f, 0.5f, 1, 1}, {0.25f, 0.5f, 1, 1}});
    RenderSettings settings = line_settings(20);
    settings.method = RayMethod::path;
    const Frame f = traced(scene, flat(), settings);
    EXPECT_EQ(f.color[std::size_t(32 * side + 32)], (vec4{0.25f, 0.5f, 1, 1}));
    EXPECT_EQ(f.color[std::size_t(52 * side + 32)], (vec4{0, 0, 0, 1}));
}

TEST(RayLines, NumbersThatAreNotFiniteAreNoLines) {
    Scene scene;
    const float huge = 1e30f;
    add_lines(scene, {{huge, huge, huge}, {-huge, 0, 0}, place(8, 32), place(56, 32), {0, 0, 0}, {0, 0, 0}});
    RenderSettings settings = line_settings(4);
    settings.channels = channel_object;
    const Frame f = traced(scene, flat(), settings);
    EXPECT_EQ(f.object[std::size_t(32 * side + 20)], 0u);
    EXPECT_EQ(f.object[std::size_t(10 * side + 20)], no_index);
}

/// Triangles that share no vertex: an edge is a number of 8 bytes while they are looked for, then two ends of 4 bytes.
TEST(RayLines, EdgesPayForWhatTheyTake) {
    constexpr std::uint32_t corners = 3 * 5000;
    Scene scene;
    Mesh mesh;
    std::vector<vec3> places;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < corners; ++i)
        places.push_back({float(i / 3), float(i % 3 == 1), float(i % 3 == 2)}), indices.push_back(i);
    mesh.positions = places, mesh.indices = indices;
    test::add_object(scene, std::move(mesh));
    RenderSettings settings = line_settings(1);
    settings.edges = true, settings.cull = Cull::none;
    Context context;
    shading::TextureCache textures;
    const cpu_shading::DrawList list = cpu_shading::make_draw_list(scene, textures, context);
    const shading::PictureCamera view = shading::picture_camera_of(list, flat(), settings);
    Context enough({.max_memory = corners * 16}), little({.max_memory = corners * 16 - 1});
    const std::vector<MarkedDraw> marks = marked_draws(list, view, settings, enough);
    ASSERT_EQ(marks.size(), 1u);
    EXPECT_EQ(marks[0].count(), corners);
    EXPECT_EQ(marks[0].charge.bytes(), corners * 8);
    EXPECT_THROW(marked_draws(list, view, settings, little), Error);
}

TEST(RayLines, HaveTheSameBitsForAnyThreadsAndInstructionSets) {
    RenderSettings settings = line_settings(3, 4);
    settings.width = 150, settings.height = 110, settings.channels = channel_depth;
    const Frame one = traced(hedgehog(), oblique(), settings), four = traced(hedgehog(), oblique(), settings, 4);
    setenv("RAKELIGHT_ISA", "scalar", 1);
    const Frame scalar = traced(hedgehog(), oblique(), settings);
    unsetenv("RAKELIGHT_ISA");
    for (const Frame* other : {&four, &scalar}) {
        EXPECT_EQ(one.color, other->color);
        EXPECT_EQ(one.depth, other->depth);
    }
}

}  // namespace
}  // namespace rakelight::raytrace
