// SPDX-License-Identifier: Apache-2.0
// Reflection and refraction against closed forms: mirrored planes, Snell, total reflection, Fresnel, Beer-Lambert.
#include <gtest/gtest.h>

#include <cmath>

#include <rakelight/world/load.h>

#include "engines/raytrace/raytrace_engine.h"
#include "math/linear.h"
#include "path_test_support.h"
#include "support/scene_builder.h"

namespace rakelight::raytrace {
namespace {

Material glowing(vec3 color) {
    Material m;
    m.model = MaterialModel::unlit;
    m.base_color = {color.x, color.y, color.z, 1};
    m.double_sided = true;
    return m;
}

/// Glass without color.
Material glass(float ior, float thickness = 1) {
    Material m;
    m.metallic_roughness = {.metallic = 0, .roughness = 0, .ior = ior, .transmission = 1, .thickness = thickness};
    m.double_sided = true;
    return m;
}

Material mirror(float reflectance = 1) {
    Material m;
    m.model = MaterialModel::classical;
    m.base_color = {0, 0, 0, 1};
    m.classical.ambient = {0, 0, 0};
    m.classical.specular = {reflectance, reflectance, reflectance};
    m.classical.mirror = Mirror::constant;
    m.double_sided = true;
    return m;
}

/// One pixel whose ray goes along a direction; the background is what a place shows.
struct Eye {
    dvec3 from, to;
    vec3 background{1, 1, 1};
};

/// No light but what glows: the scene has a black one, lest it get the default lights.
vec3 seen(Scene scene, const Eye& eye, RenderSettings settings = {}) {
    scene.lights = {{.type = LightType::ambient, .ambient = {0, 0, 0}}};
    Camera camera;
    camera.to_world =
        look_at(eye.from, eye.to, std::fabs(eye.to.y - eye.from.y) > 1e-3 ? dvec3{0, 0, 1} : dvec3{0, 1, 0});
    camera.vertical_fov_rad = 1e-4;
    camera.z_near = 1e-4, camera.z_far = 1e4;
    settings.width = settings.height = 1;
    settings.background = {eye.background.x, eye.background.y, eye.background.z, 1};
    Context context({.threads = 1});
    const auto engine = make_engine();
    engine->prepare(std::move(scene), context);
    Frame frame;
    engine->render(camera, settings, frame, context);
    return frame.color[0].xyz();
}

double fresnel(double cosine, double eta) {
    const double sine = eta * std::sqrt(1 - cosine * cosine);
    if (sine >= 1) return 1;
    const double behind = std::sqrt(1 - sine * sine);
    const double s = (eta * cosine - behind) / (eta * cosine + behind),
                 p = (eta * behind - cosine) / (eta * behind + cosine);
    return 0.5 * (s * s + p * p);
}

/// A block -size..size in x and z, y from -thickness to 0, its faces outward.
void add_slab(Scene& scene, std::uint32_t material, double size, double thickness) {
    dmat4 m = scaling(dvec3{size, thickness / 2, size});
    m[3] = {0, -thickness / 2, 0, 1};
    test::add_object(scene, box_mesh(material), m);
}

TEST(Whitted, AMirrorShowsWhatStandsInFrontOfIt) {
    Scene scene;
    scene.materials = {mirror(0.75f), glowing({0.5f, 0.25f, 1})};
    test::add_object(scene, test::square_mesh(0, 5));                                  // in z = 0
    test::add_object(scene, test::square_mesh(1, 0.5f), translation(dvec3{4, 0, 3}));  // parallel to it
    for (const double x : {1.01, 1.7, 2.3, 2.99}) {
        // From (x0, 0, 5) over (x, 0, 0) to z = 3: at 4 +- 0.5 where it comes from the mirror image of the eye.
        const double hit = x + (x + 1.0) * 3 / 5;
        const vec3 c = seen(scene, {{-1, 0, 5}, {x, 0, 0}, {0, 0, 0}});
        const bool is_seen = std::fabs(hit - 4) < 0.5;
        EXPECT_NEAR(c.x, is_seen ? 0.375f : 0, 1e-5) << x;
        EXPECT_NEAR(c.z, is_seen ? 0.75f : 0, 1e-5) << x;
    }
    EXPECT_EQ(seen(scene, {{-1, 0, 5}, {2.3, 0, 0}, {0, 0, 0}}, {.max_depth = 0}), vec3{});
    EXPECT_EQ(seen(scene, {{-1, 0, 5}, {2.3, 0, 0}, {0, 0, 0}}, {.method = RayMethod::cast}), vec3{});
}

TEST(Whitted, TwoMirrorsReflectAsOftenAsTheDepthSays) {
    Scene scene;
    scene.materials = {mirror(0.5f)};
    test::add_object(scene, test::square_mesh(0, 50));
    test::add_object(scene, test::square_mesh(0, 50), translation(dvec3{0, 0, 2}));
    // From between the mirrors, which end at x = 50, to the right: met at 47.5, 48.5 and 49.5 before the ray leaves into white.
    for (int depth = 0; depth <= 8; ++depth) {
        const vec3 c = seen(scene, {{47, 0, 1}, {47.5, 0, 0}, {1, 1, 1}}, {.max_depth = depth});
        EXPECT_NEAR(c.x, depth >= 3 ? 1.0 / 8 : 0, 1e-6) << depth;
    }
}

TEST(Whitted, FresnelAtNormalIncidence) {
    for (const float ior : {1.33f, 1.5f, 2.42f}) {
        Scene scene;
        scene.materials = {glass(ior)};
        add_slab(scene, 0, 10, 1);
        const double r = std::pow((double(ior) - 1) / (double(ior) + 1), 2);
        // All orders of reflections inside go out above or below, and both sides show the same white.
        EXPECT_NEAR(seen(scene, {{0, 5, 0}, {0, 0, 0}}, {.max_depth = 24}).x, 1, 2e-3) << ior;
        scene.materials.push_back(glowing({0, 0, 0}));
        dmat4 below = translation(dvec3{0, -5, 0});
        below[1] = {0, 0, -1, 0}, below[2] = {0, 1, 0, 0};
        test::add_object(scene, test::square_mesh(1, 9), below);
        // Only what is reflected upward: r + (1-r)^2 r / (1 - r^2) = 2 r / (1 + r).
        EXPECT_NEAR(seen(scene, {{0, 5, 0}, {0, 0, 0}}, {.max_depth = 24}).x, 2 * r / (1 + r), 2e-3) << ior;
    }
}

TEST(Whitted, ASlabShiftsTheRayAndKeepsItsDirection) {
    for (const double degrees : {10.0, 30.0, 50.0, 70.0}) {
        Scene scene;
        scene.materials = {glass(1.5f), glowing({0, 1, 0}), glowing({0, 0, 0})};
        const double thickness = 2;
        add_slab(scene, 0, 40, thickness);
        const double in = radians(degrees), out = std::asin(std::sin(in) / 1.5);
        const double under = thickness * std::tan(out), below = under + 3 * std::tan(in);  // at y = -5
        dmat4 lying = translation(dvec3{below, -5, 0});
        lying[1] = {0, 0, -1, 0}, lying[2] = {0, 1, 0, 0};
        test::add_object(scene, test::square_mesh(1, 1e-3f), lying);
        lying[3].y = -5.001;
        test::add_object(scene, test::square_mesh(2, 39), lying);
        const vec3 c = seen(scene, {{-4 * std::tan(in), 4, 0}, {0, 0, 0}, {0, 0, 0}});
        const double passes = 1 - fresnel(std::cos(in), 1 / 1.5);
        EXPECT_NEAR(c.y, passes * passes, 2e-3) << degrees;
        EXPECT_EQ(c.x, 0);
    }
}

TEST(Whitted, TotalReflectionBeginsAtTheCriticalAngle) {
    // From inside of the slab up: the eye is in it, above is white, the floor black.
    const double critical = std::asin(1 / 1.5);
    for (const double share : {0.2, 0.9, 0.99, 1.01, 1.1, 1.5}) {
        const double angle = share * critical;
        Scene scene;
        scene.materials = {glass(1.5f)};
        add_slab(scene, 0, 400, 100);
        const dvec3 from{0, -1, 0}, to = from + dvec3{std::sin(angle), std::cos(angle), 0};
        const vec3 c = seen(scene, {from, to}, {.max_depth = 1});
        // One step: what goes out is white; what is reflected meets the far side, where no ray goes on.
        EXPECT_NEAR(c.x, share < 1 ? 1 - fresnel(std::cos(angle), 1.5) : 0, 1e-3) << share;
    }
}

/// A ray through a sphere: both angles from Snell, offset b: the emerging ray turns by 2 (i - r).
TEST(Whitted, ASphereRefractsBySnell) {
    const double ior = 1.5;
    for (const double b : {0.0, 0.2, 0.5, 0.8, 0.95}) {
        Scene scene;
        Context context;
        scene = load("builtin:sphere:tolerance=0.001", {}, context);
        scene.materials = {glass(float(ior)), glowing({0, 1, 0})};
        const double i = std::asin(b), r = std::asin(b / ior), turn = 2 * (i - r);
        // From where it comes in it leaves after pi - 2 r of the great circle.
        const dvec3 exit{0, std::sin(2 * r - i), std::cos(2 * r - i)};
        const dvec3 along{0, -std::sin(turn), std::cos(turn)};
        const dvec3 target = exit + along * 3.0;
        const dvec3 z = along, x{1, 0, 0}, y = cross(z, x);
        dmat4 facing;
        facing[0] = {x.x, x.y, x.z, 0}, facing[1] = {y.x, y.y, y.z, 0}, facing[2] = {z.x, z.y, z.z, 0};
        facing[3] = {target.x, target.y, target.z, 1};
        test::add_object(scene, test::square_mesh(1, 1e-3f), facing);
        const vec3 c = seen(scene, {{0, b, -5}, {0, b, 0}, {0, 0, 0}});
        const double passes = 1 - fresnel(std::cos(i), 1 / ior);
        EXPECT_NEAR(c.y, passes * passes, 3e-3) << b;
    }
}

TEST(Whitted, ABodyAbsorbsByBeerAndLambert) {
    Scene scene;
    scene.materials = {glass(1.0f)};  // no border: the path alone counts
    scene.materials[0].metallic_roughness.attenuation_distance = 0.5f;
    scene.materials[0].metallic_roughness.attenuation_color = {0.25f, 0.5f, 1};
    add_slab(scene, 0, 10, 1);
    const vec3 c = seen(scene, {{0, 5, 0}, {0, 0, 0}});
    EXPECT_NEAR(c.x, 1.0 / 16, 1e-5);  // 1 m: twice
    EXPECT_NEAR(c.y, 0.25, 1e-5);
    EXPECT_NEAR(c.z, 1, 1e-5);
    const vec3 slanted = seen(scene, {{-3, 3, 0}, {0, 0, 0}});
    EXPECT_NEAR(slanted.y, std::pow(0.5, 2 * std::sqrt(2.0)), 1e-5);
}

/// Of two bodies, one in the other: the inner border is met with their ratio.
TEST(Whitted, NestedBodiesMeetWithTheRatioOfTheirIndices) {
    Scene scene;
    scene.materials = {glass(1.33f), glass(1.5f), glowing({0, 0, 0})};
    add_slab(scene, 0, 10, 4);
    dmat4 inner = scaling(dvec3{3, 0.5, 3});
    inner[3] = {0, -2, 0, 1};
    test::add_object(scene, box_mesh(1), inner);
    dmat4 below = translation(dvec3{0, -9, 0});
    below[1] = {0, 0, -1, 0}, below[2] = {0, 1, 0, 0};
    test::add_object(scene, test::square_mesh(2, 9), below);
    const auto r = [](double a, double b) { return std::pow((a - b) / (a + b), 2); };
    const double outer = r(1, 1.33), border = r(1.33, 1.5), t = 1 - outer, u = 1 - border;
    // First orders: the top, the inner top, the inner bottom, the bottom.
    const double sum = outer + t * t * (border + u * u * (border + u * u * outer));
    EXPECT_NEAR(seen(scene, {{0, 5, 0}, {0, 0, 0}}, {.max_depth = 16}).x, sum, 0.004);
}

TEST(Whitted, AThinWallLetsStraightThroughWithItsColor) {
    Scene scene;
    scene.materials = {glass(1.5f, 0)};
    scene.materials[0].base_color = {0.5f, 0.25f, 1, 1};
    test::add_object(scene, test::square_mesh(0, 5));
    const vec3 c = seen(scene, {{0, 0, 5}, {0, 0, 0}}, {.background = {}});
    EXPECT_NEAR(c.x, 0.04 + 0.96 * 0.5, 1e-5);
    EXPECT_NEAR(c.y, 0.04 + 0.96 * 0.25, 1e-5);
}

/// A floor `half` about the middle at y = -3, under the sun, seen below what stands between.
class UnderGlass : public testing::Test {
protected:
    UnderGlass() {
        scene_.materials = {test::matte(), glass(1.0f), glass(1.0f)};
        scene_.materials[0].classical.specular = {};
        scene_.materials[1].metallic_roughness.attenuation_distance = 1;
        scene_.materials[1].metallic_roughness.attenuation_color = {0.5f, 0.25f, 1};
        add_lying(0, 8, -3);
    }
    void add_lying(std::uint32_t material, float half, double y) {
        dmat4 lying = translation(dvec3{0, y, 0});
        lying[1] = {0, 0, -1, 0}, lying[2] = {0, 1, 0, 0};
        test::add_object(scene_, test::square_mesh(material, half), lying);
    }
    /// Of the light without anything between.
    vec3 share() const {
        Scene s = scene_;
        s.lights = {{.type = LightType::directional, .direction = {0, -1, 0}, .ambient = {0, 0, 0}}};
        Camera camera;
        camera.to_world = look_at({5, -1, 0}, {0, -3, 0}, {0, 1, 0});
        camera.vertical_fov_rad = 1e-4, camera.z_near = 0.01, camera.z_far = 100;
        Context context({.threads = 1});
        const auto engine = make_engine();
        engine->prepare(std::move(s), context);
        Frame frame;
        engine->render(camera, {.width = 1, .height = 1, .shadows = true}, frame, context);
        return frame.color[0].xyz();
    }
    Scene scene_;
};

TEST_F(UnderGlass, TheShadowHasTheColorAndDepthOfABody) {
    EXPECT_NEAR(share().x, 1, 1e-6);
    add_slab(scene_, 1, 1, 1);
    const vec3 under = share();
    EXPECT_NEAR(under.x, 0.5, 1e-3);
    EXPECT_NEAR(under.y, 0.25, 1e-3);
    EXPECT_NEAR(under.z, 1, 1e-3);
}

TEST_F(UnderGlass, WhatLiesInABodyTakesNothingOfItsDepth) {
    add_slab(scene_, 1, 1, 2);
    dmat4 inner = scaling(dvec3{0.5, 0.01, 0.5});
    inner[3] = {0, -1.8, 0, 1};
    test::add_object(scene_, box_mesh(2), inner);
    EXPECT_NEAR(share().x, std::pow(0.5, 1.98), 1e-3);
}

TEST_F(UnderGlass, AFarHorizonChangesNothing) {
    for (const float half : {8.0f, 1e3f, 2e4f}) {
        scene_.nodes.clear(), scene_.meshes.clear();
        add_lying(0, half, -3);
        dmat4 m = scaling(dvec3{1, 0.003, 1});
        m[3] = {0, -2.99, 0, 1};  // 6 mm, 7 mm above the floor
        scene_.materials[1].metallic_roughness.attenuation_distance = 0.003f;
        test::add_object(scene_, box_mesh(1), m);
        const double slanted = std::sqrt(29.0) / 2;  // the eye looks through it, too
        EXPECT_NEAR(share().x, 0.25 * std::pow(0.25, slanted), 1e-4) << half;
    }
}

TEST_F(UnderGlass, WhatIsNotThereThrowsNoShadow) {
    Material& m = scene_.materials[1];
    m.metallic_roughness.transmission = 0.5f, m.metallic_roughness.thickness = 0;
    add_lying(1, 1, -1);
    const float whole = share().x;
    EXPECT_NEAR(whole, 0.5, 1e-3);
    m.alpha_mode = AlphaMode::mask, m.base_color.w = 0.25f;
    EXPECT_EQ(share().x, 1) << "cut out";
    m.alpha_mode = AlphaMode::blend;
    EXPECT_NEAR(share().x, 0.75 + 0.25 * double(whole), 1e-5);
}

TEST(Whitted, FogBeforeAnOpenedSurfaceIsSeen) {
    Scene scene;
    Material pane = mirror(0);
    pane.classical.mirror = Mirror::none, pane.classical.transmission = {1, 1, 1};
    pane.base_color.w = 0.02f, pane.alpha_mode = AlphaMode::blend;
    scene.materials = {pane};
    scene.fog = {.kind = FogKind::exponential, .color = {1, 1, 1}, .density = 1};
    test::add_object(scene, test::square_mesh(0, 5));
    for (const int depth : {0, 8}) {
        // White fog before a pane that is nearly open, and white behind it.
        const double f = std::exp(-5.0);
        EXPECT_NEAR(seen(scene, {{0, 0, 5}, {0, 0, 0}}, {.max_depth = depth}).x, 1 - 0.02 * f, 0.021 * f) << depth;
    }
}

TEST(Whitted, ACoatMirrorsOverARoughBase) {
    Scene scene;
    Material coated;
    coated.base_color = {0, 0, 0, 1};
    coated.metallic_roughness = {.metallic = 0, .roughness = 1, .clearcoat = 0.5f, .clearcoat_roughness = 0};
    scene.materials = {coated};
    test::add_object(scene, test::square_mesh(0, 5));
    EXPECT_NEAR(seen(scene, {{0, 0, 5}, {0, 0, 0}}).x, 0.5 * 0.04, 1e-4);
}

/// Leaving a body in another that overlaps it bends nothing.
TEST(Whitted, OverlappingBodiesAreOnePath) {
    Scene scene;
    scene.materials = {glass(1.5f), glass(1.5f)};
    scene.materials[1].name = "other";
    add_slab(scene, 0, 10, 2);
    dmat4 lower = scaling(dvec3{10, 1, 10});
    lower[3] = {0, -2.5, 0, 1};  // y -3.5 .. -1.5, over the lower quarter of the first
    test::add_object(scene, box_mesh(1), lower);
    scene.materials.push_back(glowing({0, 0, 0}));
    dmat4 below = translation(dvec3{0, -9, 0});
    below[1] = {0, 0, -1, 0}, below[2] = {0, 1, 0, 0};
    test::add_object(scene, test::square_mesh(2, 9), below);
    EXPECT_NEAR(seen(scene, {{0, 5, 0}, {0, 0, 0}}, {.max_depth = 24}).x, 2 * 0.04 / 1.04, 2e-3) << "as one slab";
}

TEST(Whitted, HasTheSameBitsForAnyThreadsAndWindows) {
    Context context;
    Scene scene = load("builtin:torus:tolerance=0.01", {}, context);
    scene.materials = {glass(1.5f), mirror(0.9f)};
    test::add_object(scene, test::square_mesh(1, 4), translation(dvec3{0, 0, -2}));
    scene.lights = {{.type = LightType::point, .position = {2, 3, 4}}};
    Camera camera;
    camera.to_world = look_at({1, 2, 3}, {0, 0, 0}, {0, 1, 0});
    camera.z_near = 0.1, camera.z_far = 100;
    RenderSettings settings{.width = 90, .height = 70, .shadows = true};
    const auto drawn = [&](int threads) {
        Context own({.threads = threads});
        const auto engine = make_engine();
        engine->prepare(scene, own);
        Frame frame;
        const RenderStats stats = engine->render(camera, settings, frame, own);
        EXPECT_GT(stats.rays.reflected, 1000u);
        EXPECT_GT(stats.rays.refracted, 1000u);
        EXPECT_GT(stats.rays.shadow, 1000u);
        EXPECT_GT(stats.rays.scene_bytes, 0u);
        return frame;
    };
    const Frame one = drawn(1), many = drawn(5);
    EXPECT_TRUE(one.color == many.color);
    settings.window = {13, 11, 60, 50};
    const Frame part = drawn(2);
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 60; ++x)
            ASSERT_EQ(part.color[std::size_t(y * 60 + x)], one.color[std::size_t((y + 11) * 90 + x + 13)])
                << x << " " << y;
}

/// Scenes that no eye has seen: a picture comes all the same, finite, and soon.
TEST(Whitted, ExtremeScenesEndInAPicture) {
    int pictures = 0;
    for (const float number : {0.0f, 1e-30f, 0.1f, 1e30f}) {
        Context context;
        Scene scene = load("builtin:sphere", {}, context);
        scene.materials = {glass(number), mirror(1)};
        scene.materials[0].metallic_roughness.attenuation_distance = number;
        scene.materials[0].metallic_roughness.attenuation_color = {0, number, 1};
        scene.lights = {{.type = LightType::point, .position = {0, 1, 0}},   // on the surface
                        {.type = LightType::point, .position = {0, 0, 0}}};  // inside
        Mesh broken = test::square_mesh(1, 3);
        broken.positions = Block<vec3>(std::vector<vec3>{{NAN, 0, 0}, {1, 1, 1}, {1, 1, 1}, {0, INFINITY, 0}});
        test::add_object(scene, broken);
        test::add_object(scene, test::square_mesh(1, 3), translation(dvec3{0, 0, 2}));
        test::add_object(scene, test::square_mesh(1, 3), translation(dvec3{0, 0, -2}));
        Camera camera;
        camera.to_world = look_at({0.5, 0.4, 1.5}, {0, 0, 0}, {0, 1, 0});
        camera.z_near = 0.01, camera.z_far = 100;
        const auto engine = make_engine();
        engine->prepare(scene, context);
        Frame frame;
        engine->render(camera, {.width = 40, .height = 30, .shadows = true, .max_depth = 64}, frame, context);
        for (const vec4& c : frame.color) EXPECT_TRUE(is_finite(c.xyz())) << number;
        ++pictures;
    }
    EXPECT_EQ(pictures, 4);
}

TEST(Cast, HeldAgainstEveryTriangleThePictureIsTheSame) {
    Context context;
    Scene scene = load("builtin:teapot", {}, context);
    test::add_object(scene, load("builtin:torus", {}, context).meshes[0], translation(dvec3{0, 1, 0}));
    scene.meshes.back().material = 0;
    scene.lights = {{.type = LightType::point, .position = {2, 8, 4}}};
    Camera camera;
    camera.to_world = look_at({3, 4, 6}, {0, 1, 0}, {0, 1, 0});
    camera.z_near = 0.1, camera.z_far = 100;
    RenderSettings settings{.width = 48, .height = 36, .shadows = true, .method = RayMethod::cast};
    const auto engine = make_engine();
    engine->prepare(scene, context);
    Frame fast, naive;
    engine->render(camera, settings, fast, context);
    settings.naive = true;
    const RenderStats stats = engine->render(camera, settings, naive, context);
    int others = 0;
    for (std::size_t i = 0; i < fast.color.size(); ++i) others += !(fast.color[i] == naive.color[i]);
    EXPECT_LE(others, 5) << "at edges";
    std::uint64_t surfaces = 0;  // the torus is one
    for (const Mesh& mesh : scene.meshes) surfaces += mesh.shape ? 1 : mesh.triangle_count();
    EXPECT_EQ(stats.rays.triangle_tests, surfaces * (stats.rays.primary + stats.rays.shadow));
    settings.naive_limit = 1000;
    try {
        engine->render(camera, settings, naive, context);
        ADD_FAILURE() << "it was begun";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::usage);
        EXPECT_NE(std::string(error.what()).find("tests"), std::string::npos);
    }
}

}  // namespace
}  // namespace rakelight::raytrace
