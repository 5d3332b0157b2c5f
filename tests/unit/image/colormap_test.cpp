// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include <rakelight/image/colormap.h>

#include "math/color.h"

namespace rakelight {
namespace {

vec3 codes(vec3 linear) {
    return {float(srgb8_from_linear(linear.x)), float(srgb8_from_linear(linear.y)), float(srgb8_from_linear(linear.z))};
}

TEST(ColorMap, EndsAndMiddlesAreThePublishedColors) {
    EXPECT_EQ(codes(color_of(ColorMap::viridis, 0)), (vec3{0x44, 0x01, 0x54}));
    EXPECT_EQ(codes(color_of(ColorMap::viridis, 1)), (vec3{0xfd, 0xe7, 0x25}));
    EXPECT_EQ(codes(color_of(ColorMap::coolwarm, 0)), (vec3{0x3b, 0x4c, 0xc0}));
    EXPECT_EQ(codes(color_of(ColorMap::coolwarm, 0.5)), (vec3{0xdd, 0xdd, 0xdd}));
    EXPECT_EQ(codes(color_of(ColorMap::gray, 0.2)), (vec3{51, 51, 51}));
    EXPECT_EQ(codes(color_of(ColorMap::plasma, 1)), (vec3{0xf0, 0xf9, 0x21}));
}

TEST(ColorMap, OutsideIsClampedAndNanIsGray) {
    for (const ColorMap map : {ColorMap::viridis, ColorMap::magma, ColorMap::inferno, ColorMap::plasma, ColorMap::turbo,
                               ColorMap::coolwarm, ColorMap::gray}) {
        EXPECT_EQ(color_of(map, -7), color_of(map, 0));
        EXPECT_EQ(color_of(map, 1e30), color_of(map, 1));
        EXPECT_EQ(codes(color_of(map, std::numeric_limits<double>::quiet_NaN())), (vec3{128, 128, 128}));
    }
}

TEST(ColorMap, TheSequentialOnesGrowLighter) {
    for (const ColorMap map : {ColorMap::viridis, ColorMap::magma, ColorMap::inferno, ColorMap::plasma, ColorMap::gray})
        for (int i = 0; i < 100; ++i) {
            const auto light = [&](double t) {
                const vec3 c = color_of(map, t);
                return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
            };
            EXPECT_LT(light(i / 100.0), light((i + 1) / 100.0)) << i;
        }
}

}  // namespace
}  // namespace rakelight
