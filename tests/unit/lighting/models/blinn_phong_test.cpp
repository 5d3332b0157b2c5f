// SPDX-License-Identifier: Apache-2.0
// Blinn-Phong against its equation: a value table, energy, reciprocity, the horizon, known albedos.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/lighting/classical_rows.h"

namespace rakelight::lighting_test {
namespace {

TEST(BlinnPhong, GivesTheValuesOfTheTable) { expect_values_of_the_table(blinn_phong); }

TEST(BlinnPhong, AWholeExponentGivesTheLobeOfTheSameExponent) { expect_whole_exponents_to_agree(blinn_phong); }

TEST(BlinnPhong, NormalizedFormReflectsAllAtNormalIncidenceAndNeverMoreThanAll) {
    expect_energy_of_the_normalized_form(blinn_phong);
}

TEST(BlinnPhong, NormalizedFormIsReciprocal) { expect_normalized_form_is_reciprocal(blinn_phong); }

TEST(BlinnPhong, OppositeLightAndViewerHaveNoHalfwayDirection) {
    Items items;
    Item item;
    item.n = {0, 0, 1}, item.l = {1, 0, 0}, item.v = {-1, 0, 0};
    items.push(item);
    EXPECT_EQ(run(scalar::kernel, "blinn_phong_n_dot_h", items)[0][0], 0.0f);
}

TEST(BlinnPhong, AHighlightIsAsWideAsPhongsOfAQuarterOfTheExponentWhereBothAreSteep) {
    // h turns half as fast as r: cos^(4 e)(x / 2) is cos^e(x) to the fourth order in x
    Items narrow, wide;
    for (const double degrees_off : {1.0, 3.0, 6.0}) {
        Item item;
        item.v = to_float(beam(degrees_off));
        item.e = 25;
        wide.push(item);
        item.e = 100;
        narrow.push(item);
    }
    const Results p = terms(scalar::kernel, wide, {phong, textbook, 1}),
                  b = terms(scalar::kernel, narrow, {blinn_phong, textbook, 1});
    for (std::size_t i = 0; i < wide.size(); ++i) EXPECT_NEAR(p[6][i], b[6][i], 1e-3) << i;
}

TEST(BlinnPhong, AtGrazingAnglesAHighlightIsNarrowAcrossAndPhongsIsRound) {
    // l 80 degrees from n; the viewer 10 degrees from the mirrored direction, sideways and upwards
    const double low = radians(80.0), off = radians(10.0);
    Item across, along;
    across.l = along.l = to_float(beam(-80));
    across.v = to_float({std::sin(low) * std::cos(off), std::sin(off), std::cos(low) * std::cos(off)});
    along.v = to_float(beam(70));
    across.e = along.e = 20;
    Items items;
    items.push(across), items.push(along);
    const Results p = terms(scalar::kernel, items, {phong, textbook, 1}),
                  b = terms(scalar::kernel, items, {blinn_phong, textbook, 1});
    EXPECT_NEAR(p[6][0], p[6][1], 1e-5);
    EXPECT_LT(b[6][0], 0.35f * b[6][1]);
}

}  // namespace
}  // namespace rakelight::lighting_test
