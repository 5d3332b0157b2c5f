// SPDX-License-Identifier: Apache-2.0
// Lambert against its equation: a value table, energy, reciprocity, the horizon, the units of lights.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/lighting/classical_rows.h"

namespace rakelight::lighting_test {
namespace {

TEST(Lambert, GivesTheValuesOfTheTable) {
    Items items = items_of_classical_rows();
    const Results results = terms(scalar::kernel, items, {lambert, textbook, 1});
    for (std::size_t i = 0; i < classical_rows().size(); ++i) {
        EXPECT_NEAR(results[3][i], classical_rows()[i].diffuse, 1e-6) << i;
        EXPECT_EQ(results[0][i], 1.0f);  // ambient
        EXPECT_EQ(results[6][i], 0.0f);  // no highlight
    }
}

TEST(Lambert, AWhiteSurfaceFacingAClassicalLightOfColorOneHasRadianceOne) {
    Items items;
    items.push({});
    const Results r = terms(scalar::kernel, items, {lambert, textbook, 1});
    EXPECT_EQ(r[3][0], 1.0f);
    EXPECT_EQ(r[6][0], 0.0f);
    EXPECT_NEAR(run(scalar::kernel, "lambert_brdf", items)[0][0], 1 / pi_d, 2e-8);
}

TEST(Lambert, APhotometricLightGivesRadianceOfBrdfTimesIrradiance) {
    Items items;
    Item item;
    item.p = {0, 0, 1};
    items.push(item);
    lighting::LightParameters light;
    light.kind = lighting::LightKind::point;
    light.is_photometric = true;
    light.position[2] = 3;  // 2 m away
    light.intensity[0] = 400;
    const Results r = terms(scalar::kernel, items, {lambert, textbook, 1}, &light);
    EXPECT_NEAR(r[3][0], 400 / 4.0 / pi_d, 1e-4);
    EXPECT_EQ(r[0][0], 0.0f);  // photometric lights have no ambient color
}

TEST(Lambert, AWhiteSurfaceSendsOutAllOfABeam) {
    const Outgoing out = whole_hemisphere();
    for (const double angle : furnace_degrees)
        EXPECT_NEAR(albedo({lambert, normalized, 1}, beam(angle), out, {}), 1, 2e-4) << angle;
}

TEST(Lambert, LooksTheSameFromEverywhereAndIsDarkWhereTheLightIsBelow) {
    Random random;
    Items items;
    for (int i = 0; i < 2000; ++i) {
        Item item;
        item.l = random.direction(), item.v = random.direction();
        items.push(item);
        item.v = {0, 0, 1};
        items.push(item);
    }
    Items same = items;
    const Results r = terms(scalar::kernel, items, {lambert, textbook, 1});
    const Inputs in = same.inputs();
    for (std::size_t i = 0; i < items.size(); i += 2) {
        ASSERT_EQ(r[3][i], r[3][i + 1]) << i;
        ASSERT_EQ(r[3][i] > 0, in.column[5][i] > 0) << i;  // l.z
    }
}

}  // namespace
}  // namespace rakelight::lighting_test
