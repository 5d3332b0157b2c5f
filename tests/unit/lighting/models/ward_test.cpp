// SPDX-License-Identifier: Apache-2.0
// Ward against its equations: a value table, energy in its three forms, reciprocity, equal widths.
#include <gtest/gtest.h>

#include <cmath>

#include "unit/lighting/material_rows.h"

namespace rakelight::lighting_test {
namespace {

constexpr std::pair<const char*, float MaterialRow::*> forms[] = {{"ward_1992_brdf", &MaterialRow::ward_1992},
                                                                  {"ward_duer_brdf", &MaterialRow::ward_duer},
                                                                  {"ward_bounded_brdf", &MaterialRow::ward_bounded}};

TEST(Ward, GivesTheValuesOfTheTable) {
    for (const auto& [operation, column] : forms) expect_values_of_the_table(operation, column);
}

TEST(Ward, IsReciprocalInAllForms) {
    for (const auto& [operation, column] : forms) expect_reciprocal(operation);
}

TEST(Ward, EqualWidthsAreIsotropic) {
    for (const auto& [operation, column] : forms) expect_equal_widths_to_be_isotropic(operation);
}

TEST(Ward, AWideTangentStretchesTheHighlightAlongIt) {
    for (const auto& [operation, column] : forms) expect_a_wide_tangent_to_stretch(operation);
}

TEST(Ward, BoundedFormStaysWithinItsReflectance) {
    for (const auto& [ax, ay] : {std::pair{0.05, 0.05}, {0.2, 0.2}, {0.6, 0.6}, {0.1, 0.4}, {0.4, 0.1}})
        for (const double angle : furnace_degrees) {
            const Direction l = beam(angle);
            const double a = albedo("ward_bounded_brdf", l, about_the_mirror(l, std::max(ax, ay)), widths(ax, ay));
            EXPECT_LE(a, 1.003) << ax << " " << ay << " at " << angle;
            if (angle == 0 && ax <= 0.05) {
                EXPECT_NEAR(a, 1, 0.01);
            }
        }
}

TEST(Ward, EarlierFormsHaveTheirKnownFaults) {
    const Direction steep = beam(0), grazing = beam(88);
    const Outgoing above = about_the_mirror(steep, 0.2), along = about_the_mirror(grazing, 0.2);
    EXPECT_NEAR(albedo("ward_1992_brdf", steep, above, widths(0.05, 0.05)), 1, 0.02);
    EXPECT_LT(albedo("ward_1992_brdf", grazing, along, widths(0.2, 0.2)), 0.7);  // loses light where it should not
    EXPECT_GT(albedo("ward_duer_brdf", grazing, along, widths(0.2, 0.2)), 1.2);  // makes light
}

TEST(Ward, HasTheAlbedosThatTheDocumentationShows) {
    // docs/lighting/ward.md: alphas of 0.2, by quadrature in double
    const double angles[] = {0, 30, 60, 75, 85, 88, 89.5, 89.9};
    const double shown[3][8] = {{0.90, 0.78, 0.46, 0.27, 0.18, 0.20, 0.32, 0.67},
                                {0.93, 0.93, 0.92, 0.89, 1.13, 1.95, 6.26, 29.4},
                                {0.96, 0.95, 0.90, 0.82, 0.81, 0.86, 0.93, 0.98}};
    for (std::size_t a = 0; a < 8; ++a) {
        const Direction l = beam(angles[a]);
        const Outgoing out = about_the_mirror(l, 0.2);
        for (std::size_t f = 0; f < 3; ++f)
            EXPECT_NEAR(albedo(forms[f].first, l, out, widths(0.2, 0.2)), shown[f][a], 0.006 + 0.01 * shown[f][a])
                << forms[f].first << " at " << angles[a];
    }
}

}  // namespace
}  // namespace rakelight::lighting_test
