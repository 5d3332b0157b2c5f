// SPDX-License-Identifier: Apache-2.0
// Lines and points: what they cover, what hides them, and that they stay on the surfaces they belong to.
#include "engines/raster/marks/marks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "engines/raster/draw_tile.h"
#include "unit/raster/geometry/one_tile.h"
#include "unit/raster/marks/marked_scene.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

double sum_of_red(const Frame& f) {
    double sum = 0;
    for (const vec4& c : f.color) sum += double(c.x);
    return sum;
}

Scene one_line(vec3 a, vec3 b) {
    Scene scene;
    add_marks(scene, Topology::lines, {a, b});
    return scene;
}

/// A square turned about x and y, unlit white.
Scene tilted_square() {
    Scene scene;
    add_object(scene, square_mesh(add_unlit(scene, {1, 1, 1, 1})),
               compose({0, 0, 0}, {-0.5, 0.2, 0.05, 0.8}, {1, 1, 1}));
    return scene;
}

/// Squares in every attitude, some through the eye plane, with lines and points of the scene's own.
Scene busy_scene() {
    Scene scene;
    const std::uint32_t materials[] = {add_unlit(scene, {0.9f, 0.5f, 0.2f, 1}),
                                       add_unlit(scene, {0.2f, 0.5f, 0.9f, 1}, AlphaMode::opaque, false)};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> part(-2, 2);
    const auto anywhere = [&] { return vec3{part(random), part(random), part(random)}; };
    for (int n = 0; n < 20; ++n) {
        Mesh mesh = square_mesh(materials[n % 2]);
        mesh.positions = std::vector<vec3>{anywhere(), anywhere(), anywhere(), anywhere()};
        add_object(scene, std::move(mesh), scaling(dvec3{n % 3 ? 1.0 : -1.0, 1, 1}));
    }
    std::vector<vec3> places;
    std::vector<vec4> colors;
    for (int n = 0; n < 40; ++n) places.push_back(anywhere()), colors.push_back({float(n % 3), float(n % 2), 0.5f, 1});
    add_marks(scene, Topology::lines, places, {1, 1, 0, 1}, colors);
    add_marks(scene, Topology::points, places, {0, 1, 1, 1});
    return scene;
}

/// Large points that nearly lie in one place.
Scene crowd(int count, bool has_colors, float spread = 0.01f) {
    Scene scene;
    std::vector<vec3> places;
    std::vector<vec4> colors;
    std::mt19937 random(5);
    std::normal_distribution<float> part(0, spread);
    for (int n = 0; n < count; ++n) {
        places.push_back({part(random), part(random), part(random) - 2});
        colors.push_back({float(n % 7) / 7, float(n % 11) / 11, 1, 1});
    }
    add_marks(scene, Topology::points, places, {1, 1, 1, 1}, has_colors ? std::move(colors) : std::vector<vec4>{});
    return scene;
}

/// Tests of the only tile's pixels against points.
std::uint64_t tests_of(const Scene& scene, float point_size) {
    RenderSettings s = one_tile;
    s.point_size = point_size, s.points = PointShape::disc;
    OneTile t(scene, s);
    t.job.marks = &t.drawn.marks;
    raster::find_visible(t.job, 0, t.scratch);
    raster::draw_marks(t.job, 0, t.scratch);
    return t.scratch.mark_tests;
}

}  // namespace

TEST(Marks, ManyLargePointsInOnePlaceCostThePixelsAndTheirBorders) {
    constexpr std::uint64_t pixels = 64 * 64, count = 5000, border = 2 * 42;  // a disc covers 1257 pixels
    EXPECT_LT(tests_of(crowd(int(count), false), 40), 8 * pixels + border * count);
    EXPECT_LT(tests_of(crowd(int(count), true, 0.1f), 40), 8 * pixels + border * count);
}

/// Colors of the only tile, with the points that hide others found block by block, or with channels, where all count.
TEST(Marks, PointsThatHideOthersBlockByBlockGiveTheSameBits) {
    for (const PointShape shape : {PointShape::disc, PointShape::square})
        for (const float size : {3.0f, 24.0f, 40.0f}) {
            Scene scene = crowd(600, true, 0.05f);
            add_object(scene, square_mesh(add_unlit(scene, {0.9f, 0.5f, 0.2f, 1})),
                       compose({0.4, 0, -2}, {0.3, 0.3, 0, 0.9}, {0.3, 0.3, 0.3}));
            RenderSettings s = one_tile;
            s.points = shape, s.point_size = size;
            const Frame plain = draw(scene, camera_at_origin(), s);
            s.channels = channel_object;
            EXPECT_EQ(plain.color, draw(scene, camera_at_origin(), s).color) << size;
        }
}

TEST(Marks, ALineOfOnePixelAlongPixelCentersCoversThemAndNothingElse) {
    const Frame f = draw(one_line(place(10.5, 20.5), place(50.5, 20.5)), flat_camera(), settings());
    for (int x = 0; x < side; ++x) {
        EXPECT_EQ(pixel(f, x, 20).x, x >= 10 && x <= 50 ? 1.0f : 0.0f) << x;
        EXPECT_EQ(pixel(f, x, 19).x, 0);
        EXPECT_EQ(pixel(f, x, 21).x, 0);
    }
}

TEST(Marks, ALineBetweenTwoRowsIsSharedByThem) {
    const Frame f = draw(one_line(place(10, 21), place(50, 21)), flat_camera(), settings());
    EXPECT_NEAR(pixel(f, 30, 20).x, 0.5f, 1e-4f);
    EXPECT_NEAR(pixel(f, 30, 21).x, 0.5f, 1e-4f);
}

TEST(Marks, WhatALineCoversIsItsWidthTimesItsLengthInEveryDirection) {
    for (const float width : {0.4f, 1.0f, 2.5f, 6.0f})
        for (const double angle : {0.0, 0.3, 0.7854, 1.2, 2.0}) {
            RenderSettings s = settings();
            s.line_width = width;
            const double c = 25 * std::cos(angle), d = 25 * std::sin(angle);
            const double length = 50 + double(width) * 0.785;  // the ends are round
            const Frame f = draw(one_line(place(32.2 - c, 31.7 - d), place(32.2 + c, 31.7 + d)), flat_camera(), s);
            EXPECT_NEAR(sum_of_red(f) / (double(width) * length), 1, 0.06) << width << " at " << angle;
        }
}

TEST(Marks, PointsAreSquaresOrDiscsOfTheirSize) {
    Scene scene;
    add_marks(scene, Topology::points, {place(32, 32)});
    RenderSettings s = settings();
    s.point_size = 8;
    EXPECT_NEAR(sum_of_red(draw(scene, flat_camera(), s)), pi * 16, 0.5);
    s.points = PointShape::square;
    const Frame square = draw(scene, flat_camera(), s);
    EXPECT_EQ(sum_of_red(square), 64);
    EXPECT_EQ(pixel(square, 28, 35).x, 1);
    EXPECT_EQ(pixel(square, 27, 35).x, 0);
}

TEST(Marks, ALineThroughTheEyePlaneIsCutAtTheNearPlaneAndDoesNotWrapRound) {
    const Camera camera = eye();  // at z = 2.2, near plane at z = 2.1
    const vec3 a{0.4f, 0.3f, 0}, behind{-2, -1, 8};
    const float t = 2.1f / 8;
    const vec3 cut = a + (behind - a) * t;
    const Frame f = draw(one_line(a, behind), camera, settings()), g = draw(one_line(a, cut), camera, settings());
    EXPECT_GT(sum_of_red(f), 10);
    for (std::size_t i = 0; i < f.color.size(); ++i) EXPECT_NEAR(f.color[i].x, g.color[i].x, 2e-3f);
    EXPECT_EQ(sum_of_red(draw(one_line({0, 0, 3}, behind), camera, settings())), 0) << "all of it is behind the eye";
    for (const float times : {1e6f, 1e15f, 1e30f}) {
        const Frame h = draw(one_line(a, a + (behind - a) * times), camera, settings());
        for (std::size_t i = 0; i < h.color.size(); ++i) ASSERT_NEAR(h.color[i].x, g.color[i].x, 2e-3f) << times;
    }
}

TEST(Marks, LinesOfAnyLengthShowWhatLiesInThePicture) {
    const auto row = [](vec3 a, vec3 b) {
        const Frame f = draw(one_line(a, b), flat_camera(), settings());
        double sum = 0;
        for (int x = 0; x < side; ++x) sum += double(pixel(f, x, 20).x);
        EXPECT_NEAR(sum, sum_of_red(f), 0.02) << "and nothing elsewhere, but for the round ends";
        return sum;
    };
    const vec3 middle = place(32, 20.5);
    for (const float far : {1e3f, 1e10f, 1e20f, 1e30f, 3e38f}) {
        EXPECT_NEAR(row(middle, {far, middle.y, 0}), 32.5, 0.1) << far;
        EXPECT_NEAR(row({-far, middle.y, 0}, middle), 32.5, 0.1) << far;
        EXPECT_NEAR(row({-far, middle.y, 0}, {far, middle.y, 0}), 64, 0.1) << far;
    }
}

TEST(Marks, EdgesOfASurfaceShowWholeOverIt) {
    const Scene scene = tilted_square();
    for (const float width : {1.0f, 3.0f})
        for (const bool parallel : {false, true}) {
            RenderSettings s = settings();
            s.edges = true;
            s.line_color = {1, 0, 0, 1};
            s.line_width = width;
            const Camera camera = parallel ? flat_camera() : eye();
            const Frame over = draw(scene, camera, s);
            s.surfaces = false;
            const Frame alone = draw(scene, camera, s);
            EXPECT_GT(sum_of_red(alone), 100 * double(width));
            for (std::size_t i = 0; i < over.color.size();
                 ++i)  // red over white or black: what is not green is the line's
                if (alone.color[i].x == 1) {
                    EXPECT_EQ(over.color[i].y, 0) << i % side << ", " << i / side << " width " << width;
                }
        }
}

TEST(Marks, AreHiddenBehindSurfacesAndSeenBeforeThem) {
    Scene scene;
    add_object(scene, square_mesh(add_unlit(scene, {0, 0, 1, 1})));
    add_marks(scene, Topology::lines,
              {place(5, 20.5, -0.01f), place(60, 20.5, -0.01f), place(5, 40.5, 0.01f), place(60, 40.5, 0.01f)},
              {1, 0, 0, 1});
    add_marks(scene, Topology::points, {place(30, 10, -0.01f), place(30, 50, 0.01f)}, {0, 1, 0, 1});
    const Frame f = draw(scene, flat_camera(), settings());
    EXPECT_EQ(pixel(f, 30, 20), (vec4{0, 0, 1, 1}));
    EXPECT_EQ(pixel(f, 30, 40), (vec4{1, 0, 0, 1}));
    EXPECT_EQ(pixel(f, 30, 10), (vec4{0, 0, 1, 1}));
    EXPECT_EQ(pixel(f, 30, 50), (vec4{0, 1, 0, 1}));
}

TEST(Marks, WhereEdgesMeetTheyAreNotDarker) {
    RenderSettings s = settings();
    s.surfaces = false;
    s.edges = true;
    s.line_color = {1, 0, 0, 0.5f};
    const Frame f = draw(tilted_square(), eye(), s);
    float most = 0;
    for (const vec4& c : f.color) most = std::max(most, c.x);
    EXPECT_LE(most, 0.5f);
    EXPECT_GT(most, 0.45f);
}

TEST(Marks, AnEdgeThatTrianglesShareIsLaidOnceAndSoIsAVertex) {
    const std::vector<vec4> colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 1, 1}};
    const dmat4 turned = compose({0, 0, 0}, {-0.5, 0.2, 0.05, 0.8}, {1, 1, 1});
    Scene square, lines, points;
    add_object(square, square_mesh(add_unlit(square, {1, 1, 1, 1})), turned);
    square.meshes[0].colors = std::vector<vec4>(colors);
    const auto add = [&](Scene& scene, Topology topology, std::vector<std::uint32_t> indices) {
        Mesh mesh = square.meshes[0];
        mesh.topology = topology;
        mesh.indices = std::move(indices);
        mesh.material = add_unlit(scene, {1, 1, 1, 1});
        add_object(scene, std::move(mesh), turned);
    };
    add(lines, Topology::lines, {0, 1, 1, 2, 0, 2, 2, 3, 0, 3});
    add(points, Topology::points, {0, 1, 2, 3});
    RenderSettings s = settings();
    s.line_width = 2.3f;
    s.surfaces = false;
    s.edges = true;
    RenderStats of_edges, of_lines;
    const Frame edges = draw(square, eye(), s, 1, &of_edges);
    EXPECT_TRUE(same_bits(edges, draw(lines, eye(), s, 1, &of_lines)));
    EXPECT_EQ(of_edges.pixels_marked, of_lines.pixels_marked);
    s.edges = false;
    s.points = PointShape::disc;
    EXPECT_TRUE(same_bits(draw(square, eye(), s), draw(points, eye(), s)));
}

TEST(Marks, TrianglesThatCullingDropsHaveNoEdges) {
    Scene scene;  // its back is seen
    add_object(scene, square_mesh(add_unlit(scene, {1, 1, 1, 1}, AlphaMode::opaque, false)),
               scaling(dvec3{1, 1, -1}) * scaling(dvec3{-1, 1, 1}));
    RenderSettings s = settings();
    s.edges = true;
    s.surfaces = false;
    EXPECT_EQ(sum_of_red(draw(scene, flat_camera(), s)), 0);
    s.cull = Cull::none;
    EXPECT_GT(sum_of_red(draw(scene, flat_camera(), s)), 60);
    s.cull = Cull::back;
    s.front_face = FrontFace::clockwise;
    EXPECT_GT(sum_of_red(draw(scene, flat_camera(), s)), 60);
    scene.nodes[0].local.matrix = scaling(dvec3{-1, 1, 1});  // mirrored: turned round once more
    s.front_face = FrontFace::counter_clockwise;
    EXPECT_GT(sum_of_red(draw(scene, flat_camera(), s)), 60);
}

TEST(Marks, ColorsOfVerticesRunAlongALineWithPerspective) {
    Scene scene;
    add_marks(scene, Topology::lines, {{-1.5f, 0, 0}, {3, 0, -6}}, {1, 1, 1, 1}, {{0, 0, 0, 1}, {1, 1, 1, 1}});
    Camera camera;
    camera.vertical_fov_rad = radians(60);
    camera.z_near = 0.1;
    camera.z_far = 100;
    camera.to_world = translation(dvec3{0, 0.5 * std::tan(radians(30.0)) * 3.0 / 32.0, 3});
    RenderSettings s = settings();
    s.line_width = 4;
    const Frame f = draw(scene, camera, s);
    for (const int x : {12, 20, 32, 38}) {
        // x / w = ((-1.5 + 4.5 t) / (3 + 6 t)) / tan 30 at the pixel's center
        const double slope = (x + 0.5 - 32) / 32 * std::tan(radians(30.0)), t = (1.5 + 3 * slope) / (4.5 - 6 * slope);
        ASSERT_TRUE(t > 0 && t < 1);
        EXPECT_NEAR(double(pixel(f, x, 32).x), t, 0.02) << x;
    }
}

TEST(Marks, NearerOnesLieOverFartherOnesWhateverTheirOrder) {
    for (const bool near_first : {true, false}) {
        Scene scene;
        const auto add = [&](bool is_near) {
            add_marks(scene, Topology::points, {place(32, 32, is_near ? 0.5f : -0.5f)},
                      is_near ? vec4{1, 0, 0, 1} : vec4{0, 1, 0, 1});
        };
        add(near_first);
        add(!near_first);
        EXPECT_EQ(pixel(draw(scene, flat_camera(), settings()), 32, 32), (vec4{1, 0, 0, 1}));
    }
}

TEST(Marks, OverlappingPointsPartWhereTheirParaboloidsMeet) {
    constexpr vec4 red{1, 0, 0, 1}, green{0, 1, 0, 1};
    for (const PointShape shape : {PointShape::disc, PointShape::square})
        for (const float nearer : {0.0f, 0.15f})
            for (const bool red_first : {true, false}) {
                Scene scene;
                std::vector<vec3> places = {place(26, 32), place(38, 32, nearer)};
                std::vector<vec4> colors = {red, green};
                if (!red_first) std::swap(places[0], places[1]), std::swap(colors[0], colors[1]);
                add_marks(scene, Topology::points, places, {1, 1, 1, 1}, colors);
                RenderSettings s = settings();
                s.points = shape;
                s.point_size = 20;
                s.channels = channel_depth | channel_base_color;
                const Frame f = draw(scene, flat_camera(), s);
                // Equal depths part at the bisector, x = 32. The pixels of a row are 1/32 m apart, so both sink 10/32 m in 10 px, and
                // 10/32 ((x - 26)^2 - (x - 38)^2) / 100 = -nearer.
                const double border = 32 - 40.0 / 3 * double(nearer);
                for (int x = 30; x < 34; ++x) {
                    const vec4 wanted = x + 0.5 < border ? red : green;
                    EXPECT_EQ(pixel(f, x, 31), wanted) << x << ' ' << nearer << ' ' << red_first;
                    const std::size_t at = std::size_t(31 * side + x);
                    EXPECT_EQ(f.base_color[at], wanted.xyz()) << x;
                    EXPECT_NEAR(f.depth[at], wanted.x > 0 ? 5 : 5 - nearer, 1e-5f)
                        << "the point's, not the paraboloid's";
                }
                EXPECT_EQ(pixel(f, 17, 31), red);
                EXPECT_EQ(pixel(f, 46, 31), green);
            }
}

TEST(Marks, ACloudOfColoredPointsShowsTheNearestCenterAndHasTheSameBitsEverywhere) {
    Scene scene;
    std::vector<vec3> places;
    std::vector<vec4> colors;
    for (int n = 0; n < 900; ++n) {
        places.push_back({float(n % 30) * 0.05f - 0.7f, float(n / 30) * 0.05f - 0.6f, float(n % 7) * 1e-5f});
        colors.push_back({float(n), 0, 0, 1});
    }
    add_marks(scene, Topology::points, places, {1, 1, 1, 1}, colors);
    RenderSettings s = settings();
    s.width = 150, s.height = 140;
    s.point_size = 14;
    expect_same_bits_everywhere(scene, s);
    const Frame f = draw(scene, eye(), s);
    int wrong = 0;
    for (int n = 0; n < 900; ++n) {  // its own pixel, in perspective: 140 px show 2 tan(25 deg) of the distance
        const double scale = 70 / std::tan(0.436332312998582) / (2.2 - double(places[std::size_t(n)].z));
        const int x = int(75 + (double(places[std::size_t(n)].x) - 0.1) * scale),
                  y = int(70 - (double(places[std::size_t(n)].y) - 0.2) * scale);
        wrong += f.color[std::size_t(y * 150 + x)].x != float(n);
    }
    EXPECT_EQ(wrong, 0);
}

TEST(Marks, VerticesAreShownInsteadOfSurfacesOrOverThem) {
    Scene scene;
    add_object(scene, square_mesh(add_unlit(scene, {0.25f, 0.5f, 1, 1}), 0.5f));
    RenderSettings s = settings();
    s.points = PointShape::square;
    const Frame over = draw(scene, flat_camera(), s);
    EXPECT_EQ(pixel(over, 16, 16), (vec4{0, 0, 0, 1})) << "black over surfaces";
    EXPECT_EQ(pixel(over, 32, 32), (vec4{0.25f, 0.5f, 1, 1}));
    s.surfaces = false;
    RenderStats stats;
    const Frame alone = draw(scene, flat_camera(), s, 1, &stats);
    EXPECT_EQ(pixel(alone, 16, 16), (vec4{0.25f, 0.5f, 1, 1})) << "the material's own";
    EXPECT_EQ(pixel(alone, 32, 32), s.background);
    EXPECT_EQ(stats.pixels_shaded, 0u);
    EXPECT_EQ(stats.pixels_marked, 4u * 16u);
}

TEST(Marks, GiveTheSameBitsForAnyNumberOfThreadsWindowsAndInstructionSets) {
    const Scene scene = busy_scene();
    RenderSettings s = settings();
    s.width = 150, s.height = 140;
    s.edges = true;
    s.points = PointShape::disc;
    s.line_width = 1.7f;
    expect_same_bits_everywhere(scene, s);
}

TEST(Marks, SizesOutOfRangeAreUsageErrors) {
    for (const float size : {0.0f, -1.0f, 257.0f, std::nanf("")}) {
        RenderSettings s = settings();
        s.line_width = size;
        EXPECT_THROW(draw(Scene{}, flat_camera(), s), Error);
        s = settings();
        s.point_size = size;
        EXPECT_THROW(draw(Scene{}, flat_camera(), s), Error);
    }
}
