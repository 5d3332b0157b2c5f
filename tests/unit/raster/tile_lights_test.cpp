// SPDX-License-Identifier: Apache-2.0
// Light lists of tiles leave out nothing that could add something: pictures with them are those without, to the bit.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engines/raster/inspect/inspect_shading.h"
#include "engines/raster/lights/tile_lights.h"
#include "math/isa.h"
#include "unit/raster/busy_scene.h"
#include "unit/raster/drawn.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

constexpr int width = 230, height = 150;

/// The busy scene under many small lights of both kinds, and some without an end.
Scene many_lights(int count) {
    Scene scene = busy_scene();
    std::mt19937 random(11);
    std::uniform_real_distribution<double> at(-3, 3), part(0, 1);
    for (int i = 0; i < count; ++i) {
        Light light;
        light.position = {at(random), at(random), at(random) + 1};
        light.range = float(0.2 + part(random));
        light.diffuse = light.specular = {float(part(random)), float(part(random)), float(part(random))};
        light.ambient = light.diffuse * 0.1f;
        light.color = light.diffuse;
        light.intensity = 0.3f;
        light.quadratic = 2;
        if (i % 2) light.units = LightUnits::photometric;
        if (i % 3 == 0) light.type = LightType::spot;
        if (i % 3 == 0) light.direction = {at(random), at(random), at(random)};
        scene.lights.push_back(light);
    }
    return scene;
}

RenderSettings settings_for(Shading shading, int samples = 1) {
    return {.width = width, .height = height, .shading = shading, .samples = samples};
}

struct IsaGuard {
    explicit IsaGuard(Isa isa) { setenv("RAKELIGHT_ISA", name(isa), 1); }
    ~IsaGuard() { unsetenv("RAKELIGHT_ISA"); }
};

TEST(TileLights, ChangeNoBitOfThePicture) {
    const Scene scene = many_lights(200);
    Camera parallel = busy_view();
    parallel.projection = Projection::orthographic;
    parallel.half_height = 3;
    for (const Camera& camera : {busy_view(), parallel})
        for (const int samples : {1, 4}) {
            const RenderSettings settings = settings_for(Shading::phong, samples);
            Context context({.threads = 1});
            const raster::Inspection inspection(scene, camera, settings, context);  // it lists none
            const Frame listed = draw(scene, camera, settings);
            EXPECT_TRUE(same_bits(listed.color, raster::draw_shaded(inspection, Shading::phong, context).color));
        }
}

TEST(TileLights, OfGouraudShadingAreThoseThatExplainFinds) {
    const Scene scene = many_lights(100);
    for (const Shading shading : {Shading::flat, Shading::gouraud}) {
        const RenderSettings settings = settings_for(shading);
        const Frame frame = draw(scene, busy_view(), settings);
        Context context({.threads = 1});
        const raster::Inspection inspection(scene, busy_view(), settings, context);
        for (const auto& [x, y] : {std::pair(30, 60), {70, 80}, {115, 75}, {160, 40}, {200, 120}}) {
            const raster::PixelExplanation p = inspection.explain(x, y, context);
            EXPECT_EQ(p.color, pixel(frame, x, y)) << x << ' ' << y;
            for (const raster::ShadedLayer& layer : p.layers)
                for (const raster::TracedCorner& corner : layer.corners) {
                    EXPECT_EQ(corner.lights.size(), scene.lights.size());
                    EXPECT_EQ(corner.corner.light.diffuse[0], [&] {
                        float sum = 0;
                        for (const raster::TracedLight& light : corner.lights) sum += light.diffuse[0];
                        return sum;
                    }());
                }
        }
    }
}

TEST(TileLights, GiveTheSameBitsForAnyThreadsInstructionSetAndWindow) {
    const Scene scene = many_lights(60);
    RenderSettings settings = settings_for(Shading::phong);
    const Frame whole = draw(scene, busy_view(), settings);
    EXPECT_TRUE(same_bits(whole, draw(scene, busy_view(), settings, 4)));
    for (const Isa isa : {Isa::scalar, Isa::sse2, Isa::avx2, Isa::avx512}) {
        if (!is_available(isa)) continue;
        const IsaGuard guard(isa);
        EXPECT_TRUE(same_bits(whole, draw(scene, busy_view(), settings))) << name(isa);
    }
    settings.window = {61, 33, 100, 90};
    const Frame part = draw(scene, busy_view(), settings);
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 100; ++x) ASSERT_EQ(pixel(part, x, y), pixel(whole, x + 61, y + 33)) << x << ' ' << y;
}

TEST(TileLights, ABoxListsEveryLightThatReachesAPointOfItAndFewOthers) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> at(-5, 5), part(0, 1);
    std::vector<lighting::LightParameters> lights(500);
    for (lighting::LightParameters& light : lights) {
        for (float& c : light.position) c = at(random);
        light.inverse_range = 1 / (0.1f + part(random));
    }
    const raster::LightReach reach(lights);
    ASSERT_TRUE(reach.is_worth_it());
    std::size_t listed = 0;
    for (int i = 0; i < 100; ++i) {
        raster::LightBox box;
        for (int c = 0; c < 3; ++c) box.low[c] = at(random), box.high[c] = box.low[c] + part(random);
        std::vector<lighting::LightParameters> found;
        reach.in_box(box, nullptr, found);
        listed += found.size();
        for (int k = 0; k < 50; ++k) {
            float p[3];
            for (int c = 0; c < 3; ++c) p[c] = box.low[c] + (box.high[c] - box.low[c]) * part(random);
            std::size_t reaching = 0, of_those = 0;
            const auto reaches = [&](const lighting::LightParameters& l) {
                double squared = 0;
                for (int c = 0; c < 3; ++c) squared += (double(l.position[c]) - p[c]) * (double(l.position[c]) - p[c]);
                return squared <= 1 / (double(l.inverse_range) * double(l.inverse_range));
            };
            for (const auto& l : lights) reaching += reaches(l);
            for (const auto& l : found) of_those += reaches(l);
            ASSERT_EQ(reaching, of_those);
        }
    }
    EXPECT_LT(listed, 100 * 500 / 20);
}

TEST(TileLights, AreNotMadeOfFewLightsNorOfThoseWithoutAnEnd) {
    std::vector<lighting::LightParameters> lights(40);
    EXPECT_FALSE(raster::LightReach(lights).is_worth_it());
    for (std::size_t i = 0; i < 8; ++i) lights[i].inverse_range = 1;
    EXPECT_FALSE(raster::LightReach(lights).is_worth_it());
    lights[8].inverse_range = 1;
    EXPECT_TRUE(raster::LightReach(lights).is_worth_it());
}

TEST(ClassicalRange, IsTheWindowTimesTheAttenuationAndNothingBeyond) {
    Scene scene;
    scene.materials = {matte()};
    add_object(scene, square_mesh(0, 10));
    Light light;
    light.ambient = {0.5f, 0, 0};
    light.diffuse = {0, 1, 0};
    light.linear = 0.5f;
    light.range = 3;
    for (const Shading shading : {Shading::flat, Shading::phong})
        for (const double d : {1.0, 2.0, 2.9, 3.0, 4.0}) {
            // Flat: lit at the centroid of the triangle that pixel 40, 50 shows.
            light.position = {shading == Shading::flat ? 10.0 / 3 : 0.0, shading == Shading::flat ? -10.0 / 3 : 0.0, d};
            scene.lights = {light};
            const Frame f = draw(scene, flat_camera(), {.width = 65, .height = 65, .shading = shading});
            const double ratio = d / 3, window = std::max(0.0, 1 - ratio * ratio * ratio * ratio);
            const double expected = window / (1 + 0.5 * d);
            const vec4 is = shading == Shading::flat ? pixel(f, 40, 50) : pixel(f, 32, 32);
            EXPECT_NEAR(is.x, 0.5 * expected, shading == Shading::flat ? 1e-6 : 2e-3) << d;
            EXPECT_NEAR(is.y, expected, shading == Shading::flat ? 1e-6 : 2e-3) << d;
            EXPECT_EQ(is.y == 0, d >= 3) << d;
        }
}

TEST(ClassicalRange, ARangeOfNextToNothingIsNoLightWithoutAnEnd) {
    Scene scene;
    scene.materials = {matte()};
    add_object(scene, square_mesh(0, 10));
    for (const LightUnits units : {LightUnits::classical, LightUnits::photometric})
        for (const double range : {1e-50, 1e-7, 0.5}) {
            Light light;
            light.units = units;
            light.position = {0, 0, 1};
            light.range = float(range);  // 1e-50 is 0
            scene.lights = {light};
            EXPECT_EQ(pixel(draw(scene, flat_camera(), {.width = 65, .height = 65}), 32, 32).y, 0) << range;
        }
}

}  // namespace
