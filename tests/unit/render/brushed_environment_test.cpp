// SPDX-License-Identifier: Apache-2.0
// Surroundings in brushed surfaces: streaks across the grooves, no light lost or made.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "math/isa.h"
#include "math/linear.h"
#include "unit/render/environment_scenes.h"

namespace rakelight {
namespace {

using namespace test;

constexpr int size = 96;

/// A cylinder that stands before the camera and mirrors one lamp, 8 degrees in radius, behind the viewer.
Frame lamp_in_cylinder(const std::function<void(Material&)>& change) {
    Scene scene = make_primitive({.shape = PrimitiveShape::cylinder, .radius = 0.6, .tolerance = 1e-4});
    Material& m = scene.materials[0];
    m.base_color = {1, 1, 1, 1};
    m.metallic_roughness.metallic = 1;
    m.metallic_roughness.roughness = 0.2f;
    change(m);
    scene.environment = Environment{.image = panorama(
                                        [](dvec3 d) {
                                            return d.z > 0.99 ? vec3{1, 1, 1} : vec3{0, 0, 0};
                                        },
                                        256),
                                    .is_background = false};
    Camera camera;
    camera.to_world = translation(dvec3{0, 0, 3});
    camera.vertical_fov_rad = 0.75;
    Context context;
    return render(scene, camera, {.width = size, .height = size}, context);
}

void brush(Material& m, float rotation_rad) {
    m.metallic_roughness.anisotropy = 0.8f;
    m.metallic_roughness.anisotropy_rotation_rad = rotation_rad;
}

/// Brightness so far beside, or above, the middle, as a share of that in the middle.
struct Reach {
    float beside, above;
};
Reach reach_of(const Frame& f) {
    const auto at = [&](int x, int y) { return f.color[std::size_t(y * size + x)].x; };
    const float middle = at(size / 2, size / 2);
    EXPECT_GT(middle, 0.01f);
    return {at(size / 2 + 10, size / 2) / middle, at(size / 2, size / 2 - 30) / middle};
}

TEST(BrushedEnvironment, AStreakLiesAcrossTheGrooves) {
    const Reach even = reach_of(lamp_in_cylinder([](Material&) {}));
    const Reach up = reach_of(lamp_in_cylinder([](Material& m) { brush(m, 0); }));
    const Reach around = reach_of(lamp_in_cylinder([](Material& m) { brush(m, float(pi / 2)); }));
    EXPECT_LT(even.beside, 0.05f);
    EXPECT_LT(even.above, 0.3f);
    EXPECT_GT(up.beside, 0.5f);  // grooves run up: light is spread around the cylinder
    EXPECT_LT(up.above, even.above + 0.1f);
    EXPECT_GT(around.above, 0.8f);  // grooves run around: light is spread along it
    EXPECT_LT(around.beside, 0.05f);
}

TEST(BrushedEnvironment, WardsUnequalWidthsSpreadItLikewise) {
    const auto ward = [](vec2 alpha) {
        return [alpha](Material& m) { m.lighting = Lighting::ward, m.ward_alpha = alpha; };
    };
    const Reach along_t = reach_of(lamp_in_cylinder(ward({0.6f, 0.04f}))),
                along_b = reach_of(lamp_in_cylinder(ward({0.04f, 0.6f})));
    EXPECT_GT(along_t.beside, 0.5f);
    EXPECT_GT(along_b.above, 0.8f);
    EXPECT_LT(along_b.beside, 0.05f);
}

TEST(BrushedEnvironment, EqualWidthsAreTheRoundLobeToTheBit) {
    for (const Lighting lighting : {Lighting::pbr, Lighting::ward}) {
        const Frame round = lamp_in_cylinder([&](Material& m) { m.lighting = lighting; });
        const Frame equal = lamp_in_cylinder([&](Material& m) {
            m.lighting = lighting;
            m.metallic_roughness.anisotropy = 1e-30f;  // alpha along the tangent is that across it
        });
        EXPECT_TRUE(round.color == equal.color) << int(lighting);
    }
}

TEST(BrushedEnvironment, AWhiteBrushedMetalVanishesInAWhiteFurnace) {
    for (const float strength : {0.3f, 0.9f}) {
        const Scene scene = sphere_in({.image = even(1)}, [&](Material& m) {
            m.base_color = {1, 1, 1, 1};
            m.lighting = Lighting::pbr;
            m.metallic_roughness.metallic = 1;
            m.metallic_roughness.roughness = 0.3f;
            m.metallic_roughness.anisotropy = strength;
        });
        const Frame f = draw(scene, {.channels = channel_object, .multiple_scattering = true});
        for (std::size_t i = 0; i < f.color.size(); ++i)
            if (f.object[i] != no_index) {
                ASSERT_NEAR(f.color[i].x, 1, 0.01) << strength;
            }
    }
}

TEST(BrushedEnvironment, SeenFromAboveAWhiteBrushedMetalReflectsAsMuchOfEvenLightAsItsLobe) {
    // E(n) of alpha_t = 1, alpha_b = roughness^2: quadrature of Heitz's 2018 visible normals, twice as many steps alike
    for (const auto& [roughness, expected] : {std::pair{0.2236f, 0.532f}, {0.3f, 0.530f}, {0.5f, 0.512f}}) {
        const Scene scene = sphere_in({.image = even(1)}, [&, r = roughness](Material& m) {
            m.base_color = {1, 1, 1, 1};
            m.lighting = Lighting::pbr;
            m.metallic_roughness.metallic = 1;
            m.metallic_roughness.roughness = r;
            m.metallic_roughness.anisotropy = 1;
        });
        const Frame f = draw(scene);
        EXPECT_NEAR(f.color[std::size_t(f.window.height / 2 * f.window.width + f.window.width / 2)].x, expected, 0.04)
            << roughness;
    }
}

TEST(BrushedEnvironment, ThreadsAndInstructionSetsGiveTheSameBits) {
    for (const Lighting lighting : {Lighting::pbr, Lighting::ward}) {
        const Scene scene = sphere_in({.rotation_rad = 0.3}, [&](Material& m) {
            m.lighting = lighting;
            m.metallic_roughness.metallic = 1;
            brush(m, 0.7f);
        });
        setenv("RAKELIGHT_ISA", "scalar", 1);
        const Frame expected = draw(scene);
        for (const Isa isa : {Isa::sse2, Isa::avx2, Isa::avx512}) {
            if (!is_available(isa)) continue;
            setenv("RAKELIGHT_ISA", name(isa), 1);
            EXPECT_TRUE(draw(scene, {}, 3).color == expected.color) << name(isa);
        }
        unsetenv("RAKELIGHT_ISA");
    }
}

}  // namespace
}  // namespace rakelight
