// SPDX-License-Identifier: Apache-2.0
// Oren-Nayar against its equation: a value table, Lambert as its limit, the full moon, energy, reciprocity.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/lighting/material_rows.h"

namespace rakelight::lighting_test {
namespace {

TEST(OrenNayar, GivesTheValuesOfTheTable) { expect_values_of_the_table("oren_nayar_brdf", &MaterialRow::oren_nayar); }

TEST(OrenNayar, IsReciprocal) { expect_reciprocal("oren_nayar_brdf"); }

TEST(OrenNayar, WithoutSlopesIsLambertToTheBit) {
    Items items;
    for (MaterialRow row : material_rows()) {
        row.ax = 0;  // sigma
        items.push(item_of(row));
    }
    const Results got = material(scalar::kernel, items, {oren_nayar});
    const Results expected = terms(scalar::kernel, items, {lambert, textbook, 1});
    for (std::size_t i = 0; i < items.size(); ++i) EXPECT_EQ(got[3][i], expected[3][i]) << i;
}

TEST(OrenNayar, IsFlatterThanLambertWithTheLightBehindTheViewer) {
    Items items;
    for (const float x : {0.0f, 0.5f, 0.9f, 0.99f}) {
        Item item;
        item.l = item.v = {x, 0, std::sqrt(1 - x * x)};
        item.s = 0.5f;
        items.push(item);
    }
    const Results r = run(scalar::kernel, "oren_nayar_brdf", items);
    EXPECT_LT(r[0][0], 1 / pi_d);
    for (std::size_t i = 1; i < 4; ++i) EXPECT_GT(r[0][i], r[0][i - 1]) << i;
}

TEST(OrenNayar, ReachesItsPublishedSurplusAndNoMore) {
    const Outgoing out = whole_hemisphere();
    double most = 0;
    for (const double angle : furnace_degrees)
        for (const float sigma : {0.0f, 0.1f, 0.2f, 0.3f, 0.5f, 1.0f}) {
            Item like;
            like.s = sigma;
            const double a = albedo("oren_nayar_brdf", beam(angle), out, like);
            most = std::max(most, a);
            if (sigma == 0) {
                EXPECT_NEAR(a, 1, 2e-4);
            }
        }
    EXPECT_NEAR(most, 1.015, 0.001);  // A + B / 2 at the horizon, greatest at sigma 0.2
}

}  // namespace
}  // namespace rakelight::lighting_test
