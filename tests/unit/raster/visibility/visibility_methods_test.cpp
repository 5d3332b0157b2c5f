// SPDX-License-Identifier: Apache-2.0
// Visibility methods where their answers are known: what each gets right, and the failure that each is known for.
#include "engines/raster/visibility/visibility_methods.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engines/raster/inspect/inspection.h"
#include "unit/raster/drawn.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr vec4 red{1, 0, 0, 1}, green{0, 1, 0, 1}, blue{0, 0, 1, 1};
constexpr Visibility all_methods[] = {Visibility::z_reversed, Visibility::z_float,  Visibility::z16,
                                      Visibility::z24,        Visibility::z32,      Visibility::painter,
                                      Visibility::none,       Visibility::back_face};
constexpr Visibility depth_methods[] = {Visibility::z_reversed, Visibility::z_float, Visibility::z16, Visibility::z24,
                                        Visibility::z32};
constexpr Visibility other_depths[] = {Visibility::z_float, Visibility::z16, Visibility::z24, Visibility::z32};

RenderSettings settings_of(Visibility method, std::uint32_t channels = 0) {
    RenderSettings s{.width = 64, .height = 64, .channels = channels, .background = {0, 0, 0, 0}};
    s.visibility = method;
    return s;
}

void add_polygon(Scene& scene, std::uint32_t material, std::vector<vec3> corners) {
    Mesh mesh;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t k = 2; k < corners.size(); ++k) indices.insert(indices.end(), {0, k - 1, k});
    mesh.normals = std::vector<vec3>(corners.size(), vec3{0, 0, 1});
    mesh.positions = std::move(corners);
    mesh.indices = indices;
    mesh.material = material;
    add_object(scene, std::move(mesh));
}

/// A square across the view, at this distance before a camera at the origin.
void add_screen(Scene& scene, vec4 color, double distance, float half = 10, AlphaMode mode = AlphaMode::opaque) {
    const float z = float(-distance);
    add_polygon(scene, add_unlit(scene, color, mode),
                {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
}

Camera camera_at_origin(double near = 0.1, double far = 1000) {
    Camera camera;
    camera.vertical_fov_rad = radians(60);
    camera.z_near = near;
    camera.z_far = far;
    return camera;
}

/// Three long triangles about the origin: each lies over the next where they cross.
Scene cyclic_scene() {
    Scene scene;
    const vec4 colors[] = {red, green, blue};
    for (int k = 0; k < 3; ++k) {
        const double a = 2 * pi * k / 3;
        const auto at = [&](double along, double across, float z) {
            const double x = along, y = -0.5 - across;
            return vec3{float(x * std::cos(a) - y * std::sin(a)), float(x * std::sin(a) + y * std::cos(a)), z};
        };
        add_polygon(scene, add_unlit(scene, colors[k]),
                    {at(-1.4, -0.42, 0.6f), at(1.4, 0, -0.6f), at(-1.4, 0.42, 0.6f)});
    }
    return scene;
}

/// Which of the three is seen where the far end of `one` meets the near end of the next.
vec4 at_crossing(const Frame& f, int one) {
    const double a = 2 * pi * one / 3, x = std::sqrt(3.0) / 2, y = -0.5;  // on the axes of both
    const double px = x * std::cos(a) - y * std::sin(a), py = x * std::sin(a) + y * std::cos(a);
    return pixel(f, int(32 + px * 16), int(32 - py * 16));  // half_height 2 on 64 pixels
}

Camera flat_camera_of(double half_height) {
    Camera camera = flat_camera();
    camera.half_height = half_height;
    return camera;
}

/// A cube of side 1 about a point, each face of a color of its own, outside counter-clockwise.
void add_cube(Scene& scene, dvec3 middle) {
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            const std::uint32_t material =
                add_unlit(scene, {float(axis) / 2, float(side), float(scene.nodes.size() % 3) / 2, 1});
            scene.materials[material].double_sided = false;
            const float s = side ? 0.5f : -0.5f;
            std::vector<vec3> corners;
            for (const auto& [u, v] : {std::pair{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}}) {
                vec3 p;
                p[std::size_t(axis)] = s;
                p[std::size_t((axis + 1) % 3)] = side ? u : v;
                p[std::size_t((axis + 2) % 3)] = side ? v : u;
                corners.push_back(p);
            }
            add_polygon(scene, material, corners);
            scene.nodes.back().local.matrix = translation(middle);
        }
}

Camera oblique_camera() {
    Camera camera;
    camera.vertical_fov_rad = radians(40);
    camera.z_near = 0.1;
    camera.z_far = 100;
    camera.to_world = look_at({2.5, 2, 4}, {0, 0, 0}, {0, 1, 0});
    return camera;
}

}  // namespace

TEST(VisibilityMethods, OfThreeTrianglesThatOverlapInACircleEveryDepthFormatIsRightAndPaintersAlgorithmCannotBe) {
    const Scene scene = cyclic_scene();
    const vec4 colors[] = {red, green, blue};
    for (const Visibility method : depth_methods) {
        const Frame f = draw(scene, flat_camera_of(2), settings_of(method));
        for (int one = 0; one < 3; ++one) EXPECT_EQ(at_crossing(f, one), colors[(one + 1) % 3]) << int(method);
    }
    // The three have equal depths, so they are painted in the order of the scene.
    const Frame painted = draw(scene, flat_camera_of(2), settings_of(Visibility::painter));
    EXPECT_EQ(at_crossing(painted, 0), green);
    EXPECT_EQ(at_crossing(painted, 1), blue);
    EXPECT_EQ(at_crossing(painted, 2), blue);  // red is nearer here
}

TEST(VisibilityMethods, TrianglesThatPassThroughEachOtherAreSplitByDepthAndNotByPaintersAlgorithm) {
    Scene scene;
    add_polygon(scene, add_unlit(scene, red), {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
    add_polygon(scene, add_unlit(scene, blue), {{-1, -1, -0.5f}, {1, -1, 0.5f}, {1, 1, 0.5f}, {-1, 1, -0.5f}});
    for (const Visibility method : depth_methods) {
        const Frame f = draw(scene, flat_camera(), settings_of(method));
        for (int y = 0; y < 64; ++y) {
            EXPECT_EQ(pixel(f, 29, y), red) << int(method);
            EXPECT_EQ(pixel(f, 34, y), blue) << int(method);
        }
    }
    // Of the blue square the lower right half is nearer by its mean, the upper left half farther.
    const Frame painted = draw(scene, flat_camera(), settings_of(Visibility::painter));
    EXPECT_EQ(pixel(painted, 20, 62), blue);  // red is nearer
    EXPECT_EQ(pixel(painted, 43, 1), red);    // blue is nearer
}

TEST(VisibilityMethods, PaintersAlgorithmIsRightWhereDepthsDoNotOverlapWhateverTheOrderOfTheScene) {
    Scene scene;
    add_screen(scene, green, 4, 1);
    add_screen(scene, red, 9, 20);
    add_screen(scene, blue, 6, 2);
    const Frame expected = draw(scene, camera_at_origin(), settings_of(Visibility::z_reversed));
    EXPECT_EQ(pixel(expected, 32, 32), green);
    EXPECT_TRUE(same_bits(expected, draw(scene, camera_at_origin(), settings_of(Visibility::painter))));
    EXPECT_EQ(pixel(draw(scene, camera_at_origin(), settings_of(Visibility::none)), 32, 32), blue);
}

TEST(VisibilityMethods, PaintersAlgorithmSortsByTheMeanOfTheCornersAlsoWhereATriangleIsClipped) {
    Scene scene;  // a floor from behind the eye to 30 m, a wall at 4 m that stands on it
    const std::uint32_t ground = add_unlit(scene, green);
    add_polygon(scene, ground, {{-20, -1, 10}, {20, -1, 10}, {0, -1, -30}});
    add_screen(scene, red, 4, 0.9f);
    EXPECT_EQ(pixel(draw(scene, camera_at_origin(), settings_of(Visibility::z_reversed)), 32, 36), red);
    EXPECT_EQ(pixel(draw(scene, camera_at_origin(), settings_of(Visibility::painter)), 32, 36), green)
        << "mean of the floor: (-10 - 10 + 30) / 3 = 3.3 m before the eye; of the part before it, more than 10 m";
}

TEST(VisibilityMethods, WithoutRemovalTheLastOfTheSceneIsSeen) {
    Scene scene;
    add_screen(scene, red, 2);
    add_screen(scene, blue, 5);
    for (const Visibility method : {Visibility::none, Visibility::back_face})
        EXPECT_EQ(pixel(draw(scene, camera_at_origin(), settings_of(method)), 32, 32), blue);
}

TEST(VisibilityMethods, CullingBackFacesIsEnoughForOneConvexBodyAndNotForTwo) {
    Scene one;
    add_cube(one, {0, 0, 0});
    const Frame expected = draw(one, oblique_camera(), settings_of(Visibility::z_reversed));
    EXPECT_TRUE(same_bits(expected, draw(one, oblique_camera(), settings_of(Visibility::back_face))));
    Scene two = one;
    add_cube(two, {-0.8, -0.8, -1.5});  // behind the first, later in the scene
    EXPECT_FALSE(same_bits(draw(two, oblique_camera(), settings_of(Visibility::z_reversed)),
                           draw(two, oblique_camera(), settings_of(Visibility::back_face))));
}

TEST(VisibilityMethods, BackFaceLeavesOutBackFacesOfTwoSidedMaterialsUnlessCullSaysOtherwise) {
    Scene scene;
    add_polygon(scene, add_unlit(scene, red), {{-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0}});  // its back is seen
    RenderSettings s = settings_of(Visibility::back_face);
    EXPECT_EQ(pixel(draw(scene, flat_camera(), s), 32, 32), s.background);
    s.cull = Cull::none;
    EXPECT_EQ(pixel(draw(scene, flat_camera(), s), 32, 32), red);
}

TEST(VisibilityMethods, SurfacesATenthOfAStepApartAreOneToTheFormatAndSurfacesTwoStepsApartAreTwo) {
    const raster::DepthRange range{0.1, 1000, false};
    for (const Visibility method : {Visibility::z16, Visibility::z24, Visibility::z_float}) {
        const double distance = 40, step = raster::depth_step(method, distance, range);
        Scene close, apart;
        add_screen(close, red, distance, 60);
        add_screen(close, blue, distance - 0.1 * step, 60);
        add_screen(apart, red, distance, 60);
        add_screen(apart, blue, distance - 2 * step, 60);
        const Camera camera = camera_at_origin();
        EXPECT_EQ(pixel(draw(close, camera, settings_of(method)), 32, 32), red)
            << "the first of the scene; " << int(method);
        EXPECT_EQ(pixel(draw(apart, camera, settings_of(method)), 32, 32), blue) << int(method);
        EXPECT_EQ(pixel(draw(close, camera, settings_of(Visibility::z_reversed)), 32, 32), blue) << int(method);
    }
}

TEST(VisibilityMethods, AllDepthFormatsGiveOnePictureWhereSurfacesAreFarApart) {
    Scene scene;
    const vec4 colors[] = {red, green, blue, {1, 1, 0, 1}};
    for (int i = 0; i < 4; ++i) {
        const float t = float(i) * 0.4f, z = -3 - float(i);
        add_polygon(scene, add_unlit(scene, colors[i]),
                    {{-2 + t, -2, z}, {1, -1 + t, z - 0.4f}, {0.5f * t, 2, z + 0.3f}});
    }
    const Frame expected = draw(scene, camera_at_origin(1, 100), settings_of(Visibility::z_reversed, channel_depth));
    for (const Visibility method : other_depths) {
        const Frame f = draw(scene, camera_at_origin(1, 100), settings_of(method, channel_depth));
        EXPECT_TRUE(same_bits(expected, f)) << int(method);
        EXPECT_EQ(expected.depth, f.depth) << int(method);
    }
    Camera parallel = flat_camera_of(3);
    for (const Visibility method : other_depths)
        EXPECT_TRUE(same_bits(draw(scene, parallel, settings_of(Visibility::z_reversed)),
                              draw(scene, parallel, settings_of(method))));
}

TEST(VisibilityMethods, TheDepthChannelIsThatOfWhatIsShown) {
    Scene scene;
    add_screen(scene, red, 2);
    add_screen(scene, blue, 5);
    EXPECT_NEAR(draw(scene, camera_at_origin(), settings_of(Visibility::none, channel_depth)).depth[0], 5, 1e-4);
    EXPECT_NEAR(draw(scene, camera_at_origin(), settings_of(Visibility::z16, channel_depth)).depth[0], 2, 1e-4);
}

TEST(VisibilityMethods, BlendedSurfacesLieBeforeWhatIsSeenAndAreHiddenByIt) {
    Scene scene;  // pane, wall, pane: the order of the scene is not that of depth
    add_screen(scene, {0, 1, 0, 0.5f}, 3, 60, AlphaMode::blend);
    add_screen(scene, red, 5, 60);
    add_screen(scene, {0, 0, 1, 0.5f}, 7, 60, AlphaMode::blend);
    const vec4 seen_through{0.5f, 0.5f, 0, 1};
    for (const Visibility method : depth_methods)
        EXPECT_EQ(pixel(draw(scene, camera_at_origin(), settings_of(method)), 32, 32), seen_through) << int(method);
    EXPECT_EQ(pixel(draw(scene, camera_at_origin(), settings_of(Visibility::painter)), 32, 32), seen_through);
    const vec4 last_drawn{0.5f, 0, 0.5f, 1};  // the wall is painted over the first pane, the second pane over the wall
    EXPECT_EQ(pixel(draw(scene, camera_at_origin(), settings_of(Visibility::none)), 32, 32), last_drawn);
}

TEST(VisibilityMethods, MaskedSurfacesLetThroughWhatIsBehindThem) {
    Scene scene;
    add_screen(scene, red, 5, 60);
    const std::uint32_t masked = add_unlit(scene, blue, AlphaMode::mask);
    const auto half_clear = [](int x, int) { return std::array<int, 3>{x < 8 ? 0 : 255, 0, 0}; };
    Sampler nearest{Wrap::clamp_to_edge, Wrap::clamp_to_edge, Filter::nearest, Filter::nearest, MipFilter::none};
    scene.materials[masked].opacity_texture = add_texture(scene, picture(rgb_pixels(16, 16, half_clear)), nearest);
    add_object(scene, square_mesh(masked, 2), translation(dvec3{0, 0, -3}));
    for (const Visibility method : all_methods) {
        const Frame f = draw(scene, camera_at_origin(), settings_of(method));
        EXPECT_EQ(pixel(f, 20, 32), red) << int(method);
        EXPECT_EQ(pixel(f, 44, 32), blue) << int(method);
    }
}

TEST(VisibilityMethods, GiveTheSameBitsForAnyNumberOfThreadsAndInEveryWindow) {
    Scene scene = cyclic_scene();
    add_cube(scene, {0.3, 0.1, 0});
    add_screen(scene, {0, 1, 1, 0.5f}, -0.2, 1, AlphaMode::blend);
    for (const Visibility method : all_methods) {
        RenderSettings s = settings_of(method);
        s.width = s.height = 150;
        const Frame whole = draw(scene, oblique_camera(), s, 1);
        EXPECT_TRUE(same_bits(whole, draw(scene, oblique_camera(), s, 4)));
        s.window = {37, 41, 70, 51};
        const Frame part = draw(scene, oblique_camera(), s, 2);
        for (int y = 0; y < 51; ++y)
            for (int x = 0; x < 70; ++x) ASSERT_EQ(pixel(part, x, y), pixel(whole, x + 37, y + 41)) << int(method);
    }
}

TEST(VisibilityMethods, ExplainedPixelsAreThoseOfThePictureInEveryMethod) {
    Scene scene = cyclic_scene();
    add_cube(scene, {0.3, 0.1, 0});
    add_screen(scene, {0, 1, 1, 0.5f}, -0.2, 1, AlphaMode::blend);
    Context context({.threads = 1});
    for (const Visibility method : all_methods) {
        const RenderSettings s = settings_of(method);
        const Frame f = draw(scene, oblique_camera(), s);
        const raster::Inspection inspection(scene, oblique_camera(), s, context);
        for (int y = 3; y < 64; y += 6)
            for (int x = 2; x < 64; x += 5) {
                const raster::PixelExplanation e = inspection.explain(x, y, context);
                ASSERT_EQ(e.sum, pixel(f, x, y)) << int(method) << " at " << x << ", " << y;
            }
    }
}
