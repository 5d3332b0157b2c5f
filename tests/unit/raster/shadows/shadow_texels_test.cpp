// SPDX-License-Identifier: Apache-2.0
// How wide the texels of shadow maps are on the picture, against what the set-up says.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "unit/raster/shadows/shadow_scenes.h"

using namespace rakelight;
using namespace rakelight::test;

namespace {

/// A floor of 8 x 8 m.
Scene floor_under(std::vector<Light> lights) {
    Scene scene;
    scene.materials = {matte()};
    scene.lights = std::move(lights);
    add_square(scene, 4, lying());
    return scene;
}

/// From so far above, with a field of view of 2 m in 10.
Camera from_above(double height) {
    Camera camera = looking({0, height, 0.001}, {0, 0, 0}, 2 * std::atan(0.1));
    camera.z_far = 1000;
    return camera;
}

RenderSettings shadowed(int size) {
    return {.width = 200, .height = 100, .shadows = true, .shadow_size = size, .background = {0, 0, 0, 1}};
}

/// "note: ..." or "warning: ...", the only remark, or nothing.
std::string remark_of(const Scene& scene, const Camera& camera, const RenderSettings& settings, int threads = 1) {
    Context context({.threads = threads});
    auto engine = raster::make_engine();
    engine->prepare(scene, context);
    Frame frame;
    engine->render(camera, settings, frame, context);
    const auto entries = context.report().entries();
    if (entries.empty()) return "";
    EXPECT_EQ(entries.size(), 1u);
    return (entries[0].remark == Remark::warning ? "warning: " : "note: ") + entries[0].message;
}

Light sun() {
    Light light = directional({0, -1, 0});
    light.name = "sun";
    return light;
}

}  // namespace

TEST(ShadowTexels, OfASunAreAsWideAsTheSceneOverTheMapAndSoManyPixelsOfThePicture) {
    // 8 m over 64 texels less a rim of 3 on each side: 0.138 m. A picture from 10 m above has pixels of 2 m / 100.
    EXPECT_EQ(remark_of(floor_under({sun()}), from_above(10), shadowed(64)),
              "note: light 'sun': a texel of its shadow map covers 0.14 m (about 6.9 pixels)");
    // From 5 m they are half as wide.
    EXPECT_EQ(remark_of(floor_under({sun()}), from_above(5), shadowed(64)),
              "warning: light 'sun': a texel of its shadow map covers 0.14 m (about 14 pixels); raise 'shadow-size'");
    EXPECT_EQ(remark_of(floor_under({sun()}), from_above(5), shadowed(256)),
              "note: light 'sun': a texel of its shadow map covers 0.032 m (about 3.2 pixels)");
}

TEST(ShadowTexels, OfALampGrowWithTheDistance) {
    // A face of a cube of maps is 2 m wide a meter away, over 58 texels: 0.138 m at 4 m; pixels of 0.02 m.
    EXPECT_EQ(remark_of(floor_under({lamp({0, 4, 0})}), from_above(10), shadowed(64)),
              "note: light 0: a texel of its shadow map covers 0.14 m (about 6.9 pixels)");
    EXPECT_EQ(remark_of(floor_under({lamp({0, 8, 0})}), from_above(10), shadowed(64)),
              "warning: light 0: a texel of its shadow map covers 0.28 m (about 14 pixels); raise 'shadow-size'");
    Light near_by = lamp({0, 8, 0});
    near_by.range = 7;  // and so lights nothing that is seen
    EXPECT_EQ(remark_of(floor_under({near_by}), from_above(10), shadowed(64)), "");
    // A spot of 2 atan(1/4) over 58 texels is 2 m wide 4 m away.
    EXPECT_EQ(remark_of(floor_under({spot_at({0, 4, 0}, {0, 0, 0}, std::atan(0.25))}), from_above(10), shadowed(64)),
              "note: light 0: a texel of its shadow map covers 0.034 m (about 1.7 pixels)");
}

TEST(ShadowTexels, AreSaidOfTheWidestOnceWhateverTheThreadsAndSamplesAndNotWithoutShadows) {
    const Scene scene = floor_under({lamp({0, 4, 0}), sun(), lamp({0, 8, 0})});
    RenderSettings settings = shadowed(32);
    const std::string expected =
        "warning: light 2: a texel of its shadow map covers 0.62 m (about 31 pixels); raise 'shadow-size'; so with 2 "
        "more";
    EXPECT_EQ(remark_of(scene, from_above(10), settings), expected);
    EXPECT_EQ(remark_of(scene, from_above(10), settings, 3), expected);
    settings.samples = 4;
    EXPECT_EQ(remark_of(scene, from_above(10), settings), expected);
    settings.width = 2000, settings.height = 1000;  // more tiles than are looked at
    EXPECT_NE(remark_of(scene, from_above(10), settings).find("0.62 m (about 308 pixels)"), std::string::npos);
    settings.shadows = false;
    EXPECT_EQ(remark_of(scene, from_above(10), settings), "");
    EXPECT_EQ(remark_of(scene, looking({0, 5, 0}, {0, 10, 0.1}), shadowed(32)), "");  // nothing is seen
}
