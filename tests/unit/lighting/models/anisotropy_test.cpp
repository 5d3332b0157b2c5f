// SPDX-License-Identifier: Apache-2.0
// The anisotropic GGX lobe of KHR_materials_anisotropy: a value table, equal widths, energy, reciprocity.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/lighting/material_rows.h"

namespace rakelight::lighting_test {
namespace {

TEST(Anisotropy, GivesTheValuesOfTheTable) {
    expect_values_of_the_table("ggx_anisotropic_brdf", &MaterialRow::ggx_anisotropic);
}

TEST(Anisotropy, IsReciprocal) { expect_reciprocal("ggx_anisotropic_brdf"); }

TEST(Anisotropy, AWideTangentStretchesTheHighlightAlongIt) { expect_a_wide_tangent_to_stretch("ggx_anisotropic_brdf"); }

TEST(Anisotropy, EqualWidthsAreTheIsotropicLobe) {
    expect_equal_widths_to_be_isotropic("ggx_anisotropic_brdf");
    Items items;
    for (const MaterialRow& row : material_rows()) {
        Item item = item_of(row);
        item.ka.y = item.ka.x;
        items.push(item);
    }
    const Results plain = run(scalar::kernel, "ggx_brdf", items),
                  general = run(scalar::kernel, "ggx_anisotropic_brdf", items);
    for (std::size_t i = 0; i < items.size(); ++i)
        EXPECT_NEAR(plain[0][i], general[0][i], 2e-6 + 3e-5 * double(plain[0][i])) << i;
}

TEST(Anisotropy, StaysWithinOne) {
    for (const auto& [ax, ay] : {std::pair{0.5, 0.1}, {0.1, 0.5}, {1.0, 0.05}, {0.05, 1.0}})
        for (const double angle : furnace_degrees) {
            const Direction l = beam(angle);
            const double share =
                albedo("ggx_anisotropic_brdf", l, about_the_mirror(l, std::max(ax, ay)), widths(ax, ay));
            EXPECT_LE(share, 1.003) << ax << " " << ay << " at " << angle;
        }
}

}  // namespace
}  // namespace rakelight::lighting_test
