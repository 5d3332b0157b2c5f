// SPDX-License-Identifier: Apache-2.0
// Lines and points in the data channels.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/raster/marks/marked_scene.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr vec4 red{1, 0, 0, 1};

RenderSettings everything() {
    RenderSettings s = settings();
    s.channels = channels_all;
    return s;
}

std::size_t at_pixel(int x, int y) { return std::size_t(y * side + x); }

/// A white square over all of the picture at z = 0, with texture coordinates and tangents; node, mesh and material 0.
Scene white_square() {
    Scene scene;
    add_object(scene, square_mesh(add_unlit(scene, {1, 1, 1, 1})));
    return scene;
}

}  // namespace

TEST(MarkChannels, HoldALineOfTheSceneWhereItIsSeen) {
    Scene scene = white_square();
    add_marks(scene, Topology::lines,
              {place(5, 20.5, 0.5f), place(60, 20.5, 0.5f), place(5, 40.5, -0.5f), place(60, 40.5, -0.5f)}, red);
    const Frame f = draw(scene, flat_camera(), everything());
    const std::size_t seen = at_pixel(30, 20), hidden = at_pixel(30, 40), beside = at_pixel(30, 22);
    EXPECT_NEAR(f.depth[seen], 4.5f, 1e-5f);
    EXPECT_EQ(f.object[seen], 1u);
    EXPECT_EQ(f.mesh[seen], 1u);
    EXPECT_EQ(f.material[seen], 1u);
    EXPECT_EQ(f.triangle[seen], no_index);
    EXPECT_NEAR(f.position[seen].x, at(30.5), 1e-6f);
    EXPECT_NEAR(f.position[seen].y, -at(20.5), 1e-6f);
    EXPECT_NEAR(f.position[seen].z, 0.5f, 1e-5f);
    EXPECT_EQ(f.normal[seen], (vec3{}));
    EXPECT_EQ(f.face_normal[seen], (vec3{}));
    EXPECT_EQ(f.tangent[seen], (vec4{}));
    EXPECT_EQ(f.uv[seen], (vec2{}));
    EXPECT_EQ(f.barycentric[seen], (vec3{}));
    EXPECT_EQ(f.base_color[seen], (vec3{1, 0, 0}));
    EXPECT_EQ(f.emission[seen], (vec3{1, 0, 0}));
    EXPECT_EQ(f.overdraw[seen], 1u) << "surfaces alone";
    for (const std::size_t p : {hidden, beside}) {
        EXPECT_NEAR(f.depth[p], 5, 1e-5f);
        EXPECT_EQ(f.object[p], 0u);
        EXPECT_NE(f.triangle[p], no_index);
        EXPECT_EQ(f.emission[p], (vec3{1, 1, 1}));
    }
}

TEST(MarkChannels, PlacesAreOnTheLineInPerspective) {
    Scene scene;
    const vec3 a{-1.5f, 0.2f, 0}, b{3, -0.4f, -6};
    add_marks(scene, Topology::lines, {a, b}, red);
    const Frame f = draw(scene, eye(), everything());
    int seen = 0;
    for (std::size_t p = 0; p < f.depth.size(); ++p) {
        if (f.object[p] == no_index) {
            EXPECT_TRUE(std::isinf(f.depth[p]));
            continue;
        }
        ++seen;
        const vec3 at = f.position[p], along = (b - a) / length(b - a);
        EXPECT_LT(length(cross(at - a, along)), 0.02f * f.depth[p]) << "half a pixel is a hundredth of the distance";
        EXPECT_NEAR(f.depth[p], 2.2f - at.z, 1e-4f);
    }
    EXPECT_GT(seen, 30);
}

TEST(MarkChannels, TheNearestOfSeveralIsHeldWhateverTheirOrder) {
    for (const bool near_first : {true, false}) {
        Scene scene;
        const auto add = [&](bool is_near) {
            add_marks(scene, Topology::points, {place(32, 32, is_near ? 0.5f : -0.5f)},
                      is_near ? red : vec4{0, 1, 0, 1});
        };
        add(near_first);
        add(!near_first);
        const Frame f = draw(scene, flat_camera(), everything());
        EXPECT_NEAR(f.depth[at_pixel(32, 32)], 4.5f, 1e-5f);
        EXPECT_EQ(f.object[at_pixel(32, 32)], near_first ? 0u : 1u);
        EXPECT_EQ(f.object[at_pixel(40, 32)], no_index);
    }
}

TEST(MarkChannels, EdgesOverASurfaceAreOfItsObjectAndOfTheirOwnColor) {
    Scene scene = white_square();
    scene.nodes[0].local.matrix = scaling(dvec3{0.5, 0.5, 0.5});
    RenderSettings s = everything();
    s.edges = true;
    s.line_color = {0, 0, 1, 1};
    const Frame f = draw(scene, flat_camera(), s);
    EXPECT_EQ(f.object[at_pixel(40, 16)], 0u);
    EXPECT_EQ(f.triangle[at_pixel(40, 16)], no_index);
    EXPECT_EQ(f.emission[at_pixel(40, 16)], (vec3{0, 0, 1}));
    EXPECT_NEAR(f.depth[at_pixel(40, 16)], 5, 1e-5f);
    EXPECT_NE(f.triangle[at_pixel(40, 20)], no_index);
}

TEST(MarkChannels, ThinLinesAreWhole) {
    Scene scene;
    add_marks(scene, Topology::lines, {place(5, 20.9), place(60, 20.9)}, red);
    RenderSettings s = everything();
    s.line_width = 0.1f;
    const Frame f = draw(scene, flat_camera(), s);
    for (int x = 6; x < 59; ++x) EXPECT_EQ(f.object[at_pixel(x, 20)], 0u) << x;
    EXPECT_EQ(f.object[at_pixel(30, 21)], no_index);
}

TEST(MarkChannels, BlendedOnesAreSeenInTheColorAlone) {
    Scene scene = white_square();
    add_marks(scene, Topology::lines, {place(5, 20.5, 0.5f), place(60, 20.5, 0.5f)}, {1, 0, 0, 0.75f});
    const Frame f = draw(scene, flat_camera(), everything());
    EXPECT_EQ(pixel(f, 30, 20), (vec4{1, 0.25f, 0.25f, 1}));
    EXPECT_NEAR(f.depth[at_pixel(30, 20)], 5, 1e-5f);
    EXPECT_EQ(f.object[at_pixel(30, 20)], 0u);
}

TEST(MarkChannels, ALineBehindGlassIsHeldAsAnOpaqueSurfaceIs) {
    for (const int samples : {1, 4}) {
        Scene scene;
        add_marks(scene, Topology::lines, {place(5, 20.5), place(60, 20.5)}, red);
        add_object(scene, square_mesh(add_unlit(scene, {0, 1, 0, 0.5f}, AlphaMode::blend)),
                   translation(dvec3{0, 0, 1}));
        RenderSettings s = everything();
        s.samples = samples;
        const Frame f = draw(scene, flat_camera(), s);
        EXPECT_NEAR(f.depth[at_pixel(30, 20)], 5, 1e-5f);
        EXPECT_EQ(f.object[at_pixel(30, 20)], 0u);
        EXPECT_EQ(f.object[at_pixel(30, 30)], no_index);
        EXPECT_NEAR(pixel(f, 30, 20).y, 0.5f, 1e-6f);
    }
}

TEST(MarkChannels, ThePictureIsTheSameWithThem) {
    Scene scene = white_square();
    RenderSettings s = settings();
    s.edges = true;
    s.points = PointShape::disc;
    const Frame without = draw(scene, eye(), s);
    s.channels = channels_all;
    EXPECT_TRUE(same_bits(without, draw(scene, eye(), s)));
}
