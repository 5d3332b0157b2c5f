// SPDX-License-Identifier: Apache-2.0
#include "image/maps/green_direction.h"

#include <gtest/gtest.h>

#include "unit/image/generated_normal_maps.h"

namespace rakelight::test {
namespace {

GreenDirection direction_of(const NormalCodes& map) {
    return find_green_direction(map.texels, map.size, map.size, map.size);
}

TEST(GreenDirection, BumpsAreToldApartWithEveryPart) {
    const NormalCodes bumps = codes_of("bumps", 64, [](int x, int y) {
        const double a = 2 * pi * 8 * (x + 0.5) / 64, b = 2 * pi * 8 * (y + 0.5) / 64;
        return TexelSlope{0.4 * std::cos(a) * std::sin(b), -0.4 * std::sin(a) * std::cos(b)};
    });
    const GreenDirection up = direction_of(bumps), down = direction_of(turned_green(bumps));
    EXPECT_GT(up.fine, 0.95);
    EXPECT_LT(down.fine, -0.95);
    EXPECT_EQ(up.up, 64);
    EXPECT_EQ(down.down, 64);
    EXPECT_TRUE(up.is_up() && !up.is_down());
    EXPECT_TRUE(down.is_down() && !down.is_up());
}

/// Of every map and of the same with green turned round: what is said is right, and of most it is said.
TEST(GreenDirection, NoGuessIsWrongOverGeneratedMaps) {
    int fields = 0, said = 0;
    for (const NormalCodes& map : generated_normal_maps()) {
        const GreenDirection as_is = direction_of(map), turned = direction_of(turned_green(map));
        EXPECT_FALSE(as_is.is_down()) << map.name;
        EXPECT_FALSE(turned.is_up()) << map.name;
        EXPECT_EQ(as_is.is_up(), turned.is_down()) << map.name;
        if (!map.is_field) {
            EXPECT_FALSE(as_is.is_up()) << map.name << ": nobody can know";
            continue;
        }
        ++fields;
        said += turned.is_down();
    }
    RecordProperty("fields", fields);
    RecordProperty("said", said);
    EXPECT_EQ(fields, 144);
    EXPECT_GE(said, 80) << "docs/bump.md says how many";
}

TEST(GreenDirection, RoundingBesideLargeSlopesSaysNothing) {
    // Slopes along u alone that change from row to row: dq/dx is rounding, and a correlation with it is chance.
    for (int seed = 0; seed < 20; ++seed) {
        const NormalCodes map = codes_of("rows", 128, [seed](int x, int y) {
            return TexelSlope{4 * noise_at(x / 16, y / 8, seed) - 2, 0.03 * noise_at(x / 16, y / 8, seed) + 1};
        });
        EXPECT_FALSE(direction_of(map).is_up()) << seed;
        EXPECT_FALSE(direction_of(map).is_down()) << seed;
    }
}

TEST(GreenDirection, FlatAndSmallMapsAndOneCornerOfReliefSayNothing) {
    const auto slope = [](int x, int y) {
        return TexelSlope{0.5 * std::sin(0.7 * (x + y)), -0.5 * std::sin(0.7 * (x + y))};
    };
    EXPECT_EQ(direction_of(codes_of("flat", 64, [](int, int) { return TexelSlope{}; })).parts, 0);
    EXPECT_EQ(direction_of(codes_of("small", 31, slope)).parts, 0);
    const GreenDirection corner = direction_of(
        codes_of("corner", 256, [&](int x, int y) { return x < 60 && y < 60 ? slope(x, y) : TexelSlope{}; }));
    EXPECT_GT(std::abs(corner.fine), 0.9);
    EXPECT_LT(corner.parts, 8);
    EXPECT_FALSE(corner.is_up() || corner.is_down());
}

}  // namespace
}  // namespace rakelight::test
