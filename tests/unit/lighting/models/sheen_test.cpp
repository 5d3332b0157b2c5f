// SPDX-License-Identifier: Apache-2.0
// Sheen against KHR_materials_sheen: a value table, the table of albedos, what it leaves, reciprocity.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/lighting/albedo_reads.h"
#include "unit/lighting/material_rows.h"

namespace rakelight::lighting_test {
namespace {

TEST(Sheen, GivesTheValuesOfTheTable) { expect_values_of_the_table("sheen_brdf", &MaterialRow::sheen); }

TEST(Sheen, IsReciprocal) { expect_reciprocal("sheen_brdf"); }

TEST(Sheen, DarkensTheMaterialBelowByItsAlbedo) {
    Items items;
    Item item;
    item.l = {0.6f, 0, 0.8f}, item.v = {-0.6f, 0, 0.8f};
    item.ks = {0.2f, 0.5f, 0}, item.kd = {1, 1, 1}, item.ka = {0.3f, 0.4f, 0}, item.e = item.t = 0.5f;
    items.push(item);
    const Results bare = material(scalar::kernel, items, {pbr}),
                  under = material(scalar::kernel, items, {pbr, 2, 0, 0, 1});
    EXPECT_NEAR(under[3][0], (1 - 0.5f * 0.4f) * bare[3][0], 1e-6);  // the greater albedo, the greatest component
}

TEST(Sheen, TheTableHoldsItsAlbedo) {
    const Outgoing out = whole_hemisphere();
    const lighting::AlbedoTables t = lighting::albedo_tables();
    for (const int row : {5, 10, 15}) {
        const double roughness = double(row) / (lighting::sheen_rows - 1);
        for (const int column : {8, 16, 24, 31}) {
            const double x = double(column) / (lighting::albedo_columns - 1), c = x * x;
            const double expected =
                albedo("sheen_brdf", {std::sqrt(1 - c * c), 0, c}, out, widths(roughness * roughness, 1));
            EXPECT_NEAR(double(t.sheen[row * lighting::albedo_columns + column]), expected, 0.003)
                << row << " " << column;
        }
    }
}

TEST(Sheen, IsBrighterAtTheRimThanInTheMiddle) {
    Items items;
    for (const double angle : {0.0, 45.0, 80.0}) {
        Item item = widths(0.16, 0);
        item.l = item.v = to_float(beam(angle));
        items.push(item);
    }
    const Results r = run(scalar::kernel, "sheen_brdf", items);
    EXPECT_GT(r[0][1], 2 * r[0][0]);
    EXPECT_GT(r[0][2], 2 * r[0][1]);
}

}  // namespace
}  // namespace rakelight::lighting_test
