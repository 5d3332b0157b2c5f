// SPDX-License-Identifier: Apache-2.0
// Light from all around, on pictures: furnaces of known answer, the sky behind everything, the same bits everywhere.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>

#include <rakelight/render/render.h>

#include "math/isa.h"
#include "math/linear.h"
#include "unit/render/environment_scenes.h"

namespace rakelight {
namespace {

using namespace test;

void expect_everywhere(const Frame& f, float wanted, double tolerance) {
    int covered = 0;
    for (std::size_t i = 0; i < f.color.size(); ++i) {
        if (f.object[i] == no_index) continue;
        ++covered;
        ASSERT_NEAR(f.color[i].x, wanted, tolerance);
        ASSERT_NEAR(f.color[i].z, wanted, tolerance);
    }
    EXPECT_GT(covered, 1000);
}

TEST(EnvironmentLight, AWhiteDiffuseSphereInAWhiteFurnaceIsAsBrightAsTheFurnace) {
    for (const Lighting lighting : {Lighting::lambert, Lighting::oren_nayar, Lighting::phong, Lighting::blinn_phong}) {
        const Scene scene = sphere_in({.image = even(1)}, [&](Material& m) {
            m.model = MaterialModel::classical;
            m.base_color = {1, 1, 1, 1};
            m.lighting = lighting;
        });
        expect_everywhere(draw(scene, {.channels = channel_object}), 1, 1e-3);
    }
}

TEST(EnvironmentLight, IntensityAndBaseColorMultiply) {
    const Scene scene = sphere_in({.image = even(2), .intensity = 3}, [](Material& m) {
        m.model = MaterialModel::classical;
        m.base_color = {0.25f, 0.25f, 0.25f, 1};
    });
    expect_everywhere(draw(scene, {.channels = channel_object}), 1.5f, 2e-3);
}

/// White dielectrics send back all that falls on them: what is not mirrored is diffuse.
TEST(EnvironmentLight, AWhiteDielectricSphereVanishesInAWhiteFurnace) {
    for (const Lighting lighting : {Lighting::pbr, Lighting::blinn_phong})
        for (const float roughness : {0.1f, 0.5f, 1.0f}) {
            const Scene scene = sphere_in({.image = even(1)}, [&](Material& m) {
                m.base_color = {1, 1, 1, 1};
                m.lighting = lighting;
                m.metallic_roughness.roughness = roughness;
            });
            expect_everywhere(draw(scene, {.channels = channel_object}), 1, 2e-3);
        }
}

/// KHR_materials_specular: the factor takes from the rim as well.
TEST(EnvironmentLight, ABlackSphereOfSpecularFactorZeroMirrorsNothing) {
    for (const Lighting lighting : {Lighting::phong, Lighting::blinn_phong, Lighting::ward, Lighting::pbr}) {
        const Scene scene = sphere_in({.image = even(1)}, [&](Material& m) {
            m.base_color = {0, 0, 0, 1};
            m.lighting = lighting;
            m.metallic_roughness.specular = 0;
        });
        expect_everywhere(draw(scene, {.channels = channel_object}), 0, 0);
    }
}

TEST(EnvironmentLight, AWhiteMetalSphereShowsTheDirectionalAlbedoOfSingleScattering) {
    // roughness, albedo seen along the normal: 1 - ln 2 at 1; the others by a plain sum over the half sphere
    for (const auto& [roughness, albedo] : {std::pair{1.0f, 1 - std::log(2.0)}, std::pair{0.5f, 0.9158}}) {
        const Scene scene = sphere_in({.image = even(1)}, [&](Material& m) {
            m.base_color = {1, 1, 1, 1};
            m.lighting = Lighting::pbr;
            m.metallic_roughness.metallic = 1;
            m.metallic_roughness.roughness = roughness;
        });
        const Frame f = draw(scene);
        EXPECT_NEAR(f.color[std::size_t(40 * 96 + 48)].x, albedo, 0.01) << roughness;
        expect_everywhere(draw(scene, {.channels = channel_object, .multiple_scattering = true}), 1, 0.01);
    }
}

TEST(EnvironmentLight, TermsOfTheLightAddUpToTheColor) {
    const Scene scene = sphere_in({}, [](Material&) {});
    const Frame f = draw(scene, {.channels = channel_object | channels_lighting});
    for (std::size_t i = 0; i < f.color.size(); ++i) {
        if (f.object[i] == no_index) continue;
        const vec3 sum = f.ambient[i] + f.diffuse[i] + f.specular[i] + f.emission[i];
        ASSERT_NEAR(sum.x, f.color[i].x, 1e-6);
    }
}

// --- the sky

TEST(Sky, EveryUncoveredPixelShowsThePictureInItsDirection) {
    const auto light = [](dvec3 d) { return vec3{float(1 + d.x), float(1 + d.y), float(1 + d.z)}; };
    Scene scene = sphere_in({.image = panorama(light, 512), .is_light = false}, [](Material&) {});
    Camera camera;
    const double c = std::cos(0.7), s = std::sin(0.7);
    camera.to_world = {{{c, 0, -s, 0}, {0, 1, 0, 0}, {s, 0, c, 0}, {5 * s, 0.3, 5 * c, 1}}};
    for (const int samples : {1, 4}) {
        Context context;
        const Frame f = render(scene, camera,
                               {.width = 200, .height = 150, .channels = channel_object, .samples = samples}, context);
        int seen = 0;
        for (int y = 0; y < 150; ++y)
            for (int x = 0; x < 200; ++x) {
                const std::size_t i = std::size_t(y * 200 + x);
                if (f.object[i] != no_index || std::hypot(x - 100, y - 75) < 60) continue;  // and no pixel at its edge
                const double t = std::tan(camera.vertical_fov_rad / 2) / 75;
                const dvec3 ray{(x + 0.5 - 100) * t, (75 - y - 0.5) * t, -1};
                const dvec3 d = normalize_or(transform_direction(camera.to_world, ray), {0, 0, 0});
                for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(f.color[i][k], light(d)[k], 4e-3) << x << ' ' << y;
                ASSERT_EQ(f.color[i].w, 1.0f);
                ++seen;
            }
        EXPECT_GT(seen, 10000);
    }
}

TEST(Sky, TurnsWithTheEnvironmentCounterClockwiseSeenFromAbove) {
    const auto light = [](dvec3 d) { return vec3{d.x > 0.9 ? 5.0f : 0.0f, 0, 0}; };  // a spot at +X
    for (const bool is_turned : {false, true}) {
        Scene scene =
            sphere_in({.image = panorama(light, 256), .rotation_rad = is_turned ? pi / 2 : 0, .is_light = false},
                      [](Material&) {});
        Camera camera;  // looks along -Z, past the sphere
        camera.to_world = translation(dvec3{0, 50, 0});
        Context context;
        const Frame f = render(scene, camera, {.width = 64, .height = 64}, context);
        EXPECT_EQ(f.color[32 * 64 + 32].x, is_turned ? 5.0f : 0.0f);  // +X has come to -Z
    }
}

TEST(Sky, IsOneColorInParallelViews) {
    const auto light = [](dvec3 d) { return vec3{float(1 + d.x), float(1 + d.y), float(1 + d.z)}; };
    Scene scene = sphere_in({.image = panorama(light, 256), .is_light = false}, [](Material&) {});
    Camera camera;
    camera.projection = Projection::orthographic;
    camera.half_height = 3;
    camera.to_world = translation(dvec3{0, 0, 5});
    Context context;
    const Frame f = render(scene, camera, {.width = 64, .height = 64}, context);
    EXPECT_NEAR(f.color[0].z, 0, 1e-2);  // along -Z
    EXPECT_NEAR(f.color[0].x, 1, 1e-2);
    EXPECT_EQ(f.color[0], f.color[64 * 64 - 1]);
}

TEST(Sky, AnEnvironmentThatOnlyLightsLeavesTheBackground) {
    const Frame f = draw(sphere_in({.is_background = false}, [](Material&) {}), {.background = {0.5f, 0.25f, 0, 0.5f}});
    EXPECT_EQ(f.color[0], (vec4{0.5f, 0.25f, 0, 0.5f}));
}

TEST(Sky, WindowsAndThreadsAndInstructionSetsGiveTheSameBits) {
    const Scene scene = sphere_in({.rotation_rad = 0.3}, [](Material& m) { m.metallic_roughness.metallic = 1; });
    const Frame whole = draw(scene);
    EXPECT_TRUE(draw(scene, {}, 4).color == whole.color);
    const Frame window = draw(scene, {.window = {33, 7, 50, 60}});
    for (int y = 0; y < 60; ++y)
        EXPECT_EQ(std::memcmp(&window.color[std::size_t(y * 50)], &whole.color[std::size_t((y + 7) * 96 + 33)],
                              50 * sizeof(vec4)),
                  0);
    for (const char* isa : {"scalar", "sse2", "avx2"}) {
        setenv("RAKELIGHT_ISA", isa, 1);
        EXPECT_TRUE(draw(scene).color == whole.color) << isa;
        unsetenv("RAKELIGHT_ISA");
    }
}

TEST(EnvironmentLight, APictureThatCannotBeDecodedIsAWarningAndNoLight) {
    auto image = std::make_shared<EncodedImage>();
    image->name = "broken.hdr";
    image->decode = [](const EncodedImage&, Context&) -> Pixels { throw Error(ErrorCode::bad_file, "broken"); };
    Context context;
    const Frame f = render(sphere_in({.image = image}, [](Material&) {}),
                           {.width = 32, .height = 32, .background = {0.5f, 0, 0, 1}}, context);
    EXPECT_EQ(f.color[0].x, 0.5f);
    ASSERT_GE(context.report().entries().size(), 1u);
    EXPECT_NE(context.report().entries()[0].message.find("environment left out"), std::string::npos);
}

}  // namespace
}  // namespace rakelight
