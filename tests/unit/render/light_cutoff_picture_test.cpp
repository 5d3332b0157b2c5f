// SPDX-License-Identifier: Apache-2.0
// What --light-cutoff makes of a picture: every pixel within the bound, and nothing where no light is cut.
#include <gtest/gtest.h>
#include <rakelight/rakelight.h>

#include <algorithm>
#include <cmath>

#include "prepare/shapes/primitives.h"
#include "scene/light_cutoff.h"

namespace rakelight {
namespace {

constexpr int width = 96, height = 64, side = 6;

/// A floor of 8 x 8 m under side * side lamps half a meter above it.
Scene lit_floor(LightUnits units, float color) {
    Scene scene = make_primitive({.shape = PrimitiveShape::plane, .width = 8, .depth = 8});
    Material& m = scene.materials[0];
    m.model = MaterialModel::classical;
    m.base_color = {1, 1, 1, 1};
    m.classical.ambient = m.classical.specular = {0, 0, 0};
    for (int i = 0; i < side * side; ++i) {
        Light light;
        light.type = i % 3 == 2 ? LightType::spot : LightType::point;
        light.units = units;
        light.position = {1.3 * (i % side) - 3.25, 0.5, 1.3 * (i / side) - 3.25};
        light.direction = {0, -1, 0};
        light.diffuse = light.color = vec3{color, 0.8f * color, 0.5f * color};
        light.quadratic = 4;
        scene.lights.push_back(light);
    }
    return scene;
}

Frame picture(Scene scene, double cutoff, RenderSettings settings = {}) {
    settings.width = width, settings.height = height;
    if (cutoff > 0) cut_lights(scene.lights, cutoff);
    Context context;
    return render(scene, settings, context);
}

double largest_loss(const Frame& with, const Frame& without) {
    double largest = 0;
    for (std::size_t i = 0; i < with.color.size(); ++i) {
        const vec4 a = without.color[i], b = with.color[i];
        largest = std::max(
            {largest, std::fabs(double(a.x - b.x)), std::fabs(double(a.y - b.y)), std::fabs(double(a.z - b.z))});
    }
    return largest;
}

TEST(LightCutoffPicture, NoPixelOfAWhiteMatteFloorLosesMoreThanTheCutoffOfEachLight) {
    for (const LightUnits units : {LightUnits::classical, LightUnits::photometric})
        for (const float color : {0.2f, 1.0f}) {
            const Scene scene = lit_floor(units, color);
            const Frame without = picture(scene, 0);
            for (const double cutoff : {0.1, 1.0 / 255, 0.0003}) {
                const double loss = largest_loss(picture(scene, cutoff), without);
                EXPECT_LE(loss, side * side * cutoff * (1 + 1e-5)) << cutoff;
                EXPECT_GT(loss, 0) << cutoff << ": lights are cut indeed";
            }
        }
}

TEST(LightCutoffPicture, ItIsLightThatIsLostNowhereGained) {
    const Scene scene = lit_floor(LightUnits::classical, 1);
    const Frame with = picture(scene, 1.0 / 255), without = picture(scene, 0);
    for (std::size_t i = 0; i < with.color.size(); ++i) ASSERT_LE(with.color[i].x, without.color[i].x + 1e-6f);
}

TEST(LightCutoffPicture, LightsThatEndBeforeOrNeverThinOutKeepEveryBit) {
    Scene scene = lit_floor(LightUnits::classical, 1);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (i % 2)
            scene.lights[i].range = 2;
        else
            scene.lights[i].quadratic = 0;
    }
    EXPECT_EQ(picture(scene, 0.1).color, picture(scene, 0).color);
}

TEST(LightCutoffPicture, TheListsOfManyLightsChangeNoBitOfACutPicture) {
    const Scene scene = lit_floor(LightUnits::classical, 1);
    const Frame whole = picture(scene, 0.01);
    const Frame part = picture(scene, 0.01, {.window = {40, 20, 30, 30}});
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 30; ++x)
            ASSERT_EQ(part.color[std::size_t(30 * y + x)], whole.color[std::size_t(width * (y + 20) + x + 40)])
                << x << ' ' << y;
}

}  // namespace
}  // namespace rakelight
