// SPDX-License-Identifier: Apache-2.0
// Points by rays: closed forms, the soft engine's pictures, and clouds of splats that do not shade themselves.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "mark_pictures.h"
#include "prepare/splat_points.h"

namespace rakelight::raytrace {
namespace {

RenderSettings settings_of(float size) {
    RenderSettings settings{.width = side, .height = side, .background = {0, 0, 0, 1}};
    settings.channels = channel_depth | channel_object | channel_triangle | channel_base_color | channel_overdraw;
    settings.point_size = size;
    return settings;
}

void add_points(Scene& scene, const std::vector<vec3>& places, const std::vector<vec4>& colors, float opacity = 1) {
    add_marks(scene, Topology::points, places, {1, 1, 1, opacity}, colors);
}

/// A bent sheet in many colors.
Scene cloud() {
    Scene scene;
    std::vector<vec3> places;
    std::vector<vec4> colors;
    for (int n = 0; n < 400; ++n) {
        const float x = float(n % 20) / 10 - 1, y = float(n / 20) / 10 - 1;
        places.push_back({x + 0.3f * y * y, y, 0.5f * x * x - 0.4f * y});
        colors.push_back({float(n % 3) / 2, float(n % 5) / 4, float(n % 2), 1});
    }
    add_points(scene, places, colors);
    return scene;
}

TEST(RayPoints, OnePointIsADiscOfItsSizeAndHeldByTheChannels) {
    Scene scene;
    add_points(scene, {place(32, 32, 0.5f)}, {{0.25f, 0.5f, 1, 1}});
    const Frame f = traced(scene, flat(), settings_of(20));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const std::size_t i = std::size_t(y * side + x);
            const double dx = x + 0.5 - 32, dy = y + 0.5 - 32;
            const bool is_in = dx * dx + dy * dy < 100;
            EXPECT_EQ(f.color[i], is_in ? (vec4{0.25f, 0.5f, 1, 1}) : (vec4{0, 0, 0, 1})) << x << ' ' << y;
            EXPECT_EQ(f.object[i], is_in ? 0u : no_index);
            EXPECT_EQ(f.triangle[i], no_index);
            EXPECT_EQ(f.overdraw[i], 0u) << "surfaces alone";
            EXPECT_TRUE(is_in ? std::fabs(f.depth[i] - 4.5f) < 1e-5f : std::isinf(f.depth[i]));
        }
}

TEST(RayPoints, OverlappingPointsPartWhereTheirParaboloidsMeet) {
    constexpr vec4 red{1, 0, 0, 1}, green{0, 1, 0, 1};
    for (const float nearer : {0.0f, 0.15f}) {
        Scene scene;
        add_points(scene, {place(26, 32), place(38, 32, nearer)}, {red, green});
        const Frame f = traced(scene, flat(), settings_of(20));
        const double border = 32 - 40.0 / 3 * double(nearer);  // as tests/unit/raster/marks/marks_test.cpp derives it
        for (int x = 29; x < 35; ++x) {
            const std::size_t i = std::size_t(31 * side + x);
            EXPECT_EQ(f.color[i], x + 0.5 < border ? red : green) << x << ' ' << nearer;
            EXPECT_NEAR(f.depth[i], x + 0.5 < border ? 5 : 5 - nearer, 1e-5f) << "the point's, not the paraboloid's";
        }
    }
}

TEST(RayPoints, ShowWhatTheSoftEngineShows) {
    for (const bool is_parallel : {false, true})
        for (const float size : {4.0f, 13.0f}) {
            Camera camera = oblique();
            if (is_parallel) camera.projection = Projection::orthographic, camera.half_height = 1.2;
            RenderSettings settings = settings_of(size);
            settings.width = 160, settings.height = 120;
            const Frame a = soft(cloud(), camera, settings), b = traced(cloud(), camera, settings);
            std::size_t covered = 0, others = 0;
            for (std::size_t i = 0; i < a.depth.size(); ++i) {
                covered += a.object[i] != no_index;
                others += a.object[i] != b.object[i] || a.base_color[i] != b.base_color[i] ||
                          (a.object[i] != no_index && std::fabs(a.depth[i] - b.depth[i]) > 1e-4f);
            }
            EXPECT_GT(covered, 3000u);
            EXPECT_LE(others, covered / 100) << is_parallel << ' ' << size;
        }
}

TEST(RayPoints, SurfacesHideThemAndBlendedOnesShowWhatIsBehind) {
    Scene scene;
    scene.materials = {test::matte({0, 0, 1})};
    scene.materials[0].model = MaterialModel::unlit;
    test::add_object(scene, test::square_mesh(0, 2));
    add_points(scene, {place(16, 32, 0.5f), place(48, 32, -0.5f), place(32, 16, 0)},
               {{1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 0, 1}});
    add_points(scene, {place(32, 48, 0.5f)}, {{1, 1, 1, 1}}, 0.25f);
    const Frame f = traced(scene, flat(), settings_of(8));
    const auto at = [&](int x, int y) { return f.color[std::size_t(y * side + x)]; };
    EXPECT_EQ(at(16, 32), (vec4{1, 0, 0, 1}));
    EXPECT_EQ(at(48, 32), (vec4{0, 0, 1, 1})) << "it lies behind the square";
    EXPECT_EQ(at(32, 16), (vec4{1, 1, 0, 1})) << "it lies on it";
    EXPECT_NEAR(at(32, 48).x, 0.25f, 1e-6f);
    EXPECT_NEAR(at(32, 48).z, 1, 1e-6f);
    EXPECT_EQ(f.object[std::size_t(48 * side + 32)], 0u) << "channels hold opaque ones";
    EXPECT_EQ(f.overdraw[std::size_t(32 * side + 16)], 1u);
}

TEST(RayPoints, PathsShowThemInTheirOwnColors) {
    Scene scene;
    add_points(scene, {place(32, 32)}, {{0.25f, 0.5f, 1, 1}});
    RenderSettings settings = settings_of(20);
    settings.method = RayMethod::path, settings.channels = 0;
    const Frame f = traced(scene, flat(), settings);
    EXPECT_EQ(f.color[std::size_t(32 * side + 32)], (vec4{0.25f, 0.5f, 1, 1}));
    EXPECT_EQ(f.color[std::size_t(32 * side + 52)], (vec4{0, 0, 0, 1}));
}

TEST(RayPoints, HaveTheSameBitsForAnyThreadsAndInstructionSets) {
    RenderSettings settings = settings_of(9);
    settings.width = 150, settings.height = 110;
    const Frame one = traced(cloud(), oblique(), settings), four = traced(cloud(), oblique(), settings, 4);
    setenv("RAKELIGHT_ISA", "scalar", 1);
    const Frame scalar = traced(cloud(), oblique(), settings);
    unsetenv("RAKELIGHT_ISA");
    for (const Frame* other : {&four, &scalar}) {
        EXPECT_EQ(one.color, other->color);
        EXPECT_EQ(one.depth, other->depth);
    }
}

/// Points over the unit sphere by the golden angle, as splats.
Scene sphere_of_splats(std::size_t n) {
    Scene scene;
    scene.materials = {test::matte({0.5f, 0.5f, 0.5f})};
    scene.materials[0].classical.specular = {};
    Mesh mesh;
    mesh.topology = Topology::points, mesh.material = 0;
    std::vector<vec3> places;
    std::vector<std::uint32_t> indices;
    for (std::size_t i = 0; i < n; ++i) {
        const double z = 1 - (2 * double(i) + 1) / double(n), r = std::sqrt(1 - z * z),
                     a = 2.399963229728653 * double(i);
        places.push_back({float(r * std::cos(a)), float(r * std::sin(a)), float(z)});
        indices.push_back(std::uint32_t(i));
    }
    mesh.positions = places, mesh.normals = places, mesh.indices = indices;
    test::add_object(scene, std::move(mesh));
    scene.lights = {{.type = LightType::directional, .direction = {-1, 0, 0}, .ambient = {0, 0, 0}}};
    Context context({.threads = 1});
    return splat_points(scene, context);
}

TEST(RayPoints, ACloudOfSplatsDoesNotShadeItself) {
    RenderSettings settings{.width = 120, .height = 120, .channels = channel_normal};
    const Scene scene = sphere_of_splats(5000);
    Camera camera = flat();
    camera.half_height = 1.1;
    const Frame bare = traced(scene, camera, settings);
    settings.shadows = true;
    const Frame shadowed = traced(scene, camera, settings);
    int lit = 0, dark = 0;
    for (std::size_t i = 0; i < bare.color.size(); ++i) {
        lit += bare.normal[i].x > 0.05f;
        dark += bare.normal[i].x > 0.05f && bare.color[i] != shadowed.color[i];
    }
    EXPECT_GT(lit, 3000);
    EXPECT_EQ(dark, 0) << "a sphere throws no shadow on the side that faces the light";
}

}  // namespace
}  // namespace rakelight::raytrace
