// SPDX-License-Identifier: Apache-2.0
#include "shading/lights/mean_map.h"

#include <gtest/gtest.h>

#include <cstring>

#include "support/scene_builder.h"

namespace rakelight::shading {
namespace {

/// 64 x 64: white in the columns of `first` .. `last`, black elsewhere.
MeanMap bars(int first, int last) {
    Context context({.threads = 1});
    return MeanMap(make_mip_chain(test::rgb_pixels(64, 64,
                                                   [=](int x, int) {
                                                       const int c = x >= first && x <= last ? 255 : 0;
                                                       return std::array{c, c, c};
                                                   }),
                                  ColorSpace::srgb, context));
}

double green(const MeanMap& map, vec2 low, vec2 high, Wrap wrap = Wrap::repeat) {
    return map.mean({low, high}, wrap, wrap).y;
}

TEST(MeanMap, GivesTheMeanOfWhatTheBoxTouches) {
    const MeanMap map = bars(32, 63);
    EXPECT_NEAR(green(map, {0, 0}, {1, 1}), 0.5, 1e-9);
    EXPECT_NEAR(green(map, {0.6f, 0.1f}, {0.9f, 0.3f}), 1, 1e-9);
    EXPECT_EQ(green(map, {0.1f, 0.1f}, {0.4f, 0.9f}), 0) << "it is black there";
    EXPECT_NEAR(green(map, {0.25f, 0.5f}, {0.75f, 0.5f}), 0.5, 0.05);
}

TEST(MeanMap, ABoxBesideLightGetsSomeForBilinearSampling) {
    const MeanMap map = bars(32, 63);
    EXPECT_GT(green(map, {0.3f, 0.1f}, {0.495f, 0.2f}), 0);
    EXPECT_GT(green(bars(0, 31), {0.505f, 0.1f}, {0.7f, 0.2f}), 0);
}

TEST(MeanMap, UndoesWrapsAsSamplersDo) {
    const MeanMap map = bars(48, 63);
    EXPECT_NEAR(green(map, {3.8f, -6.5f}, {3.9f, -6.4f}), 1, 1e-9);
    EXPECT_EQ(green(map, {-0.9f, 0}, {-0.6f, 1}), 0);
    EXPECT_EQ(green(map, {-0.2f, 0}, {-0.1f, 0.5f}, Wrap::mirrored_repeat), 0) << "0.1 to 0.2";
    EXPECT_NEAR(green(map, {-0.9f, 0}, {-0.8f, 0.5f}, Wrap::mirrored_repeat), 1, 1e-9) << "0.8 to 0.9";
    EXPECT_NEAR(green(map, {5, 2}, {7, 3}, Wrap::clamp_to_edge), 0.25, 1e-9) << "all of it for wide boxes";
    EXPECT_NEAR(green(map, {5, 2}, {5.5f, 2.5f}, Wrap::clamp_to_edge), 1, 1e-9);
    EXPECT_NEAR(green(map, {0.95f, 0}, {1.05f, 0.1f}), 0.25, 1e-9) << "all of an axis across its seam";
}

TEST(MeanMap, CoordinatesThatAreNoNumbersTouchEverything) {
    const MeanMap map = bars(48, 63);
    const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
    EXPECT_NEAR(green(map, {nan, nan}, {nan, nan}), 0.25, 1e-9);
    EXPECT_NEAR(green(map, {-infinity, -infinity}, {infinity, infinity}), 0.25, 1e-9);
    EXPECT_NEAR(green(map, {infinity, 0}, {infinity, 1}), 0.25, 1e-9);
}

TEST(MeanMap, LightThatIsSmallBesideTheRestIsStillSomeLight) {
    Context context({.threads = 1});
    Pixels pixels{.width = 32, .height = 1, .channels = 3, .component = Component::f32, .is_linear = true};
    std::vector<float> values(32 * 3, 1e-9f);
    values[0] = values[1] = values[2] = 60000.0f;
    pixels.bytes.resize(values.size() * sizeof(float));
    std::memcpy(pixels.bytes.data(), values.data(), pixels.bytes.size());
    const MeanMap map(make_mip_chain(pixels, ColorSpace::srgb, context));
    EXPECT_NEAR(green(map, {0.5f, 0}, {0.6f, 1}), 60000.0 / 32 / 4096, 1e-6);
    EXPECT_NEAR(green(map, {0, 0}, {0, 1}), 30000, 1e-3) << "its own cell and the one beside it";
}

}  // namespace
}  // namespace rakelight::shading
