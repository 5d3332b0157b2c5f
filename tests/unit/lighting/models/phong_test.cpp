// SPDX-License-Identifier: Apache-2.0
// Phong against its equation: a value table, energy, reciprocity, the horizon, known albedos.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/lighting/classical_rows.h"

namespace rakelight::lighting_test {
namespace {

/// Of exponent 1.
double textbook_albedo(double degrees_in) {
    static const Outgoing out = whole_hemisphere();
    return albedo({phong, textbook, 1}, beam(degrees_in), out, {});
}

TEST(Phong, GivesTheValuesOfTheTable) { expect_values_of_the_table(phong); }

TEST(Phong, AWholeExponentGivesTheLobeOfTheSameExponent) { expect_whole_exponents_to_agree(phong); }

TEST(Phong, NormalizedFormReflectsAllAtNormalIncidenceAndNeverMoreThanAll) {
    expect_energy_of_the_normalized_form(phong);
}

TEST(Phong, NormalizedFormIsReciprocal) { expect_normalized_form_is_reciprocal(phong); }

TEST(Phong, TextbookFormHasTheKnownAlbedos) {
    // Exponent 1: (2/3) ((pi - t) cos t + sin t) / (pi cos t): 2/3 at normal incidence, 1.18 at 75 degrees: not energy
    // conserving.
    for (const double degrees_in : {0.0, 30.0, 60.0, 75.0}) {
        const double t = radians(degrees_in);
        const double expected = 2.0 / 3 * ((pi_d - t) * std::cos(t) + std::sin(t)) / (pi_d * std::cos(t));
        EXPECT_NEAR(textbook_albedo(degrees_in), expected, 2e-3) << degrees_in;
    }
    EXPECT_NEAR(textbook_albedo(0), 0.667, 1e-3);
    EXPECT_NEAR(textbook_albedo(75), 1.18, 0.005);
}

}  // namespace
}  // namespace rakelight::lighting_test
