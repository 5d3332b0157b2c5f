// SPDX-License-Identifier: Apache-2.0
// Lines and points behind, between and before blended surfaces.
#include "engines/raster/marks/mark_layers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "unit/raster/marks/marked_scene.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr vec4 red{1, 0, 0, 1}, green_glass{0, 1, 0, 0.5f}, blue_glass{0, 0, 1, 0.25f};

/// A pane over all of the picture, parallel to it.
void add_pane(Scene& scene, vec4 color, double z) {
    add_object(scene, square_mesh(add_unlit(scene, color, AlphaMode::blend), 2), translation(dvec3{0, 0, z}));
}

void add_line(Scene& scene, double row, float z, vec4 color = red) {
    add_marks(scene, Topology::lines, {place(5, row, z), place(60, row, z)}, color);
}

/// On an opaque ground.
vec4 over(vec4 c, vec4 under) {
    const vec3 sum = c.xyz() * c.w + under.xyz() * (1 - c.w);
    return {sum.x, sum.y, sum.z, 1};
}

void expect_near(vec4 a, vec4 b) {
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(a[c], b[c], 1e-6f) << c;
}

/// Squares in every attitude, some glass, some through the eye plane, with lines and points of the scene's own.
Scene glass_scene() {
    Scene scene;
    const std::uint32_t materials[] = {add_unlit(scene, {0.9f, 0.5f, 0.2f, 1}),
                                       add_unlit(scene, green_glass, AlphaMode::blend),
                                       add_unlit(scene, blue_glass, AlphaMode::blend)};
    std::mt19937 random(8);
    std::uniform_real_distribution<float> part(-1, 1);
    const auto anywhere = [&] { return vec3{part(random), part(random), part(random)}; };
    for (int n = 0; n < 15; ++n) {
        Mesh mesh = square_mesh(materials[n % 3]);
        mesh.positions = std::vector<vec3>{anywhere(), anywhere(), anywhere(), anywhere()};
        add_object(scene, std::move(mesh));
    }
    std::vector<vec3> places;
    for (int n = 0; n < 40; ++n) places.push_back(anywhere());
    add_marks(scene, Topology::lines, places, {1, 1, 0, 1});
    add_marks(scene, Topology::points, places, {0, 1, 1, 1});
    return scene;
}

}  // namespace

TEST(MarkLayers, GlassTintsTheLinesBehindItAndLiesUnderThoseBeforeIt) {
    for (const int samples : {1, 4}) {
        Scene scene;
        add_line(scene, 10.5, -0.5f);
        add_line(scene, 20.5, 0.25f);
        add_line(scene, 30.5, 0.75f);
        add_pane(scene, blue_glass, 0.5);
        add_pane(scene, green_glass, 0);
        RenderSettings s = settings();
        s.samples = samples;
        const Frame f = draw(scene, flat_camera(), s);
        expect_near(pixel(f, 30, 10), over(blue_glass, over(green_glass, red)));
        expect_near(pixel(f, 30, 20), over(blue_glass, red));
        expect_near(pixel(f, 30, 30), red);
        expect_near(pixel(f, 30, 40), over(blue_glass, over(green_glass, s.background)));
    }
}

TEST(MarkLayers, HalfOfAPixelThatALineCoversShowsWhatIsBehindItThroughTheSameGlass) {
    Scene scene;
    add_marks(scene, Topology::lines, {place(5, 20, -0.5f), place(60, 20, -0.5f)}, red);  // between two rows
    add_pane(scene, green_glass, 0);
    const RenderSettings s = settings();
    expect_near(pixel(draw(scene, flat_camera(), s), 30, 20), over(green_glass, over({1, 0, 0, 0.5f}, s.background)));
}

TEST(MarkLayers, TheEdgesOfGlassLieOnIt) {
    Scene scene;
    add_object(scene, square_mesh(add_unlit(scene, green_glass, AlphaMode::blend)),
               compose({0, 0, 0}, {-0.5, 0.2, 0.05, 0.8}, {1, 1, 1}));
    RenderSettings s = settings();
    s.edges = true;
    s.line_color = red;
    s.line_width = 3;
    for (const bool parallel : {false, true})
        for (const int samples : {1, 4}) {
            const Camera camera = parallel ? flat_camera() : eye();
            s.samples = samples;
            s.surfaces = true;
            const Frame over_glass = draw(scene, camera, s);
            s.surfaces = false;
            const Frame alone = draw(scene, camera, s);
            int whole = 0;
            for (std::size_t i = 0; i < alone.color.size(); ++i) {
                if (alone.color[i].x < 1) continue;
                ++whole;
                EXPECT_EQ(over_glass.color[i], red) << i % side << ", " << i / side;
            }
            EXPECT_GT(whole, 20);
        }
}

TEST(MarkLayers, PassThroughAPaneWhereTheyPierceIt) {
    Scene scene;
    add_marks(scene, Topology::lines, {place(5, 20.5, -0.5f), place(59, 20.5, 0.5f)}, red);
    add_pane(scene, green_glass, 0);
    const Frame f = draw(scene, flat_camera(), settings());
    expect_near(pixel(f, 28, 20), over(green_glass, red));
    expect_near(pixel(f, 36, 20), red);
}

TEST(MarkLayers, NearerOnesOfOtherColorsLieOverFartherOnesWithinAGap) {
    Scene scene;
    add_line(scene, 20.5, 0.3f, {0, 0, 1, 1});
    add_line(scene, 20.5, 0.1f, red);
    add_line(scene, 20.5, -0.2f, {1, 1, 1, 1});
    add_line(scene, 30.5, -0.1f, {1, 1, 1, 1});
    add_line(scene, 30.5, -0.2f, red);
    add_pane(scene, green_glass, 0);
    const Frame f = draw(scene, flat_camera(), settings());
    expect_near(pixel(f, 30, 20), {0, 0, 1, 1});
    expect_near(pixel(f, 30, 30), over(green_glass, {1, 1, 1, 1}));
}

TEST(MarkLayers, GiveTheSameBitsForAnyNumberOfThreadsWindowsAndInstructionSets) {
    const Scene scene = glass_scene();
    RenderSettings s = settings();
    s.width = 150, s.height = 140;
    s.edges = true;
    s.line_width = 1.7f;
    for (const int samples : {1, 4}) {
        s.samples = samples;
        expect_same_bits_everywhere(scene, s);
    }
}

TEST(MarkLayers, WhatWaitsForGlassCountsAsMemoryOfThePicture) {
    Scene scene;
    std::vector<vec3> places;
    for (int n = 0; n < 20000; ++n) places.push_back(place(10, 10, -0.5f));
    add_marks(scene, Topology::points, places);
    RenderSettings s = settings();
    s.point_size = 16;  // 20000 points on 200 pixels, of which each waits
    const auto draw_within = [&](const Scene& of) {
        Context context({.threads = 1, .max_memory = std::uint64_t(200) << 20});
        auto engine = raster::make_engine();
        engine->prepare(of, context);
        Frame frame;
        engine->render(flat_camera(), s, frame, context);
    };
    EXPECT_NO_THROW(draw_within(scene)) << "nothing waits without glass";
    add_pane(scene, green_glass, 0);
    EXPECT_THROW(draw_within(scene), Error);
}
