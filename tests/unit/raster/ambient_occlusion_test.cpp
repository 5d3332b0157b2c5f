// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion against what the hemisphere really sees, and where it acts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "engines/raster/occlusion/occlusion.h"
#include "math/isa.h"
#include "unit/raster/busy_scene.h"
#include "unit/raster/shadows/shadow_scenes.h"

namespace rakelight::test {
namespace {

RenderSettings occluded(int width, int height, double radius, int samples = 256) {
    RenderSettings s{.width = width, .height = height, .channels = channel_ambient_occlusion | channel_position};
    s.ambient_occlusion = true;
    s.ambient_occlusion_radius = radius;
    s.ambient_occlusion_samples = samples;
    return s;
}

Light ambient_light(float strength = 1) {
    Light light;
    light.type = LightType::ambient;
    light.ambient = {strength, strength, strength};
    return light;
}

/// A floor y = 0, x > 0, and a wall x = 0, y > 0, as wide and high as 2 `size`, lit from all around.
Scene corner(double size) {
    Scene scene;
    scene.materials.push_back(matte());
    dmat4 floor = lying(), wall;
    floor[3] = {size, 0, 0, 1};
    wall[0] = {0, 0, -1, 0}, wall[1] = {0, 1, 0, 0}, wall[2] = {1, 0, 0, 0}, wall[3] = {0, size, 0, 1};
    add_square(scene, size, floor);
    add_square(scene, size, wall);
    scene.lights = {ambient_light()};
    return scene;
}

/// What GTAO's definition asks at a point of the floor, `d` from the wall, in double: many slices about v, horizons by a fine march up
/// the wall, the light between them by a sum over angles.
double openness_beside_wall(double d, double radius, dvec3 v) {
    const dvec3 n{0, 1, 0}, across = normalize_or(cross(dvec3{0, 0, 1}, v), dvec3{1, 0, 0}), upward = cross(v, across);
    const auto share = [&](double r) { return std::clamp((1 - r * r / (radius * radius)) / 0.75, 0.0, 1.0); };
    double open = 0, whole = 0;
    constexpr int slices = 360, parts = 720;
    for (int s = 0; s < slices; ++s) {
        const double phi = pi * (s + 0.5) / slices;
        const dvec3 a = across * std::cos(phi) + upward * std::sin(phi);
        const double n_v = dot(n, v), n_a = dot(n, a), part = std::hypot(n_v, n_a), gamma = std::atan2(n_a, n_v);
        double rise[2] = {0, 0};
        for (int k = 0; k < parts; ++k) {  // directions in the slice, from v
            const double theta = pi * ((k + 0.5) / parts * 2 - 1);
            const dvec3 w = v * std::cos(theta) + a * std::sin(theta);
            if (w.x >= 0) continue;
            const double r = -d / w.x;
            if (w.y <= 0 || r >= radius) continue;
            double& highest = rise[theta > 0 ? 0 : 1];
            highest = std::max(highest, share(r) * w.y);
        }
        const double high = gamma + pi / 2 - std::asin(std::min(rise[0] / part, 1.0));
        const double low = gamma - pi / 2 + std::asin(std::min(rise[1] / part, 1.0));
        for (int k = 0; k < parts; ++k) {
            const double theta = pi * ((k + 0.5) / parts * 2 - 1);
            const double light = part * std::max(std::cos(theta - gamma), 0.0) * std::fabs(std::sin(theta));
            whole += light;
            if (theta > low && theta < high) open += light;
        }
    }
    return open / whole;
}

/// What a wall without end leaves of the light to a point of the floor, `d` from it, where all of it within `radius` hides: the directions that meet it there
/// are those below asin(sqrt(1 - (d / (radius cos phi))^2)), and the integral has a closed form.
double openness_without_falloff(double d, double radius) {
    const double x = std::min(d / radius, 1.0);
    return 1 - (std::acos(x) - x * std::sqrt(1 - x * x)) / pi;
}

struct IsaGuard {
    explicit IsaGuard(Isa isa) { setenv("RAKELIGHT_ISA", name(isa), 1); }
    ~IsaGuard() { unsetenv("RAKELIGHT_ISA"); }
};

TEST(AmbientOcclusion, OfAPlaneAloneIsOne) {
    Scene scene;
    scene.materials.push_back(matte());
    add_square(scene, 40, lying());
    Camera parallel = looking({3, 2, 4}, {0, 0, 0});
    parallel.projection = Projection::orthographic, parallel.half_height = 3;
    for (const Camera& camera : {looking({0, 3, 0.5}, {0, 0, 0}), looking({2, 0.4, 3}, {0, 0, 0}), parallel}) {
        const Frame f = draw(scene, camera, occluded(160, 120, 0.5, 32));
        for (const float openness : f.ambient_occlusion) EXPECT_NEAR(openness, 1, 2e-3);
    }
}

TEST(AmbientOcclusion, BesideAWallIsWhatTheHemisphereSees) {
    const double radius = 1;
    const Camera camera = looking({4, 4, 0}, {0.3, 0, 0}, 0.9);
    const Frame f = draw(corner(20), camera, occluded(600, 600, radius));  // 115 pixels
    double largest = 0, sum = 0;
    int count = 0;
    for (int y = 290; y < 390; y += 9) {
        const auto p = std::size_t(y * 600 + 300);
        const vec3 at = f.position[p];
        if (std::fabs(at.y) > 1e-4 || at.x < 0.03) continue;  // of the wall, or mixed with it
        const double exact = openness_beside_wall(at.x, radius, normalize_or(dvec3{4.0 - at.x, 4, 0}, dvec3{0, 1, 0}));
        const double off = f.ambient_occlusion[p] - exact;
        EXPECT_NEAR(f.ambient_occlusion[p], exact, 0.02) << "at " << at.x;
        largest = std::max(largest, std::fabs(off)), sum += off * off, ++count;
    }
    ASSERT_GE(count, 8);
    RecordProperty("largest_error", std::to_string(largest));
    RecordProperty("rms_error", std::to_string(std::sqrt(sum / count)));
}

TEST(AmbientOcclusion, InTheEdgeOfTwoWallsHalfOfTheLightIsLeft) {
    const Camera camera = looking({4, 4, 0}, {0, 0, 0}, 0.1);
    const Frame f = draw(corner(20), camera, occluded(800, 800, 0.18));  // 250 pixels
    for (const int off : {3, -3}) {
        const auto p = std::size_t((400 + off) * 800 + 400);
        const vec3 at = f.position[p];
        EXPECT_LT(std::max(at.x, at.y), 0.02f);
        EXPECT_NEAR(f.ambient_occlusion[p], 0.5, 0.05);  // 3 pixels off the edge
        EXPECT_NEAR(openness_without_falloff(double(std::max(at.x, at.y)), 0.18), 0.5, 0.02);
    }
}

TEST(AmbientOcclusion, EndsAtTheRadius) {
    const Camera camera = looking({4, 4, 0}, {0.6, 0, 0}, 0.5);
    for (const double radius : {0.2, 0.5}) {
        const Frame f = draw(corner(20), camera, occluded(400, 400, radius));
        bool has_dark = false;
        for (std::size_t p = 0; p < f.position.size(); ++p) {
            const vec3 at = f.position[p];
            const double d = double(std::max(at.x, at.y));
            if (d > 1.02 * radius) {
                EXPECT_NEAR(f.ambient_occlusion[p], 1, 3e-3) << d;
            }
            has_dark |= f.ambient_occlusion[p] < 0.6f;
        }
        EXPECT_TRUE(has_dark);
    }
}

TEST(AmbientOcclusion, ASphereDarkensTheFloorBelowIt) {
    Scene scene;
    scene.materials.push_back(matte());
    add_square(scene, 30, lying());
    add_object(scene, sphere_mesh(64, 128), translation(dvec3{0, 1, 0}));
    scene.lights = {ambient_light()};
    const Frame f = draw(scene, looking({0, 3, 15}, {0, 0.5, 0}, 0.58), occluded(600, 600, 3));  // 200 pixels
    const auto at = [&](double distance) {  // of floor before the sphere, nearest to that far from where they touch
        float best = 2;
        double off = 1e9;
        for (std::size_t p = 0; p < f.position.size(); ++p) {
            const vec3 q = f.position[p];
            if (q.y > 1e-4f || q.z < 0) continue;
            const double d = std::fabs(std::hypot(double(q.x), double(q.z)) - distance) + std::fabs(double(q.x));
            if (d < off) off = d, best = f.ambient_occlusion[p];
        }
        return double(best);
    };
    // A sphere that is seen whole from a floor hides cos / d^2 of its light, d in its radii: 1 / d^3 where it touches the floor.
    for (const double distance : {1.2, 1.5})
        EXPECT_NEAR(at(distance), 1 - std::pow(1 + distance * distance, -1.5), 0.08) << distance;
    EXPECT_LT(at(1.0), at(1.3));
    EXPECT_LT(at(1.3), at(1.8));
    EXPECT_LT(at(1.8), at(2.6));
    EXPECT_NEAR(at(4.5), 1, 0.01);
    float top = 0;  // the sphere itself is hidden from nothing but below
    for (std::size_t p = 0; p < f.position.size(); ++p)
        if (f.position[p].y > 1.8f) top = std::max(top, std::fabs(f.ambient_occlusion[p] - 1));
    EXPECT_LT(top, 0.02f);
}

TEST(AmbientOcclusion, ActsOnAmbientLightAlone) {
    Scene scene = corner(3);
    const Camera camera = looking({4, 4, 0.5}, {0.3, 0.2, 0}, 0.4);
    RenderSettings with = occluded(120, 90, 0.6, 32), without = with;
    without.ambient_occlusion = false, without.channels = 0;
    scene.lights = {directional({-1, -1, -0.3}), lamp({2, 2, 0})};
    EXPECT_TRUE(same_bits(draw(scene, camera, with), draw(scene, camera, without)));
    scene.lights = {ambient_light(0.8f)};
    const Frame a = draw(scene, camera, with), b = draw(scene, camera, without);
    for (std::size_t p = 0; p < a.color.size(); ++p)
        EXPECT_NEAR(a.color[p].x, b.color[p].x * a.ambient_occlusion[p], 1e-6);
}

/// Windows draw a guard band; several samples and blended surfaces go other ways through shading.
TEST(AmbientOcclusion, OfWindowsIsThatOfTheWhole) {
    const Scene scene = busy_scene();
    for (const int samples : {1, 4, 8}) {
        RenderSettings s = occluded(230, 150, 0, 16);
        s.samples = samples;
        const Frame whole = draw(scene, busy_view(), s, 2);
        for (const Window w :
             {Window{0, 0, 70, 150}, {70, 33, 100, 80}, {129, 64, 1, 1}, {64, 64, 64, 64}, {200, 100, 30, 50}}) {
            s.window = w;
            const Frame part = draw(scene, busy_view(), s);
            for (int y = 0; y < w.height; ++y)
                for (int x = 0; x < w.width; ++x) {
                    const auto p = std::size_t((w.y + y) * 230 + w.x + x), q = std::size_t(y * w.width + x);
                    ASSERT_EQ(part.color[q], whole.color[p]) << samples << ": " << w.x + x << ", " << w.y + y;
                    ASSERT_EQ(part.ambient_occlusion[q], whole.ambient_occlusion[p]);
                }
        }
    }
}

TEST(AmbientOcclusion, HasTheSameBitsForAnyThreadsAndInstructionSet) {
    const Scene scene = busy_scene();
    RenderSettings s = occluded(230, 150, 0, 32);
    for (const int samples : {1, 4}) {
        s.samples = samples;
        const Frame expected = [&] {
            const IsaGuard guard(Isa::scalar);
            return draw(scene, busy_view(), s);
        }();
        float least = 1;
        for (const float v : expected.ambient_occlusion) least = std::min(least, v);
        EXPECT_LT(least, 0.9f);
        for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512}) {
            if (!is_available(isa)) continue;
            const IsaGuard guard(isa);
            const Frame f = draw(scene, busy_view(), s, 3);
            EXPECT_TRUE(same_bits(f, expected)) << name(isa);
            EXPECT_TRUE(same_bits(f.ambient_occlusion, expected.ambient_occlusion)) << name(isa);
        }
    }
}

/// It draws depths before there is any light of faces and vertices.
TEST(AmbientOcclusion, MasksOfFlatAndGouraudShadingHaveNoLightYet) {
    Scene scene = corner(20);
    scene.materials[0].alpha_mode = AlphaMode::mask;
    for (const Shading shading : {Shading::flat, Shading::gouraud}) {
        RenderSettings s = occluded(60, 40, 0.5, 32);
        s.shading = shading;
        const Frame f = draw(scene, looking({0, 3, 15}, {0, 0.5, 0}, 0.58), s);
        EXPECT_LT(*std::ranges::min_element(f.ambient_occlusion), 1);
    }
}

TEST(AmbientOcclusion, ItsDefaultRadiusIsAPartOfTheScene) {
    const Bounds bounds{{-1, -2, -2}, {1, 2, 2}};
    EXPECT_NEAR(raster::occlusion_radius({}, bounds), 0.3, 1e-12);
    EXPECT_EQ(raster::occlusion_radius({.ambient_occlusion_radius = 2}, bounds), 2);
    EXPECT_EQ(raster::occlusion_radius({}, Bounds{}), 1);
}

}  // namespace
}  // namespace rakelight::test
