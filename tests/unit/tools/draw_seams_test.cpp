// SPDX-License-Identifier: Apache-2.0
#include <rakelight/tools/inspect.h>

#include <gtest/gtest.h>

#include <cmath>

#include "unit/render/test_scene.h"

namespace rakelight {
namespace {

/// The two squares seen from the front, large enough for a legend.
Frame marked(const Scene& scene, SeamMarks marks, int width = 320, int height = 200) {
    Context context;
    const InspectOptions options{.seam_lines = true};
    // Upside down: the seam's lower end, where the ring is, is on top.
    const ViewRequest view{.position = dvec3{0, 0.5, 2},
                           .focal_point = dvec3{0, 0.5, 0},
                           .up = dvec3{0, -1, 0},
                           .vertical_fov_rad = radians(40),
                           .orthographic = true};
    const RenderSettings settings{.width = width, .height = height};
    return draw_seams(scene, inspect(scene, options, context), options, view, settings, context, marks);
}

/// Pixels that differ, above the legend or in all of the picture.
int differing(const Frame& a, const Frame& b, int rows) {
    int count = 0;
    for (std::size_t p = 0; p < std::size_t(rows * a.width); ++p) count += !(a.color[p] == b.color[p]);
    return count;
}

/// The two squares seen from the front, 101 x 51 pixels, 50 pixels a meter.
Frame seams_of(const Scene& scene, ViewRequest view = {.side = "front", .orthographic = true}) {
    Context context;
    const InspectOptions options{.seam_lines = true};
    RenderSettings settings{.width = 101, .height = 51};
    return draw_seams(scene, inspect(scene, options, context), options, view, settings, context);
}

vec3 pixel(const Frame& f, int x, int y) { return f.color[std::size_t(y * f.width + x)].xyz(); }
bool is_gray(vec3 c) { return std::fabs(c.x - c.y) < 1e-6f && std::fabs(c.y - c.z) < 1e-6f; }
float lightness(vec3 c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

Scene with_seam(vec3 normal) {
    Scene scene = test::two_squares();
    scene.meshes[1].normals = std::vector<vec3>(4, normal);
    return scene;
}

TEST(DrawSeams, TheSeamIsALineOfItsColorAndTheRestIsGray) {
    const Frame f = seams_of(with_seam({0.6f, 0, 0.8f}));
    const vec3 expected = heat_color(36.8699), on = pixel(f, 50, 25);
    EXPECT_NEAR(on.x, expected.x, 1e-4);
    EXPECT_NEAR(on.y, expected.y, 1e-4);
    EXPECT_NEAR(on.z, expected.z, 1e-4);
    EXPECT_TRUE(is_gray(pixel(f, 40, 25)));
    EXPECT_TRUE(is_gray(pixel(f, 60, 25)));
    int colored = 0;
    for (int x = 0; x < f.width; ++x) colored += !is_gray(pixel(f, x, 25)) && pixel(f, x, 25) != pixel(f, 0, 0);
    EXPECT_GE(colored, 3);
    EXPECT_LE(colored, 6);
}

TEST(DrawSeams, TheLineLiesOnTheSeamWherePixelsAreNotSquare) {
    // From 1 m away a field of view of 90 degrees across: the seam, half a meter left of the axis, is a quarter of the
    // width from the edge.
    for (const bool parallel : {false, true}) {
        const ViewRequest view{.position = dvec3{0.5, 0.5, 1},
                               .focal_point = dvec3{0.5, 0.5, 0},
                               .vertical_fov_rad = radians(30),
                               .horizontal_fov_rad = radians(90),
                               .orthographic = parallel};
        const Frame f = seams_of(with_seam({0.6f, 0, 0.8f}), view);
        EXPECT_FALSE(is_gray(pixel(f, 25, 25)));
        EXPECT_TRUE(is_gray(pixel(f, 35, 25)));
        EXPECT_TRUE(is_gray(pixel(f, 15, 25)));
    }
}

TEST(DrawSeams, AModelWithoutSeamsStaysGray) {
    const Frame f = seams_of(test::two_squares());
    for (int x = 20; x < 80; ++x) EXPECT_TRUE(is_gray(pixel(f, x, 25)));
}

TEST(DrawSeams, ASeamBehindAFaceIsNotSeen) {
    Scene scene = with_seam({0.6f, 0, 0.8f});
    scene.meshes.push_back(test::square(-0.5f));
    scene.meshes[2].normals = std::vector<vec3>(4, vec3{0, 0, 1});
    scene.nodes.emplace_back().meshes = {2};
    scene.nodes[2].local.translation = {0, 0, 0.5};
    EXPECT_TRUE(is_gray(pixel(seams_of(scene), 50, 25)));
    scene.nodes[2].local.translation = {0, 0, -0.5};
    EXPECT_FALSE(is_gray(pixel(seams_of(scene), 50, 25)));
}

TEST(DrawSeams, TheLegendHasARingThatIsBrokenWhereTheSeamIsHidden) {
    constexpr int above_legend = 150;
    Scene scene = with_seam({0.6f, 0, 0.8f});
    const auto ring = [&] {
        return differing(marked(scene, SeamMarks::none), marked(scene, SeamMarks::legend), above_legend);
    };
    const int whole = ring();
    EXPECT_GT(whole, 100);
    scene.meshes.push_back(test::square(-0.5f));
    scene.meshes[2].normals = std::vector<vec3>(4, vec3{0, 0, 1});
    scene.nodes.emplace_back().meshes = {2};
    scene.nodes[2].local.translation = {0, -0.5, 0.5};
    EXPECT_LT(ring(), whole);
    EXPECT_GT(ring(), 50);
}

TEST(DrawSeams, TheLegendWithoutASeamHasNoRing) {
    const Scene scene = test::two_squares();
    const Frame without = marked(scene, SeamMarks::none), with = marked(scene, SeamMarks::legend);
    EXPECT_EQ(differing(without, with, 150), 0);
    EXPECT_GT(differing(without, with, with.height), 500);
}

TEST(DrawSeams, SmallPicturesHaveNoLegend) {
    const Scene scene = with_seam({0.6f, 0, 0.8f});
    EXPECT_EQ(marked(scene, SeamMarks::legend, 239, 200).color, marked(scene, SeamMarks::none, 239, 200).color);
}

TEST(DrawSeams, PerspectiveAndACameraInTheMiddleOfASeamAreNoTrouble) {
    const Scene scene = with_seam({0.6f, 0, 0.8f});
    EXPECT_FALSE(is_gray(pixel(seams_of(scene, {.side = "front"}), 50, 25)));
    const Frame inside =
        seams_of(scene, {.position = dvec3{0, 0.5, 0.05}, .focal_point = dvec3{0, 1, 0}, .up = dvec3{0, 0, 1}});
    for (const vec4 c : inside.color) EXPECT_TRUE(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z));
}

TEST(DrawSeams, LinesOfImpossibleCoordinatesAreLeftOut) {
    const Scene scene = with_seam({0.6f, 0, 0.8f});
    Context context;
    const InspectOptions options{.seam_lines = true};
    const RenderSettings settings{.width = 101, .height = 51};
    const ViewRequest view{.side = "front", .orthographic = true};
    Inspection inspection = inspect(scene, options, context);
    const Frame without = draw_seams(scene, inspection, options, view, settings, context);
    for (const double far : {1.7e308, 1e200, double(INFINITY), double(NAN)})
        for (const dvec3 end : {dvec3{far, 0.5, 0}, dvec3{-far, 0.5, far}, dvec3{far, far, -far}})
            inspection.seam_lines.push_back(
                SeamLine{.a = {-end.x, -end.y, -end.z}, .b = {end.x, end.z, 1.0}, .deg_a = 30, .deg_b = 30});
    const Frame with = draw_seams(scene, inspection, options, view, settings, context);
    for (const vec4 c : with.color) EXPECT_TRUE(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z));
    EXPECT_EQ(pixel(with, 50, 25), pixel(without, 50, 25));
}

TEST(DrawSeams, AWindowIsAPartOfTheWholePicture) {
    const Scene scene = with_seam({0.6f, 0, 0.8f});
    const Frame whole = seams_of(scene);
    Context context;
    const InspectOptions options{.seam_lines = true};
    const RenderSettings settings{.width = 101, .height = 51, .window = {45, 10, 12, 8}};
    const Frame part = draw_seams(scene, inspect(scene, options, context), options,
                                  {.side = "front", .orthographic = true}, settings, context);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 12; ++x)
            EXPECT_EQ(part.color[std::size_t(y * 12 + x)].xyz(), pixel(whole, 45 + x, 10 + y)) << x << " " << y;
}

TEST(DrawSeams, ColorsGrowLighterWithTheAngle) {
    EXPECT_EQ(heat_color(0), heat_color(continuous_deg));
    EXPECT_EQ(heat_color(60), heat_color(180));
    for (double deg = continuous_deg; deg < 59; deg *= 1.3)
        EXPECT_LT(lightness(heat_color(deg)), lightness(heat_color(deg * 1.3))) << deg;
}

TEST(DrawSeams, NothingToDrawIsAnError) { EXPECT_THROW(seams_of(Scene{}), Error); }

}  // namespace
}  // namespace rakelight
