// SPDX-License-Identifier: Apache-2.0
// Lines and points that one sees through, by rays: on surfaces, between them, in glass and mirrors, and where their pieces overlap.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engines/raytrace/scene/ray_marks.h"
#include "mark_pictures.h"

namespace rakelight::raytrace {
namespace {

constexpr vec4 white{1, 1, 1, 0.5f}, opaque_red{1, 0, 0, 1};
constexpr vec3 red{1, 0, 0}, red_and_white{1, 0.5f, 0.5f};

bool is_near(vec3 a, vec3 b, float tolerance = 1e-5f) {
    return std::max({std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)}) <= tolerance;
}

vec3 at(const Frame& f, int x, int y) { return f.color[std::size_t(y * side + x)].xyz(); }

/// Pixels of one color, each either this or that.
struct Counts {
    int these = 0, those = 0, others = 0;
};
Counts counts_of(const Frame& f, vec3 these, vec3 those) {
    Counts out;
    for (const vec4& c : f.color) {
        const bool is_this = is_near(c.xyz(), these), is_that = is_near(c.xyz(), those);
        out.these += is_this, out.those += is_that, out.others += !is_this && !is_that;
    }
    return out;
}

dmat4 turned(double angle_deg, dvec3 place = {}) {
    const double half = 0.5 * angle_deg * std::numbers::pi / 180;
    return compose(place, {std::sin(half), 0, 0, std::cos(half)}, {1, 1, 1});
}

std::vector<vec3> moved(const dmat4& by, std::vector<vec3> places) {
    for (vec3& p : places) p = cast<float>(transform_point(by, cast<double>(p)));
    return places;
}

/// 5 m before z = 0, where the picture is 2 m high.
Camera straight() {
    Camera camera = flat();
    camera.projection = Projection::perspective, camera.vertical_fov_rad = 2 * std::atan(0.2), camera.z_far = 100;
    return camera;
}

/// A red square that fills the picture, turned about x, with a line along x or two points on it.
Scene red_square(double angle_deg, Topology topology) {
    Scene scene;
    const dmat4 turn = turned(angle_deg);
    test::add_object(scene, test::square_mesh(add_unlit(scene, opaque_red), 30), turn);
    add_marks(scene, topology, moved(turn, {{-0.5f, 0, 0}, {0.5f, 0, 0}}), white);
    return scene;
}

TEST(BlendedMarks, OnASurfaceTheyAreMixedWithIt) {
    for (const Topology topology : {Topology::lines, Topology::points})
        for (const double angle_deg : {0.0, 30.0, 75.0})
            for (const Camera& camera : {flat(), straight()}) {
                RenderSettings settings = line_settings(6);
                settings.point_size = 16, settings.points = PointShape::none;
                const Scene scene = red_square(angle_deg, topology);
                const Counts c = counts_of(traced(scene, camera, settings), red, red_and_white);
                const double area =
                    topology == Topology::lines ? 6 * 32 + std::numbers::pi * 9 : 2 * std::numbers::pi * 64;
                EXPECT_EQ(c.others, 0) << angle_deg;
                EXPECT_NEAR(c.those, area, 0.06 * area) << angle_deg;
            }
}

TEST(BlendedMarks, ThinnerThanAPixelTheyAreToo) {
    Scene scene;
    test::add_object(scene, test::square_mesh(add_unlit(scene, opaque_red), 2));
    add_lines(scene, {place(8, 32.5), place(56, 32.5)});
    const Frame f = traced(scene, flat(), line_settings(0.5f));
    EXPECT_TRUE(is_near(at(f, 32, 32), red_and_white));
    EXPECT_TRUE(is_near(at(f, 32, 35), red));
}

TEST(BlendedMarks, PathsMixThemToo) {
    RenderSettings settings = line_settings(60, 64);
    settings.method = RayMethod::path;
    settings.window = {28, 28, 8, 8};
    const Frame f = traced(red_square(30, Topology::lines), straight(), settings);
    vec3 mean{};
    for (const vec4& c : f.color) mean = mean + c.xyz() * (1.0f / 64);
    EXPECT_TRUE(is_near(mean, red_and_white, 0.032f)) << mean.y << ": 4 standard errors of 4096 tosses";
}

TEST(BlendedMarks, JointsAndCrossingsAreAsTheRest) {
    Scene scene;
    test::add_object(scene, test::square_mesh(add_unlit(scene, opaque_red), 2));
    // a polyline that turns back over itself, at several depths
    const std::vector<vec3> corners{place(10, 10, 0.1f), place(50, 12, 0.2f), place(54, 50, 0.3f), place(12, 20, 0),
                                    place(40, 8, 0.5f)};
    std::vector<vec3> ends;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) ends.push_back(corners[i]), ends.push_back(corners[i + 1]);
    add_marks(scene, Topology::lines, ends, white);
    const Frame f = traced(scene, flat(), line_settings(7)), of_soft = soft(scene, flat(), line_settings(7));
    const Counts c = counts_of(f, red, red_and_white);
    EXPECT_EQ(c.others, 0);
    EXPECT_GT(c.those, 600);
    int filled = 0;
    for (std::size_t i = 0; i < f.color.size(); ++i) {
        if (!is_near(of_soft.color[i].xyz(), red_and_white)) continue;
        ++filled;
        EXPECT_TRUE(is_near(f.color[i].xyz(), red_and_white)) << i;
    }
    EXPECT_GT(filled, 500);
}

/// Colors change along the lines, blue does not. At the joint each engine may show either piece: half a width of 43 pixels apart.
TEST(BlendedMarks, JointsOfSeveralColorsAreAsTheRest) {
    Scene scene;
    const std::vector<vec3> ends{place(8, 50, 0.3f), place(30, 12, -0.2f), place(30, 12, -0.2f), place(56, 50, 0.4f)};
    add_marks(scene, Topology::lines, ends, white, {{1, 0, 1, 1}, {0, 1, 1, 1}, {0, 1, 1, 1}, {1, 0, 1, 1}});
    const Frame f = traced(scene, flat(), line_settings(9)), of_soft = soft(scene, flat(), line_settings(9));
    int covered = 0, filled = 0;
    for (std::size_t i = 0; i < f.color.size(); ++i) {
        const float blue = f.color[i].z, blue_of_soft = of_soft.color[i].z;
        EXPECT_TRUE(blue == 0 || std::fabs(blue - 0.5f) < 1e-6f) << i << ' ' << blue;
        EXPECT_LE(blue_of_soft, 0.5f + 1e-6f) << i;
        covered += blue > 0, filled += blue_of_soft > 0.4999f;
        const bool is_filled = blue_of_soft > 0.4999f;
        EXPECT_TRUE(!is_filled || is_near(f.color[i].xyz(), of_soft.color[i].xyz(), 0.06f)) << i;
    }
    EXPECT_GT(covered, 700);
    EXPECT_GT(filled, 600);
}

/// The paraboloid of a point on the pane reaches behind one that is there.
TEST(BlendedMarks, PointsCloseBehindAPaneAreStillThere) {
    Scene scene;
    test::add_object(scene, test::square_mesh(add_unlit(scene, {0, 0, 1, 0.5f}), 3));
    add_marks(scene, Topology::points, {place(26, 32)}, {1, 0, 0, 0.5f});
    add_marks(scene, Topology::points, {place(34, 32, -0.01f)}, {0, 1, 0, 0.5f});
    RenderSettings settings = line_settings(1);
    settings.points = PointShape::none, settings.point_size = 20;
    EXPECT_TRUE(is_near(at(traced(scene, flat(), settings), 33, 32), {0.5f, 0.125f, 0.25f}));
}

TEST(BlendedMarks, PathsDarkenNoJoints) {
    Scene scene;
    add_marks(scene, Topology::lines,
              {place(8, 32), place(32, 32), place(32, 32), place(56, 32), place(32, 32), place(32, 8)}, white);
    RenderSettings settings = line_settings(40, 64);
    settings.method = RayMethod::path;
    settings.window = {28, 28, 8, 8};
    float mean = 0;
    for (const vec4& c : traced(scene, flat(), settings).color) mean += c.x / 64;
    EXPECT_NEAR(mean, 0.5f, 0.032f);
}

TEST(BlendedMarks, EdgesAndVerticesOfAMeshAreOneRun) {
    Scene scene;
    test::add_object(scene, test::square_mesh(add_unlit(scene, opaque_red), 0.5f));
    RenderSettings settings = line_settings(6);
    settings.edges = true, settings.points = PointShape::disc, settings.point_size = 14;
    settings.line_color = white;
    const Frame f = traced(scene, flat(), settings);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const vec3 c = at(f, x, y);
            const bool is_on_square = std::max(std::fabs(x + 0.5 - 32), std::fabs(y + 0.5 - 32)) < 16;
            if (is_on_square)
                EXPECT_TRUE(is_near(c, red) || is_near(c, red_and_white)) << x << ' ' << y;
            else
                EXPECT_TRUE(is_near(c, {}) || is_near(c, {0.5f, 0.5f, 0.5f})) << x << ' ' << y;
        }
    EXPECT_TRUE(is_near(at(f, 32, 32), red_and_white)) << "the diagonal";
    EXPECT_TRUE(is_near(at(f, 17, 47), red_and_white)) << "a corner";
}

TEST(BlendedMarks, OfOthersInTheSamePlaceTheLaterLiesOver) {
    Scene scene;
    add_marks(scene, Topology::lines, {place(8, 32), place(56, 32)}, {1, 0, 0, 0.5f});
    add_marks(scene, Topology::lines, {place(32, 8), place(32, 56)}, {0, 0, 1, 0.5f});
    for (const Frame& f : {traced(scene, flat(), line_settings(8)), soft(scene, flat(), line_settings(8))}) {
        EXPECT_TRUE(is_near(at(f, 32, 32), {0.25f, 0, 0.5f})) << at(f, 32, 32).x << ' ' << at(f, 32, 32).z;
        EXPECT_TRUE(is_near(at(f, 12, 32), {0.5f, 0, 0}));
        EXPECT_TRUE(is_near(at(f, 32, 12), {0, 0, 0.5f}));
    }
}

TEST(BlendedMarks, PointsBehindOnesOfAnotherColorAreStillThere) {
    Scene scene;  // near each other, so that the paraboloids cross
    add_marks(scene, Topology::points, {place(30, 32)}, {1, 0, 0, 0.5f});
    add_marks(scene, Topology::points, {place(34, 32, 0.01f)}, {0, 0, 1, 0.5f});
    RenderSettings settings = line_settings(1);
    settings.points = PointShape::none, settings.point_size = 20;
    const Frame f = traced(scene, flat(), settings);
    for (int y = 28; y < 36; ++y)
        for (int x = 28; x < 36; ++x) {
            const vec3 c = at(f, x, y);
            EXPECT_TRUE(is_near(c, {0.5f, 0, 0.25f}) || is_near(c, {0.25f, 0, 0.5f})) << x << ' ' << y;
        }
}

/// Two lines of one color before, on or behind a pane of half opacity, a red wall behind all.
TEST(BlendedMarks, PanesTintWhatIsBehindThem) {
    constexpr vec3 blue{0, 0, 1};
    const auto over = [](vec3 front, vec3 behind) { return front * 0.5f + behind * 0.5f; };
    const vec3 line{1, 1, 1}, pane = over(blue, red);
    for (const Camera& camera : {flat(), straight()})
        for (const int where : {1, 2, 3}) {  // a bit each: before, behind
            Scene scene;
            test::add_object(scene, test::square_mesh(add_unlit(scene, {0, 0, 1, 0.5f}), 3));
            test::add_object(scene, test::square_mesh(add_unlit(scene, opaque_red), 9), translation(dvec3{0, 0, -3}));
            std::vector<vec3> ends;
            if (where & 1) ends.push_back({-0.7f, 0, 0.5f}), ends.push_back({0.7f, 0, 0.5f});
            if (where & 2) ends.push_back({-0.7f, 0, -0.5f}), ends.push_back({0.7f, 0, -0.5f});
            add_marks(scene, Topology::lines, ends, white);
            const vec3 right = where == 1   ? over(line, pane)
                               : where == 2 ? over(blue, over(line, red))
                                            : over(line, over(blue, over(line, red)));
            for (const Frame& f : {traced(scene, camera, line_settings(6)), soft(scene, camera, line_settings(6))}) {
                EXPECT_TRUE(is_near(at(f, 32, 32), right)) << where;
                EXPECT_TRUE(is_near(at(f, 32, 10), pane)) << where;
            }
        }
}

/// What lies on a slanted pane reaches behind a frontal one close to it. There the line of half opacity, 0.05 m behind both, is
/// seen once, through both: 1/2 * 4/5 * 4/5. The panes are black.
TEST(BlendedMarks, BehindTwoPanesTheyAreSeenOnceThroughBoth) {
    for (const Camera& camera : {flat(), straight()}) {
        Scene scene;
        const std::uint32_t glass = add_unlit(scene, {0, 0, 0, 0.2f});
        test::add_object(scene, test::square_mesh(glass, 30), turned(80, {0, 0, 0.1}));
        test::add_object(scene, test::square_mesh(glass, 30));
        add_marks(scene, Topology::lines, {{-0.7f, 0, -0.05f}, {0.7f, 0, -0.05f}}, white);
        for (const Frame& f : {traced(scene, camera, line_settings(6)), soft(scene, camera, line_settings(6))})
            for (const int y : {31, 32})
                EXPECT_TRUE(is_near(at(f, 32, y), {0.32f, 0.32f, 0.32f})) << y << ' ' << at(f, 32, y).x;
    }
}

TEST(BlendedMarks, OnAPaneTheyLieOverIt) {
    for (const double angle_deg : {0.0, 60.0}) {
        Scene scene;
        const dmat4 turn = turned(angle_deg);
        test::add_object(scene, test::square_mesh(add_unlit(scene, {0, 0, 1, 0.5f}), 30), turn);
        add_marks(scene, Topology::lines, moved(turn, {{-0.5f, 0, 0}, {0.5f, 0, 0}}), white);
        const Counts c = counts_of(traced(scene, straight(), line_settings(8)), {0, 0, 0.5f}, {0.5f, 0.5f, 0.75f});
        EXPECT_EQ(c.others, 0) << angle_deg;
        EXPECT_NEAR(c.those, 8 * 32 + 50, 16) << angle_deg;
    }
}

Material mirror() {
    Material m = test::matte({0, 0, 0});
    m.classical.mirror = Mirror::constant, m.classical.specular = {1, 1, 1};
    return m;
}

/// Through which one sees what is behind, neither bent nor mirrored.
Material clear_glass() {
    Material m;
    m.model = MaterialModel::metallic_roughness;
    m.metallic_roughness.metallic = 0, m.metallic_roughness.roughness = 0;
    m.metallic_roughness.transmission = 1, m.metallic_roughness.ior = 1;
    m.double_sided = true;
    return m;
}

/// Where rays go on in another direction, what lies on the surface is not met twice.
TEST(BlendedMarks, OnMirrorsAndGlassTheyAreMixedWithWhatIsSeenThere) {
    for (const bool is_mirror : {true, false})
        for (const double angle_deg : {0.0, 25.0, 60.0}) {
            Scene bare;
            bare.lights = {{.type = LightType::ambient, .ambient = {0, 0, 0}}};
            const dmat4 turn = turned(angle_deg);
            bare.materials = {is_mirror ? mirror() : clear_glass()};
            test::add_object(bare, test::square_mesh(0, 30), turn);
            Scene marked = bare;
            add_marks(marked, Topology::lines, moved(turn, {{-0.5f, 0, 0}, {0.5f, 0, 0}}), white);
            RenderSettings settings = line_settings(10);
            settings.background = {0, 0.25f, 0.5f, 1}, settings.max_depth = 3;
            const Frame a = traced(bare, straight(), settings), b = traced(marked, straight(), settings);
            int mixed = 0, others = 0;
            for (std::size_t i = 0; i < a.color.size(); ++i) {
                const vec3 without = a.color[i].xyz(), with = b.color[i].xyz();
                const bool is_mixed = is_near(with, without * 0.5f + vec3{0.5f, 0.5f, 0.5f}, 1e-4f);
                mixed += is_mixed, others += !is_mixed && !is_near(with, without, 1e-4f);
            }
            EXPECT_NEAR(mixed, 10 * 32 + 78, 20) << is_mirror << ' ' << angle_deg;
            EXPECT_EQ(others, 0) << is_mirror << ' ' << angle_deg;
        }
}

TEST(BlendedMarks, BehindGlassTheyAreSeenOnce) {
    for (const float z : {-0.02f, -1.0f}) {
        Scene scene;
        scene.lights = {{.type = LightType::ambient, .ambient = {0, 0, 0}}};
        scene.materials = {clear_glass()};
        test::add_object(scene, test::square_mesh(0, 30));
        test::add_object(scene, test::square_mesh(add_unlit(scene, opaque_red), 30), translation(dvec3{0, 0, -2}));
        add_marks(scene, Topology::lines, {{-0.5f, 0, z}, {0.5f, 0, z}}, white);
        const Frame f = traced(scene, straight(), line_settings(10));
        EXPECT_TRUE(is_near(at(f, 32, 32), red_and_white, 1e-3f)) << z << ' ' << at(f, 32, 32).y;
        EXPECT_TRUE(is_near(at(f, 32, 10), red, 1e-3f)) << z;
    }
}

/// A line before a mirror is met on the way there and on the way back.
TEST(BlendedMarks, BeforeAMirrorTheyAreSeenTwice) {
    Scene scene;
    scene.lights = {{.type = LightType::ambient, .ambient = {0, 0, 0}}};
    scene.materials = {mirror()};
    test::add_object(scene, test::square_mesh(0, 3));
    add_marks(scene, Topology::lines, {{-0.5f, 0, 1}, {0.5f, 0, 1}}, white);
    RenderSettings settings = line_settings(10);
    settings.max_depth = 2;
    EXPECT_TRUE(is_near(at(traced(scene, straight(), settings), 32, 32), {0.75f, 0.75f, 0.75f}));
}

/// A wall 3 m behind the eye, turned about x, with a line of 2 m: seen in a mirror, 13 m away, where 64 pixels are 5.2 m. Its ends
/// are sqrt(10) m from the eye, so that it is as wide as 26 pixels there.
TEST(BlendedMarks, OnSurfacesThatMirrorsShowTheyAreAsWideAsBeforeThem) {
    for (const double angle_deg : {0.0, 45.0, 60.0}) {
        Scene scene;
        scene.lights = {{.type = LightType::ambient, .ambient = {0, 0, 0}}};
        scene.materials = {mirror()};
        test::add_object(scene, test::square_mesh(0, 3));
        const dmat4 turn = turned(angle_deg, {0, 0, 8});
        test::add_object(scene, test::square_mesh(add_unlit(scene, opaque_red), 30), turn);
        add_marks(scene, Topology::lines, moved(turn, {{-1, 0, 0}, {1, 0, 0}}), white);
        RenderSettings settings = line_settings(26);
        settings.max_depth = 2;
        const Counts c = counts_of(traced(scene, straight(), settings), red, red_and_white);
        const double width = 26 * std::sqrt(10.0) / 13,
                     area = width * 64 * 2 / 5.2 + std::numbers::pi / 4 * width * width;
        EXPECT_EQ(c.others, 0) << angle_deg;
        EXPECT_NEAR(c.those, area, 0.08 * area) << angle_deg;
    }
}

TEST(BlendedMarks, BitsDoNotDependOnThreads) {
    Scene scene = red_square(60, Topology::lines);
    add_marks(scene, Topology::points, {{0.2f, 0.1f, 0.3f}, {-0.2f, 0.1f, 0.3f}}, {0, 1, 0, 0.25f});
    EXPECT_EQ(traced(scene, straight(), line_settings(5, 4)).color,
              traced(scene, straight(), line_settings(5, 4), 4).color);
}

}  // namespace
}  // namespace rakelight::raytrace
