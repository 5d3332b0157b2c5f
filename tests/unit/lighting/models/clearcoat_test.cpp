// SPDX-License-Identifier: Apache-2.0
// Clearcoat against KHR_materials_clearcoat: what the coat reflects, what it leaves, energy.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/lighting/material_rows.h"

namespace rakelight::lighting_test {
namespace {

TEST(Clearcoat, TakesWhatItReflectsFromTheMaterialBelow) {
    Items items;
    Item item;
    item.ks = {0.04f, 0.04f, 0.04f}, item.kd = {0.5f, 0.5f, 0.5f}, item.ka = {1, 0, 0}, item.e = 0.5f, item.t = 0.5f;
    items.push(item);
    const Results bare = material(scalar::kernel, items, {pbr}),
                  coated = material(scalar::kernel, items, {pbr, 2, 0, 0, 0, 1});
    EXPECT_NEAR(coated[3][0], 0.96f * bare[3][0], 1e-6);
    EXPECT_NEAR(coated[6][0], 0.96f * bare[6][0] + 0.04f / (4 * 0.25f), 1e-6);  // the coat's own lobe, as wide
}

TEST(Clearcoat, ReflectsFourPercentFromAboveAndAllAtTheHorizon) {
    Items items;
    for (const float c : {1.0f, 0.5f, 0.0f, -0.5f}) {
        Item item;
        item.ka = {0.5f, 0, 0}, item.s = c;  // half a coat
        items.push(item);
    }
    const Results r = run(scalar::kernel, "coat_reflectance", items);
    EXPECT_NEAR(r[0][0], 0.5 * 0.04, 1e-7);
    EXPECT_NEAR(r[0][1], 0.5 * (0.04 + 0.96 / 32), 1e-7);
    EXPECT_NEAR(r[0][2], 0.5, 1e-7);
    EXPECT_EQ(r[0][3], r[0][1]);
}

TEST(Clearcoat, HasAHighlightOfItsOwnBesideThatOfTheMaterialBelow) {
    // the base is wide (alpha 0.6), the coat narrow (0.05): 45 degrees off the mirror only the base is left
    Items items;
    for (const double off : {0.0, 45.0}) {
        Item item;
        item.l = to_float(beam(-10));
        item.v = to_float(beam(10 + off));
        item.ks = {0.3f, 0.3f, 0.3f}, item.ka = {1, 0, 0}, item.e = 0.6f, item.t = 0.05f;
        items.push(item);
    }
    // alpha_x is the base's, alpha_y the coat's
    const Results bare = material(scalar::kernel, items, {pbr}),
                  coated = material(scalar::kernel, items, {pbr, 2, 0, 0, 0, 1});
    EXPECT_GT(coated[6][0], 10 * bare[6][0]);
    EXPECT_NEAR(coated[6][1] / bare[6][1], 1 - 0.04 - 0.96 * std::pow(1 - std::cos(radians(55.0)), 5), 0.02);
}

TEST(Clearcoat, OverAWhiteSurfaceNoMoreLeavesThanComes) {
    const Outgoing out = whole_hemisphere();
    for (const double angle : furnace_degrees) {
        Item like;
        like.v = to_float(beam(angle)), like.p = {1, 0, 0};
        like.ks = {0, 0, 0}, like.ka = {1, 0, 0}, like.e = like.t = 0.4f;
        Items items;
        for (const Direction& l : out.v) {
            like.l = to_float(l);
            items.push(like);
        }
        const Results r = material(scalar::kernel, items, {pbr, 2, 0, 0, 0, 1});
        double share = 0;  // radiance for irradiance pi cos l
        for (std::size_t i = 0; i < out.v.size(); ++i) share += double(r[3][i] + r[6][i]) / pi_d * out.solid_angle[i];
        EXPECT_LE(share, 1.002) << angle;
        EXPECT_GE(share, 0.3) << angle;
    }
}

}  // namespace
}  // namespace rakelight::lighting_test
